// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/image/worker/job_descriptors.h"
#include "core/io/image/worker/jobs.h"
#include "core/io/image/worker/jpeg_end.h"

#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <sys/mman.h>
#include <unistd.h>
#include <vector>

namespace trixel::worker {

namespace {

using OIIO::ImageInput;
using OIIO::ImageSpec;
using OIIO::TypeDesc;

[[noreturn]] void fail(const std::string& sentence)
{
    throw std::runtime_error(sentence);
}

/// What the library complained of, as part of one sentence.
std::string complaint(const ImageInput& input)
{
    std::string text = input.geterror();
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
    while (!text.empty() && (text.back() == ' ' || text.back() == '.')) {
        text.pop_back();
    }
    return text.empty() ? "it is damaged" : "it is damaged: " + text;
}

std::string number(std::int64_t n)
{
    return std::to_string(n);
}

/// The rectangle that the image shows, which its stored pixels may not fill or may exceed.
struct Frame
{
    int x = 0, y = 0, width = 0, height = 0;
};

Frame frameOf(const ImageSpec& spec)
{
    return spec.full_width > 0 && spec.full_height > 0
               ? Frame{spec.full_x, spec.full_y, spec.full_width, spec.full_height}
               : Frame{spec.x, spec.y, spec.width, spec.height};
}

TypeDesc storedType(const ImageSpec& spec)
{
    const auto known = [](TypeDesc type) {
        return type == TypeDesc::UINT8 || type == TypeDesc::UINT16 || type == TypeDesc::HALF;
    };
    const bool alike = std::all_of(spec.channelformats.begin(),
                                   spec.channelformats.end(),
                                   [&](TypeDesc type) { return type == spec.format; });
    return known(spec.format) && alike ? spec.format : TypeDesc(TypeDesc::FLOAT);
}

const char* nameOf(TypeDesc type)
{
    return type == TypeDesc::UINT8    ? "uint8"
           : type == TypeDesc::UINT16 ? "uint16"
           : type == TypeDesc::HALF   ? "half"
                                      : "float";
}

void checkSize(const ImageSpec& spec, const nlohmann::json& job)
{
    const nlohmann::json& limits = job.at("limits");
    const auto across = limits.at("pixelsAcross").get<std::int64_t>();
    const Frame frame = frameOf(spec);
    if (spec.deep || spec.depth > 1) {
        fail("it is a deep or volume image, expected a flat one");
    }
    for (const auto& [width, height] :
         {std::pair(spec.width, spec.height), std::pair(frame.width, frame.height)}) {
        if (width < 1 || height < 1) {
            fail("it has no pixels");
        }
        if (width > across || height > across) {
            fail("it is " + number(width) + " × " + number(height) + " pixels, expected at most " +
                 number(across) + " across");
        }
    }
    const auto channels = limits.at("channels").get<int>();
    if (spec.nchannels < 1 || spec.nchannels > channels) {
        fail("it has " + number(spec.nchannels) + " channels, expected 1 to " + number(channels));
    }
    const auto most = limits.at("bytes").get<std::uint64_t>();
    const auto bytesOf = [&](int width, int height) {
        return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) *
               static_cast<std::uint64_t>(spec.nchannels) * storedType(spec).size();
    };
    const std::uint64_t bytes =
        std::max(bytesOf(spec.width, spec.height), bytesOf(frame.width, frame.height));
    if (bytes > most) {
        fail("its pixels would take " + std::to_string(bytes) + " bytes, expected at most " +
             std::to_string(most));
    }
    // A few bytes that claim to be a picture of gigabytes.
    constexpr std::uint64_t kHarmless = std::uint64_t{64} << 20U;
    const auto ratio = limits.at("bytesPerByte").get<std::uint64_t>();
    const auto fileBytes = job.at("fileBytes").get<std::uint64_t>();
    if (bytes > kHarmless && bytes / std::max<std::uint64_t>(fileBytes, 1) > ratio) {
        fail("its " + std::to_string(fileBytes) + " bytes claim to hold " + std::to_string(bytes) +
             " bytes of pixels");
    }
}

/// Memory of the output file.
std::byte* outputMemory(std::uint64_t bytes)
{
    if (::ftruncate(kOutputDescriptor, static_cast<off_t>(bytes)) != 0) {
        throw std::bad_alloc();
    }
    void* memory = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, kOutputDescriptor, 0);
    if (memory == MAP_FAILED) { // NOLINT: the system's macro
        throw std::bad_alloc();
    }
    return static_cast<std::byte*>(memory);
}

/// Of a JPEG; others' decoders miss the end of a file themselves.
void checkEnd(std::uint64_t fileBytes)
{
    void* memory = ::mmap(nullptr, fileBytes, PROT_READ, MAP_PRIVATE, kInputDescriptor, 0);
    if (memory == MAP_FAILED) { // NOLINT: the system's macro
        throw std::bad_alloc();
    }
    const bool isWhole = hasJpegEnd({static_cast<const std::byte*>(memory), fileBytes});
    ::munmap(memory, fileBytes);
    if (!isWhole) {
        fail("the file is cut off: a JPEG without its end mark");
    }
}

