// SPDX-License-Identifier: GPL-3.0-or-later
//
// A packed atlas of 100 k faces of mixed levels, about 100 M texels: how much of its pages is used,
// and how fast it is written beside OpenImageIO writing the same pixels as a plain image.
// `bench_atlas [FACES [ENDING]]` takes another number of faces and another format (png, exr, tif).
#include "core/atlas/packed_pages.h"
#include "core/io/atlas/export_atlas.h"
#include "core/io/image/read_image.h"
#include "tests/bench/sheet_mesh.h"

#include <OpenImageIO/imageio.h>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>
#include <unistd.h>

using namespace trixel;
namespace fs = std::filesystem;

namespace {

double secondsOf(const std::function<void()>& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Levels as painters leave them: most faces at 4 to 6, some far coarser, a few finer. Texels are
/// waves with a little noise.
Project mixedProject(std::size_t faces)
{
    NoProgress progress;
    const int n = static_cast<int>(std::sqrt(static_cast<double>(faces) / 2));
    TriangleMesh mesh = sheetMesh(n);
    std::mt19937 random(5);
    FaceMap<Level> levels(mesh.faceCount());
    for (Level& level : levels.values()) {
        constexpr int kLevels[] = {1, 3, 4, 4, 4, 5, 5, 5, 6, 6};
        level = Level(random() % 1000 == 0 ? 7 : kLevels[random() % std::size(kLevels)]);
    }
    const TexelFormat format{TexelType::UInt8, 3, std::nullopt};
    Project project{*Surface::build(std::move(mesh), progress),
                    TexelStore(format, levels, std::vector<std::byte>(3)),
                    {}};
    for (std::size_t f = 0; f < levels.size(); ++f) {
        std::size_t k = f;
        for (std::byte& value : project.texels.writable(faceId(f))) {
            const double wave = 100 + 80 * std::sin(0.01 * static_cast<double>(k++));
            value = static_cast<std::byte>(static_cast<int>(wave) + static_cast<int>(random() % 4));
        }
    }
    return project;
}

/// The same pixels as OpenImageIO writes them.
void writePlain(const fs::path& path, const Image& image, const std::string& writer)
{
    const auto output = OIIO::ImageOutput::create(writer);
    OIIO::ImageSpec spec(image.width(),
                         image.height(),
                         image.format().channels,
                         image.format().type == TexelType::UInt8  ? OIIO::TypeDesc::UINT8
                         : image.format().type == TexelType::Half ? OIIO::TypeDesc::HALF
                                                                  : OIIO::TypeDesc::FLOAT);
    spec.attribute("compression", "zip");
    spec.attribute("png:compressionLevel", 4);
    if (!output || !output->open(path.string(), spec) ||
        !output->write_image(spec.format, image.pixels().data()) || !output->close()) {
        std::fprintf(stderr, "the plain image was not written\n");
        std::exit(1);
    }
}

void require(const Status& status)
{
    if (!status) {
        std::fprintf(stderr, "%s\n", status.error().message.c_str());
        std::exit(1);
    }
}

} // namespace

int main(int argc, char** argv)
{
    const std::size_t faces = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 100'000;
    const std::string ending = argc > 2 ? argv[2] : "png";
    const Project project = mixedProject(faces);
    const fs::path folder =
        fs::temp_directory_path() / ("trixel-atlas-" + std::to_string(::getpid()));
    fs::create_directories(folder);
    const fs::path atlas = folder / ("atlas." + ending);
    PackedExportOptions options;
    options.layout.largestPage = 65536; // one page
    const auto estimate = estimatePackedAtlas(atlas, project, options);
    if (!estimate) {
        require(tl::unexpected(estimate.error()));
    }
    std::printf("%u faces, %.1f M texels, %u × %u pixels: %.1f %% used, %.1f %% in bands\n",
                project.texels.faceCount(),
                1e-6 * static_cast<double>(project.texels.texelCount()),
                estimate->pages.front().width,
                estimate->pages.front().height,
                100 * estimate->occupancy,
                100 * estimate->otherOccupancy.value_or(0));
    NoProgress progress;
    FaceMap<Level> levels(project.texels.faceCount());
    for (std::uint32_t f = 0; f < project.texels.faceCount(); ++f) {
        levels[faceId(f)] = project.texels.face(faceId(f)).level();
    }
    const AtlasLayout layout = *AtlasLayout::plan(levels, options.layout);
    std::printf("drawn in %.2f s\n", secondsOf([&] {
                    (void)packedPages(layout,
                                      project.texels,
                                      project.surface->adjacency(),
                                      uniformColors(ColorSpace::SRgb, 3, {}),
                                      Threads::all(),
                                      progress);
                }));
    const ImageWorker worker(TRIXEL_IMAGE_WORKER);
    const double whole =
        secondsOf([&] { require(exportPackedAtlas(worker, atlas, project, options, progress)); });
    ImageLimits limits;
    limits.mostBytes = std::uint64_t{16} << 30U;
    limits.memoryBytes = std::uint64_t{16} << 30U;
    const auto image = readImage(worker, atlas, progress, limits);
    if (!image) {
        require(tl::unexpected(image.error()));
    }
    const std::string writer = ending == "exr" ? "openexr" : ending == "tif" ? "tiff" : "png";
    const double plain =
        secondsOf([&] { writePlain(folder / ("plain." + ending), *image, writer); });
    std::printf("%.0f MB: atlas %.2f s, plain %.2f s: %.0f %% of the speed\n",
                1e-6 * static_cast<double>(image->byteCount()),
                whole,
                plain,
                100 * plain / whole);
    fs::remove_all(folder);
    return 0;
}
