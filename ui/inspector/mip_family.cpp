// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/mip_family.h"

#include <QPolygonF>

#include "core/lattice/texel_family.h"

#include <algorithm>
#include <span>
#include <vector>

namespace trixel::ui {

namespace {

/// Steps of a staircase that are drawn; of finer ones every few.
constexpr std::size_t kMostSteps = 64;
/// Levels down to which the texels of a box are drawn one by one.
constexpr int kMostSteppedLevels = 4;

QPointF toPoint(glm::dvec2 p)
{
    return {p.x, p.y};
}

void add(const TexelOutline& outline, QPainterPath& path)
{
    QPolygonF polygon;
    for (const glm::dvec2 corner : outline.corners()) {
        polygon += toPoint(corner);
    }
    path.addPolygon(polygon);
    path.closeSubpath();
}

/// Rows of pixels that lie one upon the other, as one outline.
void addStairs(const FaceLayout& layout,
               Level level,
               std::span<const PackedRow> rows,
               QPainterPath& path)
{
    if (rows.empty()) {
        return;
    }
    const double side = 1.0 / level.resolution();
    const bool up = rows.size() < 2 || rows[1].first.y > rows[0].first.y;
    const std::size_t stride = (rows.size() + kMostSteps - 1) / kMostSteps;
    QPolygonF right;
    QPolygonF left;
    for (std::size_t k = 0; k < rows.size(); k += stride) {
        const std::size_t last = std::min(k + stride, rows.size()) - 1;
        const double near = rows[k].first.y + (up ? 0 : 1);
        const double far = rows[last].first.y + (up ? 1 : 0);
        for (const double y : {near, far}) {
            const double x = rows[k].first.x;
            left += toPoint(layout.map().point(glm::dvec2(x, y) * side));
            right += toPoint(layout.map().point(glm::dvec2(x + rows[k].count, y) * side));
        }
    }
    std::ranges::reverse(left);
    path.addPolygon(right + left);
    path.closeSubpath();
}

void addCovered(
    const FaceLayout& layout, Level level, TexelCoord texel, Level at, QPainterPath& path)
{
    if (layout.texels() == FaceLayout::Texels::Triangles) {
        add(layout.outline(level, texel), path);
        return;
    }
    const std::vector<PackedRow> rows = packedDescendants(level, texel, at);
    const std::size_t own = (rows.size() + 1) / 2; // of the texel's own half
    addStairs(layout, at, std::span(rows).first(own), path);
    addStairs(layout, at, std::span(rows).subspan(own), path);
}

/// What 2 × 2 boxes on boxes pick: a square of pixels.
void addBoxed(const FaceLayout& layout, Level level, TexelCoord texel, Level at, QPainterPath& path)
{
    if (layout.texels() == FaceLayout::Texels::Pixels) {
        add(layout.outline(level, texel), path);
        return;
    }
    // Finer ones are too small to see: they fill the same cells, half of each.
    const Level drawn(std::min(at.log2(), level.log2() + kMostSteppedLevels));
    const auto side = std::uint32_t{1} << static_cast<unsigned>(drawn.log2() - level.log2());
    const PackedPixel coarse = packedPixel(level, texel);
    for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < side; ++x) {
            const PackedPixel pixel{static_cast<std::uint16_t>(coarse.x * side + x),
                                    static_cast<std::uint16_t>(coarse.y * side + y)};
            add(layout.outline(drawn, texelAt(drawn, pixel)), path);
        }
    }
}

} // namespace

Kinship kinshipOf(Level level, Level at)
{
    return at == level ? Kinship::Itself : at < level ? Kinship::Parent : Kinship::Children;
}

QPainterPath
familyOutline(const FaceLayout& layout, Level level, TexelCoord texel, Level at, ReductionRule rule)
{
    QPainterPath path;
    path.setFillRule(Qt::WindingFill);
    if (at <= level) {
        add(layout.outline(at, ancestorOf(level, texel, at)), path);
    } else if (rule == ReductionRule::Triangles) {
        addCovered(layout, level, texel, at, path);
    } else {
        addBoxed(layout, level, texel, at, path);
    }
    return path;
}

} // namespace trixel::ui
