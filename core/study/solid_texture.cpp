// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/solid_texture.h"

#include "core/lattice/texel.h"
#include "core/study/tile_picture.h"
#include "core/texture/texel_format.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace trixel {
namespace {

std::array<float, 3>
solidAt(const TilePicture& natural, const TilePicture& hardEdged, glm::dvec3 texels)
{
    std::array<float, 3> colour{};
    int dark = 0;
    for (const glm::dvec2 seen : {glm::dvec2(texels.x, texels.y),
                                  glm::dvec2(texels.y, texels.z),
                                  glm::dvec2(texels.z, texels.x)}) {
        const auto soft = natural.colour(seen);
        colour[0] += soft[0] / 3;
        colour[1] += soft[1] / 3;
        dark += hardEdged.colour(seen)[1] < 0.5F ? 1 : 0;
    }
    colour[2] = dark % 2 == 0 ? 0.95F : 0.05F;
    return colour;
}

/// Mean edge of a texel, in world units.
double texelSize(const TriangleMesh& mesh, const LevelPlan& plan)
{
    double area = 0;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const auto c = mesh.corners(faceId(f));
        area += static_cast<double>(glm::length(glm::cross(c[1] - c[0], c[2] - c[0]))) / 2;
    }
    const double each = area / static_cast<double>(std::max<std::uint64_t>(plan.texels, 1));
    return std::max(std::sqrt(each / 0.4330127018922193), 1e-30); // of an equilateral one
}

} // namespace

Result<TexelStore> solidTexture(const TriangleMesh& mesh,
                                const LevelPlan& plan,
                                const TestData& data,
                                Threads threads,
                                Progress& progress)
{
    check(plan.levels.size() == mesh.faceCount(), "a level for every face");
    const TexelFormat format{TexelType::UInt8, 3, std::nullopt};
    const std::array<std::byte, 3> black{};
    const TilePicture natural(data.tiles[0]);
    const TilePicture hardEdged(data.tiles[1]);
    const double size = texelSize(mesh, plan);
    TexelStore store(format, plan.levels, black);
    constexpr std::size_t kFacesAtOnce = 1024;
    for (std::size_t begin = 0; begin < mesh.faceCount(); begin += kFacesAtOnce) {
        if (!progress.report(static_cast<double>(begin) / static_cast<double>(mesh.faceCount()))) {
            return cancelled();
        }
        const std::size_t count = std::min(kFacesAtOnce, mesh.faceCount() - begin);
        std::vector<std::span<std::byte>> texels(count);
        for (std::size_t k = 0; k < count; ++k) {
            texels[k] = store.writable(faceId(begin + k));
        }
        parallelFor(count, 16, threads, [&](std::size_t from, std::size_t to) {
            for (std::size_t k = from; k < to; ++k) {
                const FaceId face = faceId(begin + k);
                const auto corners = mesh.corners(face);
                const Level level = plan.levels[face];
                for (std::uint32_t t = 0; t < level.texelCount(); ++t) {
                    const glm::vec2 uv(centroid(level, texelAt(level, static_cast<TexelIndex>(t))));
                    const glm::dvec3 at = glm::dvec3(pointAt(corners, uv.x, uv.y)) / size;
                    encode(TexelType::UInt8,
                           solidAt(natural, hardEdged, at),
                           texels[k].subspan(3 * std::size_t{t}, 3));
                }
            }
        });
    }
    return store;
}

} // namespace trixel
