// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/speed/spread_queries.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace trixel {
namespace {

/// In [0, 1); not a standard distribution, which may differ between libraries.
double uniform(std::mt19937_64& random)
{
    return static_cast<double>(random() >> 11U) * 0x1p-53;
}

/// Areas of the faces, summed up to and including each.
std::vector<double> summedAreas(const FilterSurface& surface)
{
    std::vector<double> sums;
    sums.reserve(surface.faceCount());
    double sum = 0;
    for (std::size_t f = 0; f < surface.faceCount(); ++f) {
        const FaceShape& shape = surface.shape(faceId(f));
        sum += shape.e1.x * shape.e2.y / 2;
        sums.push_back(sum);
    }
    return sums;
}

} // namespace

QueryArrays spreadQueries(const FilterScene& scene, int count, std::uint64_t seed)
{
    QueryArrays queries;
    const std::vector<double> areas = summedAreas(scene.surface());
    if (areas.empty()) {
        return queries;
    }
    std::mt19937_64 random(seed);
    for (int q = 0; q < count; ++q) {
        const auto at = std::ranges::upper_bound(areas, uniform(random) * areas.back());
        const auto index = std::min(static_cast<std::size_t>(at - areas.begin()), areas.size() - 1);
        const FaceId face = faceId(index);
        glm::dvec2 uv(uniform(random), uniform(random));
        uv = uv.x + uv.y > 1 ? 1.0 - uv : uv;
        const double width =
            0.25 * std::pow(256.0, uniform(random)) * std::exp2(scene.log2TexelSize(face, uv));
        const double length = width * std::pow(64.0, uniform(random));
        const double angle = 6.283185307179586 * uniform(random);
        const double turn = 6.283185307179586 * uniform(random);
        const glm::dvec2 major = length * glm::dvec2(std::cos(angle), std::sin(angle));
        const glm::dvec2 minor = width * glm::dvec2(-std::sin(angle), std::cos(angle));
        const FaceShape& shape = scene.surface().shape(face);
        queries.add(face,
                    uv,
                    shape.toUv(std::cos(turn) * major + std::sin(turn) * minor),
                    shape.toUv(std::cos(turn) * minor - std::sin(turn) * major));
    }
    return queries;
}

} // namespace trixel
