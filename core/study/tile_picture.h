// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lattice/texel.h"
#include "core/study/test_scene.h"
#include "core/texture/texel_format.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trixel {

/// The endless plane of stored tiles, by position.
class TilePicture
{
public:
    explicit TilePicture(const TexelStore& tile)
        : m_tile(tile)
    {
    }

    /// \param at  in texels, any; periodic
    std::array<float, 3> colour(glm::dvec2 at) const
    {
        constexpr double kSize = kTileRhombi;
        const glm::dvec2 rhombi = at / static_cast<double>(kTileLevel.resolution());
        const double x = rhombi.x - kSize * std::floor(rhombi.x / kSize);
        const double y = rhombi.y - kSize * std::floor(rhombi.y / kSize);
        const int a = std::min(static_cast<int>(x), kTileRhombi - 1);
        const int b = std::min(static_cast<int>(y), kTileRhombi - 1);
        const glm::dvec2 uv(x - a, y - b);
        const bool upper = uv.x + uv.y > 1;
        const TexelCoord texel = texelAt(kTileLevel, upper ? 1.0 - uv : uv);
        const auto face = static_cast<std::size_t>(2 * (a + kTileRhombi * b)) + (upper ? 1 : 0);
        std::array<float, 3> values{};
        decode(TexelType::UInt8,
               m_tile.face(faceId(face)).texel(indexOf(texelIndex(kTileLevel, texel))),
               values);
        return values;
    }

private:
    const TexelStore& m_tile;
};

} // namespace trixel
