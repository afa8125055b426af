// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/image/worker/jpeg_end.h"

#include <algorithm>
#include <iterator>

namespace trixel::worker {

namespace {

unsigned byteAt(std::span<const std::byte> bytes, std::size_t at)
{
    return at < bytes.size() ? std::to_integer<unsigned>(bytes[at]) : 0U;
}

/// Where the compressed pixels begin: after the segment "start of scan".
std::size_t scanOf(std::span<const std::byte> file)
{
    std::size_t at = 2;
    while (at + 4 <= file.size() && byteAt(file, at) == 0xFF) {
        const unsigned marker = byteAt(file, at + 1);
        if (marker == 0xFF) {
            ++at; // padding
            continue;
        }
        at += 2 + (byteAt(file, at + 2) << 8U | byteAt(file, at + 3));
        if (marker == 0xDA) {
            return std::min(at, file.size());
        }
    }
    return file.size();
}

} // namespace

bool hasJpegEnd(std::span<const std::byte> file)
{
    const auto scan = file.subspan(scanOf(file));
    constexpr std::byte kEnd[] = {std::byte{0xFF}, std::byte{0xD9}};
    return std::search(scan.begin(), scan.end(), std::begin(kEnd), std::end(kEnd)) != scan.end();
}

} // namespace trixel::worker
