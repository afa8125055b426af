// SPDX-License-Identifier: GPL-3.0-or-later
//
// The texels of a face under a circle, as runs of memory. Compiled once for each kind of processor
// (Highway), as the loops that it feeds.
#if defined(TRIXEL_LATTICE_ROWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIXEL_LATTICE_ROWS_INL_H
#undef TRIXEL_LATTICE_ROWS_INL_H
#else
#define TRIXEL_LATTICE_ROWS_INL_H
#endif

#include "core/filter/half_lattice.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace trixel {
namespace HWY_NAMESPACE {

/// Calls visit(run) for every run of texels whose centroids lie within `radius` of the origin. Cost
/// follows the rows under the circle.
template <class Visit>
HWY_INLINE void forRunsInCircle(const HalfLattice& lattice, double radius, const Visit& visit)
{
    const bool lower = lattice.half == TexelHalf::Lower;
    const double resolution = lattice.level.resolution();
    const glm::dvec2 along = lattice.alongRow;
    const double inverseSquare = 1 / glm::dot(along, along);
    const double inverseLength = std::sqrt(inverseSquare);
    // Row y's line lies height + y heightPerRow from the origin, its side being the sign, and comes
    // nearest to it at column middle + y middlePerRow.
    const auto side = [&](glm::dvec2 p) HWY_ATTR {
        return (p.x * along.y - p.y * along.x) * inverseLength;
    };
    const double height = side(lattice.origin);
    const double heightPerRow = side(lattice.perRow);
    const double middle = -glm::dot(lattice.origin, along) * inverseSquare;
    const double middlePerRow = -glm::dot(lattice.perRow, along) * inverseSquare;
    const double one = (-radius - height) / heightPerRow;
    const double other = (radius - height) / heightPerRow;
    const double least = std::max(std::min(one, other), lower ? 0.0 : 1.0); // upper row 0 is empty
    const double most = std::min(std::max(one, other), resolution - 1);
    if (!(least <= most)) {
        return;
    }
    const auto rows = lattice.level.resolution();
    auto y = static_cast<std::int32_t>(least);
    y += y < least ? 1 : 0;
    const auto last = static_cast<std::int32_t>(most);
    for (; y <= last; ++y) {
        const double h = height + y * heightPerRow;
        const double nearest = middle + y * middlePerRow;
        const double reach = std::sqrt(std::max(radius * radius - h * h, 0.0)) * inverseLength;
        const double from = std::max(nearest - reach, lower ? 0.0 : resolution - y);
        const double to =
            std::min(nearest + reach, lower ? resolution - 1 - y : resolution - 1);
        if (!(from <= to)) {
            continue;
        }
        auto begin = static_cast<std::int32_t>(from);
        begin += begin < from ? 1 : 0;
        const auto end = static_cast<std::int32_t>(to);
        if (begin <= end) {
            visit(TexelRun{static_cast<std::uint32_t>(begin) + static_cast<std::uint32_t>(y) * rows,
                           static_cast<std::uint32_t>(end - begin) + 1,
                           h,
                           nearest - begin});
        }
    }
}

} // namespace HWY_NAMESPACE
} // namespace trixel
HWY_AFTER_NAMESPACE();

#endif
