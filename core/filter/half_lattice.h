// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lattice/texel.h"

#include <cstdint>
#include <glm/vec2.hpp>

namespace trixel {

/// One half of a face's texels in a plane: the texel in row y, column x of the packed square has
/// its centroid at origin + x alongRow + y perRow.
struct HalfLattice
{
    TexelHalf half = TexelHalf::Lower;
    Level level;
    glm::dvec2 origin{0}, alongRow{0}, perRow{0};

    /// \param corner, e1, e2  the face in the plane: (u,v) lies at corner + u e1 + v e2
    HalfLattice(TexelHalf which, Level of, glm::dvec2 corner, glm::dvec2 e1, glm::dvec2 e2)
        : half(which)
        , level(of)
    {
        const double r = of.resolution();
        const glm::dvec2 perI = e1 / r;
        const glm::dvec2 perJ = e2 / r;
        if (half == TexelHalf::Lower) {
            origin = corner + (perI + perJ) / 3.0;
            alongRow = perI;
            perRow = perJ;
        } else {
            // Upper texel (i,j) is stored in column R-1-j, row R-1-i.
            origin = corner + (r - 1.0 / 3.0) * (perI + perJ);
            alongRow = -perJ;
            perRow = -perI;
        }
    }
};

/// Texels that follow each other in memory and lie on a straight line at equal distances.
struct TexelRun
{
    std::uint32_t first = 0; ///< packed index
    std::uint32_t count = 0; ///< at least 1
    double height = 0;       ///< distance of their line from the origin
    double foot = 0;         ///< where it is nearest, in texels from the first
};

} // namespace trixel
