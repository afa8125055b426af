// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lattice/texel.h"

#include <cstdint>
#include <glm/vec2.hpp>

namespace trixel {

/// What surrounds a face's texels in an atlas.
enum class AtlasBorder : std::uint8_t {
    None,    ///< nothing: the packed square as it is, for readers that fetch single texels
    Bilinear ///< what bilinear stencils reach: texels of the true neighbours
};

/// A cell of one half's lattice. Unlike a texel it may lie outside the face.
struct LatticeCell
{
    int i = 0;
    int j = 0;
    TexelHalf half = TexelHalf::Lower;

    bool operator==(const LatticeCell&) const = default;
};

/// Column and row of an atlas page or of a tile of it.
struct AtlasPixel
{
    std::uint32_t x = 0;
    std::uint32_t y = 0;

    bool operator==(const AtlasPixel&) const = default;
};

/// The square that a face takes at a level. The lower texels lie in its lower left, the upper ones
/// turned by half a turn in its upper right, as in the packed square; with borders the halves stand
/// so far apart that a bilinear stencil within the face never reads the other half. A stencil
/// begins one cell below the first and ends two beyond the diagonal, so that R + 4 is the side:
///   lower (i,j): pixel (i + 1, j + 1),                     i, j >= -1, i + j <= R + 1
///   upper (i,j): pixel (S - 1 - (j + 1), S - 1 - (i + 1)), i, j >= -1, i + j <= R,  S = R + 4
class AtlasTile
{
public:
    AtlasTile(Level level, AtlasBorder border)
        : m_resolution(static_cast<int>(level.resolution()))
        , m_border(border == AtlasBorder::None ? 0 : 1)
    {
    }

    /// Width and height in pixels.
    std::uint32_t side() const { return static_cast<std::uint32_t>(m_resolution + 4 * m_border); }

    /// Where a cell is stored (checked to be in the tile).
    AtlasPixel pixel(LatticeCell cell) const;
    /// The inverse: every pixel stores a cell. \param pixel  below `side` (checked)
    LatticeCell cell(AtlasPixel pixel) const;

    /// Where a point of the face lies among the pixels of one half, for hardware interpolation:
    /// pixel centres are at 1/2, and the centroid of a texel is at the centre of its pixel.
    glm::dvec2 position(glm::dvec2 uv, TexelHalf half) const;

private:
    int m_resolution;
    int m_border; ///< cells about each half's first ones
};

} // namespace trixel
