// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/paint_batch.h"

#include "core/base/check.h"
#include "core/lattice/paint_projection.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

namespace trixel::render {

namespace {

/// Squares up to this level are drawn whole: to bound what dabs reach costs more than it saves.
constexpr int kWholeLevel = 5;

std::uint32_t packed(std::uint32_t x, std::uint32_t y)
{
    return x | y << 16U;
}

/// The grid of centroids of one half, in steps of pixels from the first.
struct Grid
{
    glm::dvec3 start;
    glm::dvec3 across;
    glm::dvec3 down;

    glm::dvec3 at(glm::dvec2 pixel) const { return start + pixel.x * across + pixel.y * down; }

    struct Foot
    {
        glm::dvec2 pixel{0};
        glm::dvec2 pixelsPerUnit{0}; ///< that a sphere around a point of the grid spans at most
    };
    /// The point of the grid's plane nearest to another; nothing where the grid has no area.
    std::optional<Foot> footOf(glm::dvec3 point) const
    {
        const glm::dvec3 away = point - start;
        const double aa = glm::dot(across, across);
        const double dd = glm::dot(down, down);
        const double ad = glm::dot(across, down);
        const double area = aa * dd - ad * ad;
        if (!(area > 1e-12 * aa * dd)) {
            return std::nullopt;
        }
        const double a = glm::dot(away, across);
        const double d = glm::dot(away, down);
        return Foot{glm::dvec2(a * dd - d * ad, d * aa - a * ad) / area,
                    glm::dvec2(std::sqrt(dd / area), std::sqrt(aa / area))};
    }
};

Grid gridOf(const std::array<glm::vec3, 3>& corners, Level level, TexelHalf half, glm::vec3 origin)
{
    const glm::dvec3 corner(corners[0]);
    const glm::dvec3 e1 = glm::dvec3(corners[1]) - corner;
    const glm::dvec3 e2 = glm::dvec3(corners[2]) - corner;
    // The upper half is mirrored: a column is a step back along v, a row one back along u.
    const bool lower = half == TexelHalf::Lower;
    const double step = 1.0 / level.resolution();
    const glm::dvec2 first = fromPacked(level, half, {0.5, 0.5});
    return {corner - glm::dvec3(origin) + first.x * e1 + first.y * e2,
            lower ? step * e1 : -step * e2,
            lower ? step * e2 : -step * e1};
}

std::uint32_t clamped(double value, std::uint32_t most)
{
    return value > 0 ? static_cast<std::uint32_t>(std::min(value, static_cast<double>(most))) : 0;
}

/// Pixels of a square, the end exclusive.
struct Pixels
{
    std::uint32_t x0, y0, x1, y1;

    bool isEmpty() const { return x0 >= x1 || y0 >= y1; }
    void extend(const Pixels& more)
    {
        *this = isEmpty() ? more
                          : Pixels{std::min(x0, more.x0),
                                   std::min(y0, more.y0),
                                   std::max(x1, more.x1),
                                   std::max(y1, more.y1)};
    }
};

/// Those a dab may reach, a pixel more at either end. \param centre  from the grid's origin
Pixels reached(const Grid& grid, glm::dvec3 centre, double radius, std::uint32_t resolution)
{
    const auto foot = grid.footOf(centre);
    if (!foot) {
        return {0, 0, resolution, resolution};
    }
    const glm::dvec3 apart = grid.at(foot->pixel) - centre;
    const double room = radius * radius * (1 + 1e-6) - glm::dot(apart, apart);
    if (room < 0) {
        return {0, 0, 0, 0}; // the face's plane passes the sphere by
    }
    const glm::dvec2 half = std::sqrt(room) * foot->pixelsPerUnit + 1.0;
    return {clamped(foot->pixel.x - half.x, resolution),
            clamped(foot->pixel.y - half.y, resolution),
            clamped(foot->pixel.x + half.x + 1, resolution),
            clamped(foot->pixel.y + half.y + 1, resolution)};
}

} // namespace

PaintBatch::PaintBatch(std::span<const Dab> dabs)
    : m_dabs(dabs.begin(), dabs.end())
{
    check(!dabs.empty() && dabs.size() <= kMostDabs, "one to kMostDabs dabs");
    const glm::dvec3 origin(dabs.front().centre);
    for (const Dab& dab : dabs) {
        PaintDab card;
        card.centre = glm::vec3(glm::dvec3(dab.centre) - origin);
        card.inverseRadius = 1.0F / dab.radius;
        card.cap = dab.cap;
        m_cardDabs.push_back(card);
    }
}

void PaintBatch::add(const std::array<glm::vec3, 3>& corners,
                     const PaintSquare& square,
                     std::uint32_t dabs,
                     bool first)
{
    addHalf(corners, square, TexelHalf::Lower, dabs, first);
    addHalf(corners, square, TexelHalf::Upper, dabs, first);
}

void PaintBatch::addHalf(const std::array<glm::vec3, 3>& corners,
                         const PaintSquare& square,
                         TexelHalf half,
                         std::uint32_t dabs,
                         bool first)
{
    const std::uint32_t resolution = square.level.resolution();
    const glm::vec3 origin = m_dabs.front().centre;
    const Grid grid = gridOf(corners, square.level, half, origin);
    Pixels pixels{0, 0, resolution, resolution};
    if (!first && square.level.log2() > kWholeLevel) {
        pixels = {0, 0, 0, 0};
        for (std::size_t k = 0; k < m_dabs.size(); ++k) {
            if ((dabs >> k & 1U) != 0) {
                const glm::dvec3 centre = glm::dvec3(m_dabs[k].centre) - glm::dvec3(origin);
                pixels.extend(reached(grid, centre, m_dabs[k].radius, resolution));
            }
        }
        if (pixels.isEmpty()) {
            return;
        }
    }
    const auto foot = grid.footOf(glm::dvec3(0)).value_or(Grid::Foot());
    const std::uint32_t x = clamped(std::round(foot.pixel.x), resolution - 1);
    const std::uint32_t y = clamped(std::round(foot.pixel.y), resolution - 1);
    PaintEntry entry;
    entry.anchor = glm::vec3(grid.at({x, y}));
    entry.across = glm::vec3(grid.across);
    entry.down = glm::vec3(grid.down);
    entry.dabs = dabs;
    entry.kind = static_cast<std::uint32_t>(square.level.log2()) |
                 (half == TexelHalf::Upper ? PaintEntry::kUpper : 0) |
                 (first ? PaintEntry::kFirst : 0);
    entry.place = packed(square.x, square.y);
    entry.anchorPixel = packed(x, y);
    entry.low = packed(pixels.x0, pixels.y0);
    entry.high = packed(pixels.x1, pixels.y1);
    m_entries.push_back(entry);
}

} // namespace trixel::render
