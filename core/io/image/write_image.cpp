// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/image/write_image.h"

#include "core/base/check.h"
#include "core/io/commit_file.h"
#include "core/io/image/decode_image.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>

namespace trixel {

namespace {

namespace fs = std::filesystem;

enum class Container { Png, Tiff, OpenExr };

std::string endingOf(const fs::path& path)
{
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) {
        return static_cast<char>(std::tolower(c));
    });
    return ending;
}

std::optional<Container> containerOf(const fs::path& path, TexelType type)
{
    const std::string ending = endingOf(path);
    if (ending == ".png") {
        return Container::Png;
    }
    if (ending == ".tif" || ending == ".tiff") {
        return Container::Tiff;
    }
    if (ending == ".exr") {
        return Container::OpenExr;
    }
    if (ending == ".tx") {
        return type == TexelType::Half ? Container::OpenExr : Container::Tiff;
    }
    return std::nullopt;
}

const char* writerOf(Container container)
{
    return container == Container::Png ? "png" : container == Container::Tiff ? "tiff" : "openexr";
}

/// Whether opacity lies where other programs look for it: behind one colour or three.
bool hasUsualOpacity(const TexelFormat& format)
{
    return format.alpha && ((*format.alpha == 1 && format.channels == 2) || *format.alpha == 3);
}

/// OpenEXR sorts channels by name, and OpenImageIO puts R, G, B and A first when it reads them: all
/// others are named so that they stay in their order, as is everything where opacity lies
/// elsewhere.
std::vector<std::string> namesOf(const TexelFormat& format)
{
    static_assert(TexelFormat::kMaxChannels <= 9999, "four digits sort as the numbers do");
    const auto plain = [](std::uint16_t c) {
        const std::string number = std::to_string(c);
        return "channel" + std::string(4 - number.size(), '0') + number;
    };
    std::vector<std::string> names;
    const bool isPlain = format.alpha && !hasUsualOpacity(format);
    const bool isGrey = format.channels - (format.alpha ? 1 : 0) == 1;
    for (std::uint16_t c = 0; c < format.channels; ++c) {
        names.push_back(isPlain             ? plain(c)
                        : format.alpha == c ? "A"
                        : isGrey            ? "Y"
                        : c < 3             ? std::string(1, "RGB"[c])
                                            : plain(c));
    }
    return names;
}

/// Colours times opacity, in float and rounded once.
void multiplyByAlpha(const TexelFormat& format, std::span<std::byte> pixels)
{
    constexpr std::size_t kRun = 1024;
    const std::size_t channels = format.channels;
    std::vector<float> values(kRun * channels);
    while (!pixels.empty()) {
        const auto run = pixels.first(std::min(pixels.size(), kRun * format.texelBytes()));
        const std::size_t texels = run.size() / format.texelBytes();
        const auto part = std::span(values).first(texels * channels);
        decode(format.type, run, part);
        for (std::size_t k = 0; k < texels; ++k) {
            const float alpha = part[k * channels + *format.alpha];
            for (std::size_t c = 0; c < channels; ++c) {
                part[k * channels + c] *= c == *format.alpha ? 1.0F : alpha;
            }
        }
        encode(format.type, part, run);
        pixels = pixels.subspan(run.size());
    }
}

bool multiplies(Container container, const Image& image, const ImageWriteOptions& options)
{
    return container == Container::OpenExr && hasUsualOpacity(image.format()) &&
           options.multipliesByAlpha;
}

nlohmann::json
jobOf(std::span<const Image> levels, Container container, const ImageWriteOptions& options)
{
    const Image& image = levels.front();
    nlohmann::json sizes = nlohmann::json::array();
    for (const Image& level : levels) {
        sizes.push_back({level.width(), level.height()});
    }
    return {
        {"work", "encode"},
        {"writer", writerOf(container)},
        {"levels", sizes},
        {"type", nameOf(image.format().type)},
        {"channels", image.format().channels},
        {"alpha", hasUsualOpacity(image.format()) ? static_cast<int>(*image.format().alpha) : -1},
        {"names", namesOf(image.format())},
        {"colors", toText(image.colors())},
        {"multiplied", multiplies(container, image, options)},
        {"tile", levels.size() > 1 ? options.tile : 0},
        {"texture", levels.size() > 1},
        {"wrap", options.wrap + "," + options.wrap},
        {"compression", "zip"},
        {"effort", options.effort},
        {"threads", static_cast<int>(options.threads.count)}};
}

/// All levels one after the other, as the file is to hold them.
struct Payload
{
    Descriptor memory;
    std::shared_ptr<std::byte> bytes;
    std::uint64_t size = 0;
};

Result<Payload> payloadOf(std::span<const Image> levels, bool multiply)
{
    std::uint64_t total = 0;
    for (const Image& level : levels) {
        total += level.byteCount();
    }
    auto memory = makeJobMemory(total);
    if (!memory) {
        return tl::unexpected(memory.error());
    }
    auto bytes = mapShared(*memory, total);
    if (!bytes) {
        return tl::unexpected(bytes.error());
    }
    std::byte* at = bytes->get();
    for (const Image& level : levels) {
        std::memcpy(at, level.pixels().data(), level.byteCount());
        at += level.byteCount();
    }
    if (multiply) {
        multiplyByAlpha(levels.front().format(), {bytes->get(), total});
    }
    return Payload{std::move(*memory), std::move(*bytes), total};
}

