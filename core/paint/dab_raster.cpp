// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/paint/dab_raster.h"

#include "core/lattice/paint_projection.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace trixel {

namespace {

/// Relative to the face's corners: large coordinates cancel before they are scaled.
glm::dvec3 relativeTo(glm::vec3 centre, glm::vec3 corner)
{
    return glm::dvec3(corner) - glm::dvec3(centre);
}

/// A whole number in [0, limit]; any double may come in.
std::uint32_t clampedFloor(double value, std::uint32_t limit)
{
    if (!(value > 0)) {
        return 0;
    }
    return value < limit ? static_cast<std::uint32_t>(value) : limit;
}

} // namespace

HalfRaster::HalfRaster(const std::array<glm::vec3, 3>& corners,
                       Level level,
                       TexelHalf half,
                       const Dab& dab)
    : m_resolution(level.resolution())
    , m_half(half)
{
    const double scale = 1.0 / dab.radius;
    const glm::dvec3 corner = relativeTo(dab.centre, corners[0]) * scale;
    const glm::dvec3 e1 = relativeTo(corners[0], corners[1]) * scale;
    const glm::dvec3 e2 = relativeTo(corners[0], corners[2]) * scale;
    // The projection is affine: its value at the first pixel's centre and its steps say everything.
    // The upper half is mirrored: a column is a step back along v, a row one back along u.
    const bool lower = half == TexelHalf::Lower;
    const glm::dvec2 first = fromPacked(level, half, {0.5, 0.5});
    const double step = 1.0 / m_resolution;
    const glm::dvec3 start = corner + first.x * e1 + first.y * e2;
    const glm::dvec3 across = lower ? step * e1 : -step * e2;
    const glm::dvec3 down = lower ? step * e2 : -step * e1;

    const double squared = glm::dot(across, across);
    const double inverse = squared > 0 ? 1.0 / squared : 0.0;
    m_columnWidth = std::sqrt(squared);
    m_columnsPerUnit = m_columnWidth * inverse;
    m_footColumn = -glm::dot(start, across) * inverse;
    m_footColumnStep = -glm::dot(down, across) * inverse;
    m_footOfFirst = start + m_footColumn * across;
    m_footStep = down + m_footColumnStep * across;
    m_isFlat = glm::dot(m_footStep, m_footStep) <= 1e-18 * glm::dot(down, down);
}

RowRange HalfRaster::rows() const
{
    if (m_isFlat) {
        return {0, m_resolution};
    }
    // Where the feet of all rows, a line of their own, run through the sphere.
    const double squared = glm::dot(m_footStep, m_footStep);
    const double nearest = -glm::dot(m_footOfFirst, m_footStep) / squared;
    const glm::dvec3 apart = m_footOfFirst + nearest * m_footStep;
    const double room = 1.0 - glm::dot(apart, apart);
    if (room < -1e-6) {
        return {}; // the face's plane passes the sphere by
    }
    const double reach = room > 0 ? std::sqrt(room / squared) : 0;
    return {clampedFloor(nearest - reach, m_resolution),
            clampedFloor(nearest + reach + 2, m_resolution)};
}

double HalfRaster::longestRow() const
{
    const double whole = m_resolution;
    return m_columnWidth > 0 ? std::min(whole, 2.0 * m_columnsPerUnit + 1) : whole;
}

DabSpan HalfRaster::span(std::uint32_t row) const
{
    const glm::dvec3 foot = m_footOfFirst + static_cast<double>(row) * m_footStep;
    const double height = glm::dot(foot, foot);
    if (!(height < 1.0)) {
        return {};
    }
    const bool lower = m_half == TexelHalf::Lower;
    DabSpan span;
    span.begin = lower ? 0 : m_resolution - row;
    span.end = lower ? m_resolution - row : m_resolution;
    span.heightSquared = static_cast<float>(height);
    if (m_columnsPerUnit <= 0) {
        return span; // the whole row lies on one point
    }
    const double column = m_footColumn + row * m_footColumnStep;
    const double reach = std::sqrt(1.0 - height) * m_columnsPerUnit;
    span.begin = std::max(span.begin, clampedFloor(std::ceil(column - reach), m_resolution));
    span.end = std::min(span.end, clampedFloor(column + reach + 1, m_resolution));
    span.start = static_cast<float>((span.begin - column) * m_columnWidth);
    span.step = static_cast<float>(m_columnWidth);
    return span;
}

} // namespace trixel
