// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/query_filter.h"

#include <algorithm>

namespace trixel {

/// Adds weight times the value of a face at (u,v), interpolated between the vertices of the lattice
/// cell at the level, or at the face's base where that is coarser.
inline void addInterpolated(const ConformingPyramid& pyramid,
                            FaceId face,
                            int levelNumber,
                            int group,
                            glm::dvec2 uv,
                            float weight,
                            GroupValue& sum)
{
    const Level level = std::min(Level(levelNumber), pyramid.level(face));
    const LevelVertices vertices = pyramid.vertices(face, level, group);
    const TexelCoord texel = texelAt(level, uv);
    const double x = std::clamp(uv.x * level.resolution() - texel.i, 0.0, 1.0);
    const double y = std::clamp(uv.y * level.resolution() - texel.j, 0.0, 1.0);
    const bool upper = texel.half == TexelHalf::Upper;
    const std::uint32_t i = texel.i;
    const std::uint32_t j = texel.j;
    // The vertex at the right angle, then the one along u from it, then along v.
    const double perU = upper ? 1 - x : x;
    const double perV = upper ? 1 - y : y;
    const double rest = std::max(1 - perU - perV, 0.0);
    const std::size_t corner = latticeVertex(level, i + upper, j + upper);
    const std::size_t alongU = latticeVertex(level, i + !upper, j + upper);
    const std::size_t alongV = latticeVertex(level, i + upper, j + !upper);
    const float* a = vertices.values + vertices.stride * corner;
    const float* b = vertices.values + vertices.stride * alongU;
    const float* c = vertices.values + vertices.stride * alongV;
    for (std::size_t k = 0; k < sum.size(); ++k) {
        sum[k] += weight * (static_cast<float>(rest) * a[k] + static_cast<float>(perU) * b[k] +
                            static_cast<float>(perV) * c[k]);
    }
}

} // namespace trixel