void readPixels(ImageInput& input, int channels, TypeDesc type, std::byte* pixels)
{
    if (!input.read_image(0, input.current_miplevel(), 0, channels, type, pixels)) {
        fail(complaint(input));
    }
}

using LevelSizes = std::vector<std::array<int, 2>>;

std::size_t pixelsOf(const LevelSizes& levels)
{
    std::size_t pixels = 0;
    for (const auto& [width, height] : levels) {
        pixels += static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
    return pixels;
}

/// Levels 1 and on, one behind the other.
void readCoarser(ImageInput& input, const LevelSizes& levels, TypeDesc type, std::byte* pixels)
{
    const int channels = input.spec().nchannels;
    for (std::size_t k = 0; k < levels.size(); ++k) {
        const auto [width, height] = levels[k];
        if (!input.seek_subimage(0, static_cast<int>(k) + 1)) {
            fail("it has no level " + std::to_string(k + 1));
        }
        const ImageSpec& spec = input.spec();
        if (spec.width != width || spec.height != height || spec.nchannels != channels) {
            fail("its level " + std::to_string(k + 1) + " is " + number(spec.width) + " × " +
                 number(spec.height) + " pixels, expected " + number(width) + " × " +
                 number(height));
        }
        readPixels(input, channels, type, pixels);
        pixels += spec.image_pixels() * static_cast<std::size_t>(channels) * type.size();
    }
}

/// Where a pixel of the stored picture is shown. Orientation as cameras number it: 1 as stored,
/// 2 mirrored, 3 turned by half, 4 upside down, 5 to 8 with rows and columns exchanged.
struct Place
{
    int x = 0, y = 0;
};

Place shownAt(int x, int y, int width, int height, int orientation)
{
    switch (orientation) {
    case 2:
        return {width - 1 - x, y};
    case 3:
        return {width - 1 - x, height - 1 - y};
    case 4:
        return {x, height - 1 - y};
    case 5:
        return {y, x};
    case 6:
        return {height - 1 - y, x};
    case 7:
        return {height - 1 - y, width - 1 - x};
    case 8:
        return {y, width - 1 - x};
    default:
        return {x, y};
    }
}

void divideByAlpha(TypeDesc type, std::byte* pixels, std::size_t count, int channels, int alpha)
{
    // As floats, a run at a time: of integers the nearest is stored, and what glows through next to
    // no opacity stays finite.
    const float largest = type == TypeDesc::HALF ? 65504.0F : std::numeric_limits<float>::max();
    constexpr std::size_t kRun = 4096;
    const auto width = static_cast<std::size_t>(channels);
    std::vector<float> values(kRun * width);
    for (std::size_t done = 0; done < count; done += kRun) {
        const std::size_t some = std::min(kRun, count - done);
        std::byte* run = pixels + done * width * type.size();
        OIIO::convert_types(
            type, run, TypeDesc::FLOAT, values.data(), static_cast<int>(some * width));
        for (std::size_t k = 0; k < some; ++k) {
            const float opacity = values[k * width + static_cast<std::size_t>(alpha)];
            for (std::size_t c = 0; c < width && opacity > 0; ++c) {
                if (c != static_cast<std::size_t>(alpha)) {
                    float& value = values[k * width + c];
                    value = std::clamp(value / opacity, -largest, largest);
                }
            }
        }
        OIIO::convert_types(
            TypeDesc::FLOAT, values.data(), type, run, static_cast<int>(some * width));
    }
}

/// Of bytes, all of which are transparent.
void becomeOpaqueIfInvisible(std::byte* pixels, std::size_t count, int channels, std::size_t alpha)
{
    const auto step = static_cast<std::size_t>(channels);
    for (std::size_t k = 0; k < count; ++k) {
        if (pixels[k * step + alpha] != std::byte{0}) {
            return;
        }
    }
    for (std::size_t k = 0; k < count; ++k) {
        pixels[k * step + alpha] = std::byte{255};
    }
}

std::string repeated(const std::string& space, const ImageSpec& spec)
{
    std::string text;
    for (int c = 0; c < spec.nchannels; ++c) {
        const bool isColor = c != spec.alpha_channel && c != spec.z_channel;
        text += (text.empty() ? "" : ",") + (isColor ? space : std::string("raw"));
    }
    return text;
}

/// What we wrote ourselves, else what the file says, else what files of its type mean.
std::string colorsOf(const ImageSpec& spec)
{
    constexpr const char* kMark = "Trixel colors: ";
    if (const std::string own = spec.get_string_attribute("trixel:colors"); !own.empty()) {
        return own;
    }
    const std::string description = spec.get_string_attribute("ImageDescription");
    if (const auto at = description.find(kMark); at != std::string::npos) {
        const std::string rest = description.substr(at + std::strlen(kMark));
        return rest.substr(0, rest.find_first_of(" ;\n\r"));
    }
    const std::string said = spec.get_string_attribute("oiio:ColorSpace");
    if (said == "Linear" || said == "linear" || said == "scene_linear" || said == "lin_srgb") {
        return repeated("linear", spec);
    }
    if (said == "sRGB" || said == "Rec709" || said.rfind("Gamma", 0) == 0) {
        return repeated("srgb", spec);
    }
    return repeated(spec.format.is_floating_point() ? "linear" : "srgb", spec);
}

/// \param reader  that of BMP does not say that its colours never are
bool isMultiplied(const ImageSpec& spec, const std::string& reader)
{
    return reader != "bmp" && spec.alpha_channel >= 0 &&
           spec.get_int_attribute("oiio:UnassociatedAlpha", 0) == 0 &&
           spec.get_int_attribute("trixel:UnassociatedAlpha", 0) == 0;
}

/// Moves the stored pixels to where they are shown, through a copy of them.
void place(const ImageSpec& spec,
           const Frame& frame,
           int orientation,
           std::size_t pixelBytes,
           const std::byte* stored,
           std::byte* shown)
{
    const int columns = orientation >= 5 ? frame.height : frame.width;
    for (int y = 0; y < spec.height; ++y) {
        for (int x = 0; x < spec.width; ++x) {
            const int inX = spec.x + x - frame.x;
            const int inY = spec.y + y - frame.y;
            if (inX < 0 || inY < 0 || inX >= frame.width || inY >= frame.height) {
                continue;
            }
            const Place at = shownAt(inX, inY, frame.width, frame.height, orientation);
            const auto to = static_cast<std::size_t>(at.y) * static_cast<std::size_t>(columns) +
                            static_cast<std::size_t>(at.x);
            const auto from = static_cast<std::size_t>(y) * static_cast<std::size_t>(spec.width) +
                              static_cast<std::size_t>(x);
            std::memcpy(shown + to * pixelBytes, stored + from * pixelBytes, pixelBytes);
        }
    }
}

} // namespace

