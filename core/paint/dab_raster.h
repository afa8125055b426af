// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which texels of a face a dab reaches. Each half of the face is rasterised into the packed square
// by its paint projection; a row of either is a straight line through the dab's sphere, so the
// texels in reach are one span, found by solving a quadratic. The cost of a face follows the rows
// and texels inside the sphere, not its level.
#pragma once

#include "core/lattice/texel.h"
#include "core/paint/dab.h"

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>

namespace trixel {

/// Texels [begin, end) of one row of the packed square, and where they lie in the dab's sphere.
/// Lengths are in radii of the dab.
struct DabSpan
{
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    float heightSquared = 0; ///< of the row's line over the centre
    float start = 0;         ///< of the first centroid along the row from the centre's foot
    float step = 0;          ///< from one centroid to the next

    bool isEmpty() const { return begin >= end; }
};

/// Rows [begin, end) of the packed square.
struct RowRange
{
    std::uint32_t begin = 0;
    std::uint32_t end = 0;

    bool isEmpty() const { return begin >= end; }
};

/// One half of a face under one dab.
class HalfRaster
{
public:
    HalfRaster() = default;
    HalfRaster(const std::array<glm::vec3, 3>& corners,
               Level level,
               TexelHalf half,
               const Dab& dab);

    /// Rows that may hold texels in reach; at most a row too many at either end, except for faces
    /// without area.
    RowRange rows() const;

    /// The most texels that one row can hold within the radius.
    double longestRow() const;

    /// The texels of a row whose centroids lie within the dab's radius; a texel on the rim, where
    /// the falloff is 0, may be in or out. \param row  below the resolution
    DabSpan span(std::uint32_t row) const;

private:
    std::uint32_t m_resolution = 1;
    TexelHalf m_half = TexelHalf::Lower;
    // In radii of the dab, from its centre. The centroids of a row lie on a line; its point nearest
    // to the centre, the foot, moves evenly from row to row, both in space and in columns.
    glm::dvec3 m_footOfFirst{0};
    glm::dvec3 m_footStep{0};
    double m_footColumn = 0;
    double m_footColumnStep = 0;
    double m_columnWidth = 0;    ///< from one centroid of a row to the next
    double m_columnsPerUnit = 0; ///< 1 / m_columnWidth; 0 where all of a row is one point
    bool m_isFlat = false;       ///< without area: all rows lie on one line
};

} // namespace trixel
