// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the texels of a triangle lie and how the packed square stores them.
// Conventions (Ptex): V0, V1, V2 have (u,v) = (0,0), (1,0), (0,1); w = 1 - u - v. At level n the
// resolution is R = 2^n; cell (i,j) of the lattice holds a lower texel, with the face's own
// orientation, and an upper one, turned over.
#pragma once

#include "core/base/ids.h"
#include "core/base/level.h"

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>

namespace trixel {

/// Which of a cell's two texels.
enum class TexelHalf : std::uint8_t { Lower, Upper };

/// Lattice position of a texel. Valid: i + j <= R-1 (lower) or i + j <= R-2 (upper).
struct TexelCoord
{
    std::uint16_t i = 0;
    std::uint16_t j = 0;
    TexelHalf half = TexelHalf::Lower;

    bool operator==(const TexelCoord&) const = default;
};

/// Column x and row y of a texel in the packed square, each in [0, R-1].
struct PackedPixel
{
    std::uint16_t x = 0;
    std::uint16_t y = 0;

    bool operator==(const PackedPixel&) const = default;
};

/// Whether the texel lies inside the face at that level.
bool isValid(Level level, TexelCoord texel);

/// Pixel of the packed square that stores the texel (checked valid).
PackedPixel packedPixel(Level level, TexelCoord texel);

/// Texel that a pixel of the packed square stores; every pixel stores one.
TexelCoord texelAt(Level level, PackedPixel pixel);

/// Row-major index in the packed square: x + y R.
TexelIndex texelIndex(Level level, PackedPixel pixel);
TexelIndex texelIndex(Level level, TexelCoord texel);

PackedPixel packedPixel(Level level, TexelIndex index);
TexelCoord texelAt(Level level, TexelIndex index);

/// Texel containing the point (u,v) of the face; points outside are brought to the nearest cell,
/// NaN to cell 0. Ties on the cell's diagonal go to the lower texel.
TexelCoord texelAt(Level level, glm::dvec2 uv);

/// Centroid in (u,v).
glm::dvec2 centroid(Level level, TexelCoord texel);

/// Corners in (u,v), in the order of the Ptex notes: lower (i,j) (i+1,j) (i,j+1);
/// upper (i+1,j+1) (i,j+1) (i+1,j).
std::array<glm::dvec2, 3> corners(Level level, TexelCoord texel);

} // namespace trixel