nlohmann::json decodeImage(const nlohmann::json& job)
{
    const auto reader = job.at("reader").get<std::string>();
    const auto input = ImageInput::create(reader);
    if (!input) {
        fail("this installation of OpenImageIO cannot read its format");
    }
    ImageSpec wanted;
    wanted.attribute("oiio:UnassociatedAlpha", 1); // as stored, where the format has both
    ImageSpec spec;
    const std::string name = "/proc/self/fd/" + number(kInputDescriptor);
    if (!input->open(name, spec, wanted)) {
        fail(complaint(*input));
    }
    checkSize(spec, job);
    if (reader == "jpeg") {
        checkEnd(job.at("fileBytes").get<std::uint64_t>());
    }
    const TypeDesc type = storedType(spec);
    const Frame frame = frameOf(spec);
    int orientation = spec.get_int_attribute("Orientation", 1);
    orientation = orientation >= 1 && orientation <= 8 ? orientation : 1;
    const std::size_t pixelBytes = type.size() * static_cast<std::size_t>(spec.nchannels);
    const std::size_t shownPixels =
        static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height);
    const LevelSizes coarser = job.at("coarserLevels").get<LevelSizes>();
    std::byte* shown = outputMemory((shownPixels + pixelsOf(coarser)) * pixelBytes);
    const bool moves = orientation != 1 || spec.x != frame.x || spec.y != frame.y ||
                       spec.width != frame.width || spec.height != frame.height;
    if (moves) {
        std::vector<std::byte> stored(static_cast<std::size_t>(spec.width) *
                                      static_cast<std::size_t>(spec.height) * pixelBytes);
        readPixels(*input, spec.nchannels, type, stored.data());
        place(spec, frame, orientation, pixelBytes, stored.data(), shown);
    } else {
        readPixels(*input, spec.nchannels, type, shown);
    }
    if (isMultiplied(spec, reader) && !job.at("keepsAlpha").get<bool>()) {
        divideByAlpha(type, shown, shownPixels, spec.nchannels, spec.alpha_channel);
    }
    readCoarser(*input, coarser, type, shown + shownPixels * pixelBytes);
    // Many programs leave the fourth byte of a BMP's pixels at 0 and mean nothing by it.
    if (reader == "bmp" && spec.alpha_channel >= 0) {
        becomeOpaqueIfInvisible(
            shown, shownPixels, spec.nchannels, static_cast<std::size_t>(spec.alpha_channel));
    }
    const bool turned = orientation >= 5;
    return {{"width", turned ? frame.height : frame.width},
            {"height", turned ? frame.width : frame.height},
            {"type", nameOf(type)},
            {"channels", spec.nchannels},
            {"alpha", spec.alpha_channel},
            {"colors", colorsOf(spec)}};
}

} // namespace trixel::worker
