// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/paint/dab_raster.h"

#include "core/lattice/paint_projection.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace trixel {

namespace {

/// Relative to the face's corners: large coordinates cancel before they are scaled.
glm::dvec3 relativeTo(glm::vec3 centre, glm::vec3 corner)
{
    return glm::dvec3(corner) - glm::dvec3(centre);
}

/// v less its part along a; v itself where a has no length.
glm::dvec3 across(glm::dvec3 v, glm::dvec3 a, double aSquared)
{
    return aSquared > 0 ? v - (glm::dot(v, a) / aSquared) * a : v;
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
    // The projection is affine: its value at one pixel centre and its steps say everything.
    const glm::dvec2 first = fromPacked(level, half, {0.5, 0.5});
    const glm::dvec2 right = fromPacked(level, half, {1.5, 0.5}) - first;
    const glm::dvec2 below = fromPacked(level, half, {0.5, 1.5}) - first;
    m_origin = corner + first.x * e1 + first.y * e2;
    m_across = right.x * e1 + right.y * e2;
    m_down = below.x * e1 + below.y * e2;
    m_acrossSquared = glm::dot(m_across, m_across);
}

RowRange HalfRaster::rows() const
{
    const RowRange all{0, m_resolution};
    // Seen along the rows, the half is a line of points, one a row.
    const glm::dvec3 origin = across(m_origin, m_across, m_acrossSquared);
    const glm::dvec3 down = across(m_down, m_across, m_acrossSquared);
    const double squared = glm::dot(down, down);
    if (squared <= 1e-18 * glm::dot(m_down, m_down)) {
        return all; // no area: every row lies on one line
    }
    const double foot = -glm::dot(origin, down) / squared;
    const glm::dvec3 apart = origin + foot * down;
    const double room = 1.0 - glm::dot(apart, apart);
    if (room < -1e-6) {
        return {}; // the face's plane passes the sphere by
    }
    const double reach = room > 0 ? std::sqrt(room / squared) : 0;
    return {clampedFloor(foot - reach, m_resolution), clampedFloor(foot + reach + 2, m_resolution)};
}

DabSpan HalfRaster::span(std::uint32_t row) const
{
    const bool lower = m_half == TexelHalf::Lower;
    DabSpan span;
    span.begin = lower ? 0 : m_resolution - row;
    span.end = lower ? m_resolution - row : m_resolution;
    const glm::dvec3 start = m_origin + static_cast<double>(row) * m_down;
    const glm::dvec3 apart = across(start, m_across, m_acrossSquared);
    const double height = glm::dot(apart, apart);
    if (!(height < 1.0)) {
        return {};
    }
    span.heightSquared = static_cast<float>(height);
    if (m_acrossSquared <= 0) {
        return span; // the whole row lies on one point
    }
    const double foot = -glm::dot(start, m_across) / m_acrossSquared;
    const double length = std::sqrt(m_acrossSquared);
    const double reach = std::sqrt(1.0 - height) / length;
    span.begin = std::max(span.begin, clampedFloor(std::ceil(foot - reach), m_resolution));
    span.end = std::min(span.end, clampedFloor(foot + reach + 1, m_resolution));
    span.start = static_cast<float>((span.begin - foot) * length);
    span.step = static_cast<float>(length);
    return span;
}

} // namespace trixel
