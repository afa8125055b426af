// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/image/image_kind.h"

#include <algorithm>
#include <cstdint>

namespace trixel {

namespace {

using namespace std::string_view_literals;

unsigned byteAt(std::span<const std::byte> bytes, std::size_t at)
{
    return at < bytes.size() ? std::to_integer<unsigned>(bytes[at]) : 0U;
}

/// A TGA header: no colour map or one of whole bytes, an image type there is, and a size.
bool looksLikeTga(std::span<const std::byte> b)
{
    if (b.size() < 18) {
        return false;
    }
    const unsigned map = byteAt(b, 1);
    const unsigned type = byteAt(b, 2);
    const unsigned depth = byteAt(b, 16);
    const bool knownType =
        type == 1 || type == 2 || type == 3 || type == 9 || type == 10 || type == 11;
    const bool knownDepth = depth == 8 || depth == 15 || depth == 16 || depth == 24 || depth == 32;
    const bool hasSize = byteAt(b, 12) + byteAt(b, 13) > 0 && byteAt(b, 14) + byteAt(b, 15) > 0;
    return map <= 1 && (map == 1) == (type == 1 || type == 9) && knownType && knownDepth &&
           hasSize && (byteAt(b, 17) & 0xC0U) == 0;
}

} // namespace

std::string_view nameOf(ImageKind kind)
{
    constexpr std::string_view kNames[] = {
        "PNG", "JPEG", "TIFF", "OpenEXR", "HDR", "TGA", "BMP", "WebP"};
    return kNames[static_cast<std::size_t>(kind)];
}

std::string_view readerOf(ImageKind kind)
{
    constexpr std::string_view kReaders[] = {
        "png", "jpeg", "tiff", "openexr", "hdr", "targa", "bmp", "webp"};
    return kReaders[static_cast<std::size_t>(kind)];
}

std::optional<ImageKind> imageKindOf(std::span<const std::byte> begin)
{
    const std::string_view text(reinterpret_cast<const char*>(begin.data()), begin.size());
    if (text.starts_with("\x89PNG\r\n\x1A\n")) {
        return ImageKind::Png;
    }
    if (text.starts_with("\xFF\xD8\xFF")) {
        return ImageKind::Jpeg;
    }
    for (const std::string_view tiff : {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv}) {
        if (text.starts_with(tiff)) {
            return ImageKind::Tiff;
        }
    }
    if (text.starts_with("\x76\x2F\x31\x01")) {
        return ImageKind::OpenExr;
    }
    if (text.starts_with("#?RADIANCE") || text.starts_with("#?RGBE")) {
        return ImageKind::Hdr;
    }
    if (text.starts_with("BM")) {
        return ImageKind::Bmp;
    }
    if (text.starts_with("RIFF") && text.size() >= 12 && text.substr(8, 4) == "WEBP") {
        return ImageKind::WebP;
    }
    return looksLikeTga(begin) ? std::optional(ImageKind::Tga) : std::nullopt;
}

} // namespace trixel
