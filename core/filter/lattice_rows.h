// SPDX-License-Identifier: GPL-3.0-or-later
//
// The texels of a face under a circle, as runs of memory.
#pragma once

#include "core/lattice/texel.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>

namespace trixel {

/// Texels that follow each other in memory and lie on a straight line at equal distances.
struct TexelRun
{
    std::uint32_t first = 0; ///< packed index
    std::uint32_t count = 0; ///< at least 1
    glm::dvec2 centroid{0};  ///< of the first, in the unit frame
    double height = 0;       ///< signed distance of their line from the origin
    double foot = 0;         ///< where it is nearest, in texels from the first
};

/// One half of a face's texels: row y, column x of the packed square has its centroid at
/// origin + x alongRow + y perRow.
struct HalfLattice
{
    TexelHalf half = TexelHalf::Lower;
    Level level;
    glm::dvec2 origin{0}, alongRow{0}, perRow{0};

    /// \param corner, e1, e2  the face in the unit frame: (u,v) lies at corner + u e1 + v e2
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

/// Calls visit(run) for every run of texels whose centroids lie within `radius` of the origin of
/// the unit frame. Cost follows the rows under the circle.
template <class Visit>
void forRunsInCircle(const HalfLattice& lattice, double radius, const Visit& visit)
{
    const double resolution = lattice.level.resolution();
    const glm::dvec2 along = lattice.alongRow;
    const double squared = glm::dot(along, along);
    const double length = std::sqrt(squared);
    // Distance of row y's line from the origin, with its side as sign: height + y perRow.
    const auto side = [&](glm::dvec2 p) { return (p.x * along.y - p.y * along.x) / length; };
    const double height = side(lattice.origin);
    const double perRow = side(lattice.perRow);
    const double one = (-radius - height) / perRow;
    const double other = (radius - height) / perRow;
    const double firstRow = lattice.half == TexelHalf::Lower ? 0 : 1; // an upper row 0 is empty
    const double from = std::max(std::ceil(std::min(one, other)), firstRow);
    const double to = std::min(std::floor(std::max(one, other)), resolution - 1);
    for (double y = from; y <= to; ++y) {
        const double h = height + y * perRow;
        const double reach = std::sqrt(std::max(radius * radius - h * h, 0.0)) / length;
        const glm::dvec2 row = lattice.origin + y * lattice.perRow;
        const double middle = -glm::dot(row, along) / squared;
        const bool lower = lattice.half == TexelHalf::Lower;
        const double least = lower ? 0.0 : resolution - y;
        const double most = lower ? resolution - 1 - y : resolution - 1;
        const double begin = std::max(std::ceil(middle - reach), least);
        const double end = std::min(std::floor(middle + reach), most);
        if (begin <= end) {
            visit(TexelRun{static_cast<std::uint32_t>(begin + y * resolution),
                           static_cast<std::uint32_t>(end - begin) + 1,
                           row + begin * along,
                           h,
                           middle - begin});
        }
    }
}

} // namespace trixel