Status copyInto(FileWriter& file, const Descriptor& encoded, Progress& progress)
{
    const auto size = jobMemorySize(encoded);
    if (!size || *size == 0) {
        return size ? Status(contentsError("nothing was encoded")) : tl::unexpected(size.error());
    }
    const auto bytes = mapSealed(encoded, *size);
    if (!bytes) {
        return tl::unexpected(bytes.error());
    }
    if (!progress.report(1)) {
        return cancelled();
    }
    return file.write(std::span<const std::byte>(bytes->get(), *size));
}

/// All levels: a renderer sees the coarser ones more often than the image itself.
Status compare(const ImageWorker& worker,
               const fs::path& written,
               std::span<const Image> levels,
               const Payload& payload,
               Progress& progress)
{
    const Image& image = levels.front();
    ImageLimits own; // our own file: as large as it is
    own.mostBytes = payload.size;
    own.memoryBytes = std::max<std::uint64_t>(own.memoryBytes, 3 * payload.size);
    own.mostChannels = image.format().channels;
    own.mostBytesPerByte = ~std::uint64_t{0};
    own.processorTime = own.wallTime = std::chrono::seconds(3600);
    DecodeOptions options;
    options.keepsAlpha = true;
    for (const Image& level : levels.subspan(1)) {
        options.coarserLevels.push_back({level.width(), level.height()});
    }
    const auto back = decodeImageFile(worker, written, options, progress, own);
    if (!back) {
        return tl::unexpected(back.error());
    }
    const bool same = back->width == image.width() && back->height == image.height() &&
                      back->format.type == image.format().type &&
                      back->format.channels == image.format().channels &&
                      std::memcmp(back->pixels.get(), payload.bytes.get(), payload.size) == 0;
    return same ? Status() : contentsError("other pixels");
}

Status inFile(const fs::path& path, const Status& status)
{
    return status || status.error().kind != ErrorKind::Contents
               ? status
               : Status(prefixed(path.string(), status.error()));
}

} // namespace

Status checkImageTarget(const fs::path& path,
                        const TexelFormat& format,
                        std::int64_t width,
                        std::int64_t height,
                        bool hasLevels)
{
    const auto refuse = [&](const std::string& what) {
        return contentsError(path.string() + ": " + what);
    };
    const auto container = containerOf(path, format.type);
    if (!container) {
        return refuse("expected a name that ends in .png, .tif, .exr or .tx");
    }
    const bool integers = format.type == TexelType::UInt8 || format.type == TexelType::UInt16;
    if (*container == Container::Png && (!integers || format.channels > 4)) {
        return refuse("a PNG holds 1 to 4 channels of uint8 or uint16, not " +
                      std::to_string(format.channels) + " of " + std::string(nameOf(format.type)));
    }
    if (*container == Container::Png && format.alpha && *format.alpha + 1 != format.channels) {
        return refuse("a PNG has opacity in its last channel, not in channel " +
                      std::to_string(*format.alpha) + " of " + std::to_string(format.channels));
    }
    if (*container == Container::Png && hasLevels) {
        return refuse("a PNG holds one level; .exr, .tif and .tx hold more");
    }
    if (*container == Container::Tiff && format.type == TexelType::Half) {
        return refuse("a TIFF holds uint8, uint16 or float, not half");
    }
    if (*container == Container::OpenExr && integers) {
        return refuse("an OpenEXR image holds half or float, not " +
                      std::string(nameOf(format.type)));
    }
    const std::int64_t most = ImageLimits().mostPixelsAcross;
    if (width < 1 || height < 1 || width > most || height > most) {
        return refuse("expected 1 to " + std::to_string(most) + " pixels across, found " +
                      std::to_string(width) + " × " + std::to_string(height));
    }
    return {};
}

Status writeImage(const ImageWorker& worker,
                  const fs::path& path,
                  std::span<const Image> levels,
                  const ImageWriteOptions& options,
                  Progress& progress)
{
    check(!levels.empty() && !levels.front().isEmpty(), "an image to write");
    const Image& image = levels.front();
    for (const Image& level : levels) {
        check(level.format() == image.format(), "levels of one format");
    }
    if (Status usable = checkImageTarget(
            path, image.format(), image.width(), image.height(), levels.size() > 1);
        !usable) {
        return usable;
    }
    const Container container = *containerOf(path, image.format().type);
    const auto payload = payloadOf(levels, multiplies(container, image, options));
    const auto encoded = makeJobMemory(0);
    if (!payload || !encoded) {
        return inFile(path, tl::unexpected(payload ? encoded.error() : payload.error()));
    }
    ImageLimits limits;
    limits.wallTime = std::chrono::hours(24); // of our own doing; cancelled by hand if at all
    StageProgress encoding(progress, 0, 0.6);
    const auto answer =
        worker.run(jobOf(levels, container, options), payload->memory, *encoded, limits, encoding);
    if (!answer) {
        return inFile(path, tl::unexpected(answer.error()));
    }
    StageProgress verifying(progress, 0.6, 1);
    return commitFile(
        path,
        [&](FileWriter& file) { return inFile(path, copyInto(file, *encoded, encoding)); },
        [&](const fs::path& written) {
            return compare(worker, written, levels, *payload, verifying);
        });
}

} // namespace trixel
