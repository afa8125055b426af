// SPDX-License-Identifier: GPL-3.0-or-later
//
// A mesh as people have them, with the texture it came with.
#include "core/io/image/read_image.h"
#include "core/mapping/bake.h"
#include "core/mapping/uv_mapping.h"
#include "core/mesh/mesh_reader.h"
#include "core/resample/uv_image.h"
#include "core/resample/uv_raster.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace trixel {
namespace {

const std::filesystem::path kMug = "/usr/share/mujoco/model/mug";

std::vector<float> valuesOf(const Image& image)
{
    std::vector<float> values(image.byteCount() / byteSize(image.format().type));
    decode(image.format().type, image.pixels(), values);
    return values;
}

/// Pixels that lie in uvs with all about them: nearer the charts' borders a pixel and its texels
/// see past them, on the surface or in the image.
std::vector<bool> awayFromSeams(const UvRaster& raster, int border)
{
    std::vector<bool> away(raster.pixelCount());
    for (int y = border; y < raster.height - border; ++y) {
        for (int x = border; x < raster.width - border; ++x) {
            bool all = true;
            for (int j = y - border; all && j <= y + border; ++j) {
                for (int i = x - border; all && i <= x + border; ++i) {
                    all = raster.inside[static_cast<std::size_t>(j * raster.width + i)] != 0;
                }
            }
            away[static_cast<std::size_t>(y * raster.width + x)] = all;
        }
    }
    return away;
}

/// As few texels for each face as there are pixels in its uvs, or up to four times as many.
FaceMap<Level> levelsOfDensity(const TriangleMesh& mesh, int size)
{
    FaceMap<Level> levels(mesh.faceCount());
    for (std::size_t k = 0; k < mesh.faceCount(); ++k) {
        const auto uvs = mesh.uvs(faceId(k));
        const glm::dvec2 a = glm::dvec2(uvs[1] - uvs[0]) * static_cast<double>(size);
        const glm::dvec2 b = glm::dvec2(uvs[2] - uvs[0]) * static_cast<double>(size);
        const double pixels = std::abs(a.x * b.y - a.y * b.x) / 2;
        int level = 0;
        while (std::pow(4.0, level) < pixels) {
            ++level;
        }
        levels[faceId(k)] = Level(level);
    }
    return levels;
}

TEST(MugTexture, comesBackFromTheFacesAtItsOwnDensity)
{
    ASSERT_TRUE(std::filesystem::exists(kMug)) << "libmujoco-samples has the mug";
    NoProgress progress;
    const auto mesh = readMesh(kMug / "mug.obj", progress);
    ASSERT_TRUE(mesh) << mesh.error().message;
    const auto texture = readImage(ImageWorker(TRIXEL_IMAGE_WORKER), kMug / "mug.png", progress);
    ASSERT_TRUE(texture) << texture.error().message;
    const int size = texture->width();
    ASSERT_EQ(texture->height(), size);

    const TexelFormat format{TexelType::UInt8, 3, std::nullopt};
    const std::vector<ColorSpace> colors(3, ColorSpace::SRgb);
    const FaceMap<Level> levels = levelsOfDensity(*mesh, size);
    std::size_t texels = 0;
    for (const Level level : levels.values()) {
        texels += level.texelCount();
    }
    TexelStore store(format, levels, std::vector<std::byte>(3));
    std::vector<FaceId> faces;
    for (std::size_t k = 0; k < mesh->faceCount(); ++k) {
        faces.push_back(faceId(k));
    }
    const auto images = ImageTiles::make({{UdimTile{}, *texture, "mug.png"}}, {}, Threads{2});
    ASSERT_TRUE(images);
    ASSERT_TRUE(bake(store, faces, UvMapping(*mesh), *images, {.colors = colors}, progress));

    const auto linear = linearStore(store, colors, Threads{2}, progress);
    ASSERT_TRUE(linear);
    const auto surface = std::make_shared<const FilterSurface>(
        FilterSurface::fromMesh(*mesh, buildAdjacency(mesh->triangles)));
    const auto scene = FilterScene::build(surface, *linear, Threads{2}, progress);
    ASSERT_TRUE(scene);
    UvImageOptions options;
    options.width = options.height = size;
    options.colors = colors;
    options.threads = Threads{2};
    const auto out = makeUvImage(*scene, *mesh, format, options, progress);
    ASSERT_TRUE(out) << out.error().message;

    const auto away = awayFromSeams(*rasterUvs(*mesh, size, size, {}, Threads{2}, progress), 4);
    const auto before = valuesOf(*texture);
    const auto after = valuesOf(out->image);
    const auto channels = static_cast<std::size_t>(texture->format().channels);
    double squares = 0;
    std::size_t count = 0;
    for (std::size_t k = 0; k < away.size(); ++k) {
        for (std::size_t c = 0; away[k] && c < 3; ++c) {
            squares +=
                std::pow(static_cast<double>(after[3 * k + c]) - before[channels * k + c], 2);
            ++count;
        }
    }
    EXPECT_GT(count, 3U * 500'000U);
    const double psnr = -10 * std::log10(squares / static_cast<double>(count));
    std::cout << "PSNR of the mug's texture: " << psnr << " dB over " << count / 3 << " pixels, "
              << texels << " texels\n";
    EXPECT_GE(psnr, 40);
}

} // namespace
} // namespace trixel
