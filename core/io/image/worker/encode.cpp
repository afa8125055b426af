// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/image/worker/job_descriptors.h"
#include "core/io/image/worker/jobs.h"

#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <stdexcept>
#include <string>
#include <sys/mman.h>
#include <vector>

namespace trixel::worker {

namespace {

using OIIO::ImageOutput;
using OIIO::ImageSpec;
using OIIO::TypeDesc;

struct LevelSize
{
    int width = 0, height = 0;
};

TypeDesc typeOf(const std::string& name)
{
    return name == "uint8"    ? TypeDesc(TypeDesc::UINT8)
           : name == "uint16" ? TypeDesc(TypeDesc::UINT16)
           : name == "half"   ? TypeDesc(TypeDesc::HALF)
                              : TypeDesc(TypeDesc::FLOAT);
}

std::vector<LevelSize> levelsOf(const nlohmann::json& job)
{
    std::vector<LevelSize> levels;
    for (const nlohmann::json& level : job.at("levels")) {
        levels.push_back({level.at(0).get<int>(), level.at(1).get<int>()});
    }
    return levels;
}

/// What the colours mean, in the words of every format: its own chunk where it has one, and ours.
void declareColors(ImageSpec& spec, const nlohmann::json& job)
{
    const auto colors = job.at("colors").get<std::string>();
    const auto writer = job.at("writer").get<std::string>();
    if (colors.find("srgb") != std::string::npos) {
        spec.attribute("oiio:ColorSpace", "sRGB");
    } else if (colors.find("linear") != std::string::npos) {
        spec.attribute("oiio:ColorSpace", "Linear");
    }
    if (writer == "tiff") {
        spec.attribute("ImageDescription", "Trixel colors: " + colors);
    } else {
        spec.attribute("trixel:colors", colors);
    }
    spec.attribute("Software", "Trixel");
}

ImageSpec specOf(const nlohmann::json& job, LevelSize size)
{
    ImageSpec spec(size.width,
                   size.height,
                   job.at("channels").get<int>(),
                   typeOf(job.at("type").get<std::string>()));
    spec.alpha_channel = job.at("alpha").get<int>();
    const auto names = job.at("names").get<std::vector<std::string>>();
    spec.channelnames = names;
    if (job.at("multiplied") == false) {
        spec.attribute("oiio:UnassociatedAlpha", 1);
        spec.attribute("trixel:UnassociatedAlpha", 1);
    }
    spec.attribute("compression", job.at("compression").get<std::string>());
    spec.attribute("png:compressionLevel", job.at("effort").get<int>());
    spec.attribute("oiio:RowsPerStrip", 64);
    if (const int tile = job.at("tile").get<int>(); tile > 0) {
        spec.tile_width = spec.tile_height = tile;
        spec.tile_depth = 1;
    }
    if (job.at("texture").get<bool>()) {
        spec.attribute("textureformat", "Plain Texture");
        spec.attribute("wrapmodes", job.at("wrap").get<std::string>());
    }
    declareColors(spec, job);
    return spec;
}

const std::byte* inputMemory(std::size_t bytes)
{
    void* memory = ::mmap(nullptr, bytes, PROT_READ, MAP_SHARED, kInputDescriptor, 0);
    if (memory == MAP_FAILED) { // NOLINT: the system's macro
        throw std::bad_alloc();
    }
    return static_cast<const std::byte*>(memory);
}

void require(bool done, const ImageOutput& output)
{
    if (!done) {
        throw std::runtime_error("it cannot be encoded: " + output.geterror());
    }
}

} // namespace

nlohmann::json encodeImage(const nlohmann::json& job)
{
    const auto output = ImageOutput::create(job.at("writer").get<std::string>());
    if (!output) {
        throw std::runtime_error("this installation of OpenImageIO cannot write its format");
    }
    const std::vector<LevelSize> levels = levelsOf(job);
    const std::string name = "/proc/self/fd/" + std::to_string(kOutputDescriptor);
    std::size_t bytes = 0;
    for (const LevelSize level : levels) {
        bytes += specOf(job, level).image_bytes();
    }
    const std::byte* pixels = inputMemory(bytes);
    for (std::size_t k = 0; k < levels.size(); ++k) {
        const ImageSpec spec = specOf(job, levels[k]);
        const ImageOutput::OpenMode mode = k == 0 ? ImageOutput::Create
                                           : output->supports("mipmap")
                                               ? ImageOutput::AppendMIPLevel
                                               : ImageOutput::AppendSubimage;
        require(output->open(name, spec, mode), *output);
        require(output->write_image(spec.format, pixels), *output);
        pixels += spec.image_bytes();
    }
    require(output->close(), *output);
    return {{"levels", levels.size()}};
}

} // namespace trixel::worker
