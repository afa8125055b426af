// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/image/read_image.h"

#include "core/io/image/decode_image.h"
#include "core/io/image/image_kind.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <string>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace trixel {

namespace {

namespace fs = std::filesystem;

struct OpenedImage
{
    Descriptor file;
    std::uint64_t bytes = 0;
    ImageKind kind = ImageKind::Png;
};

tl::unexpected<Error> failed(const fs::path& path, const std::string& why)
{
    return pathError(path.string() + ": " + why);
}

tl::unexpected<Error> inFile(const fs::path& path, const Error& error)
{
    return error.kind == ErrorKind::Contents ? prefixed(path.string(), error)
                                             : tl::unexpected(error);
}

Result<std::uint64_t> regularSize(const Descriptor& file, const fs::path& path)
{
    struct stat status
    {
    };
    if (::fstat(file.get(), &status) != 0) {
        return failed(path, std::string("cannot be read: ") + std::strerror(errno));
    }
    if (!S_ISREG(status.st_mode)) {
        return failed(
            path, S_ISDIR(status.st_mode) ? "is a directory, not a file" : "is not a regular file");
    }
    return static_cast<std::uint64_t>(status.st_size);
}

Result<OpenedImage> open(const fs::path& path)
{
    // Without waiting: a pipe of that name would never begin.
    OpenedImage opened{Descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)), 0, {}};
    if (!opened.file.isOpen()) {
        return failed(path,
                      errno == ENOENT ? "there is no such file"
                                      : std::string("cannot be read: ") + std::strerror(errno));
    }
    const auto size = regularSize(opened.file, path);
    if (!size) {
        return tl::unexpected(size.error());
    }
    opened.bytes = *size;
    if (opened.bytes == 0) {
        return contentsError(path.string() + ": the file is empty");
    }
    std::array<std::byte, 64> begin{};
    const ssize_t got = ::pread(opened.file.get(), begin.data(), begin.size(), 0);
    if (got < 0) {
        return failed(path, std::string("cannot be read: ") + std::strerror(errno));
    }
    const auto kind = imageKindOf(std::span(begin).first(static_cast<std::size_t>(got)));
    if (!kind) {
        return contentsError(path.string() +
                             ": expected an image (PNG, JPEG, TIFF, OpenEXR, HDR, TGA, BMP or "
                             "WebP), found none of their marks at its beginning");
    }
    opened.kind = *kind;
    return opened;
}

/// What the decoder says of its pixels, which it may not have been itself when it said so.
Result<DecodedImage> factsOf(const nlohmann::json& answer, const ImageLimits& limits)
{
    const auto bad = [] { return contentsError("it is damaged: its decoder answers nonsense"); };
    const auto whole = [&](const char* key) {
        const auto at = answer.find(key);
        return at != answer.end() && at->is_number_integer() ? at->get<std::int64_t>() : -2;
    };
    const auto text = [&](const char* key) {
        const auto at = answer.find(key);
        return at != answer.end() && at->is_string() ? at->get<std::string>() : std::string();
    };
    const std::int64_t width = whole("width");
    const std::int64_t height = whole("height");
    const std::int64_t channels = whole("channels");
    const std::int64_t alpha = whole("alpha");
    const auto type = texelTypeFromName(text("type"));
    if (width < 1 || width > limits.mostPixelsAcross || height < 1 ||
        height > limits.mostPixelsAcross || channels < 1 || channels > limits.mostChannels ||
        alpha < -1 || alpha >= channels || !type) {
        return bad();
    }
    DecodedImage facts{static_cast<int>(width),
                       static_cast<int>(height),
                       {*type, static_cast<std::uint16_t>(channels), std::nullopt},
                       {},
                       {}};
    if (alpha >= 0) {
        facts.format.alpha = static_cast<std::uint16_t>(alpha);
    }
    // A declaration that does not fit comes from the file, not from the decoder.
    const auto colors = colorSpacesFromText(text("colors"));
    facts.colors =
        colors && colors->size() == facts.format.channels ? *colors : usualColors(facts.format);
    return facts;
}

std::uint64_t pixelBytes(const TexelFormat& format, int width, int height)
{
    return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) *
           format.texelBytes();
}

Result<DecodedImage> decoded(const ImageWorker& worker,
                             const OpenedImage& opened,
                             const DecodeOptions& options,
                             Progress& progress,
                             const ImageLimits& limits)
{
    const auto memory = makeJobMemory(0);
    if (!memory) {
        return tl::unexpected(memory.error());
    }
    const nlohmann::json job{{"work", "decode"},
                             {"reader", readerOf(opened.kind)},
                             {"fileBytes", opened.bytes},
                             {"coarserLevels", options.coarserLevels},
                             {"keepsAlpha", options.keepsAlpha}};
    const auto answer = worker.run(job, opened.file, *memory, limits, progress);
    if (!answer) {
        return tl::unexpected(answer.error());
    }
    auto image = factsOf(*answer, limits);
    if (!image) {
        return image;
    }
    std::uint64_t bytes = pixelBytes(image->format, image->width, image->height);
    for (const auto& [width, height] : options.coarserLevels) {
        bytes += pixelBytes(image->format, width, height);
    }
    auto pixels = mapSealed(*memory, bytes);
    if (!pixels) {
        return tl::unexpected(pixels.error());
    }
    image->pixels = std::move(*pixels);
    return image;
}

} // namespace

Result<DecodedImage> decodeImageFile(const ImageWorker& worker,
                                     const fs::path& path,
                                     const DecodeOptions& options,
                                     Progress& progress,
                                     const ImageLimits& limits)
{
    const auto opened = open(path);
    if (!opened) {
        return tl::unexpected(opened.error());
    }
    auto image = decoded(worker, *opened, options, progress, limits);
    return image ? std::move(image) : inFile(path, image.error());
}

Result<Image> readImage(const ImageWorker& worker,
                        const fs::path& path,
                        Progress& progress,
                        const ImageLimits& limits)
{
    auto image = decodeImageFile(worker, path, {}, progress, limits);
    if (!image) {
        return tl::unexpected(image.error());
    }
    return Image::adopt(image->width,
                        image->height,
                        image->format,
                        std::move(image->colors),
                        std::move(image->pixels));
}

} // namespace trixel
