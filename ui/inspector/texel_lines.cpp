// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/texel_lines.h"

#include <QPainter>
#include <QPen>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace trixel::ui {

namespace {

using Pixels = std::uint32_t;

/// Cells, or pixels, from low to high, both included.
struct Cells
{
    Pixels i0 = 0, j0 = 0, i1 = 0, j1 = 0;
    bool isEmpty = true;
};

/// Those that the area may show.
Cells cellsIn(const FaceLayout& layout, Level level, const QRectF& area)
{
    const PlaneMap back = layout.map().inverse();
    const auto side = static_cast<double>(level.resolution());
    glm::dvec2 low(side);
    glm::dvec2 high(0);
    for (const QPointF corner :
         {area.topLeft(), area.topRight(), area.bottomLeft(), area.bottomRight()}) {
        const glm::dvec2 p = back.point({corner.x(), corner.y()}) * side;
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    if (!(low.x < side && low.y < side && high.x > 0 && high.y > 0)) {
        return {};
    }
    const auto cell = [&](double x) {
        return static_cast<Pixels>(std::clamp(std::floor(x), 0.0, side - 1));
    };
    return {cell(low.x), cell(low.y), cell(high.x), cell(high.y), false};
}

void addClipped(std::vector<QLineF>& lines, glm::dvec2 a, glm::dvec2 b, const QRectF& area)
{
    if (const auto line = clipped({toPoint(a), toPoint(b)}, area)) {
        lines.push_back(*line);
    }
}

} // namespace

QPolygonF toPolygon(const TexelOutline& outline)
{
    QPolygonF polygon;
    for (const glm::dvec2 corner : outline.corners()) {
        polygon << toPoint(corner);
    }
    return polygon;
}

QRectF boundsOf(const TexelOutline& outline)
{
    glm::dvec2 low = outline.corners()[0];
    glm::dvec2 high = low;
    for (const glm::dvec2 corner : outline.corners()) {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
    }
    return {toPoint(low), toPoint(high)};
}

std::optional<QLineF> clipped(const QLineF& line, const QRectF& area)
{
    double from = 0;
    double to = 1;
    const auto keep = [&](double start, double step, double low, double high) {
        if (step == 0) {
            return start >= low && start <= high;
        }
        const double a = (low - start) / step;
        const double b = (high - start) / step;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
        return from <= to;
    };
    if (!keep(line.x1(), line.dx(), area.left(), area.right()) ||
        !keep(line.y1(), line.dy(), area.top(), area.bottom())) {
        return std::nullopt;
    }
    return QLineF(line.pointAt(from), line.pointAt(to));
}

void forEachTexel(const FaceLayout& layout,
                  Level level,
                  const QRectF& area,
                  const std::function<void(TexelCoord)>& visit)
{
    const Cells cells = cellsIn(layout, level, area);
    if (cells.isEmpty) {
        return;
    }
    const bool pixels = layout.texels() == FaceLayout::Texels::Pixels;
    const auto visitSeen = [&](TexelCoord texel) {
        if (boundsOf(layout.outline(level, texel)).intersects(area)) {
            visit(texel);
        }
    };
    for (Pixels j = cells.j0; j <= cells.j1; ++j) {
        for (Pixels i = cells.i0; i <= cells.i1; ++i) {
            const auto x = static_cast<std::uint16_t>(i);
            const auto y = static_cast<std::uint16_t>(j);
            if (pixels) {
                visitSeen(texelAt(level, PackedPixel{x, y}));
                continue;
            }
            for (const TexelHalf half : {TexelHalf::Lower, TexelHalf::Upper}) {
                if (const TexelCoord texel{x, y, half}; isValid(level, texel)) {
                    visitSeen(texel);
                }
            }
        }
    }
}

std::vector<QLineF> gridLines(const FaceLayout& layout, Level level, const QRectF& area)
{
    std::vector<QLineF> lines;
    const Cells cells = cellsIn(layout, level, area);
    if (cells.isEmpty) {
        return lines;
    }
    const auto side = static_cast<double>(level.resolution());
    const bool pixels = layout.texels() == FaceLayout::Texels::Pixels;
    const auto add = [&](glm::dvec2 a, glm::dvec2 b) {
        addClipped(lines, layout.map().point(a / side), layout.map().point(b / side), area);
    };
    for (Pixels i = cells.i0; i <= cells.i1 + 1; ++i) {
        add({i, 0}, {i, pixels ? side : side - i});
    }
    for (Pixels j = cells.j0; j <= cells.j1 + 1; ++j) {
        add({0, j}, {pixels ? side : side - j, j});
    }
    if (!pixels) {
        const Pixels last = std::min(cells.i1 + cells.j1 + 2, level.resolution());
        for (Pixels sum = cells.i0 + cells.j0; sum <= last; ++sum) {
            add({sum, 0}, {0, sum});
        }
    }
    return lines;
}

std::vector<QLineF> diagonalSteps(const FaceLayout& layout, Level level, const QRectF& area)
{
    std::vector<QLineF> lines;
    const Cells cells = cellsIn(layout, level, area);
    if (cells.isEmpty) {
        return lines;
    }
    const auto side = static_cast<double>(level.resolution());
    const auto add = [&](glm::dvec2 a, glm::dvec2 b) {
        addClipped(lines, layout.map().point(a / side), layout.map().point(b / side), area);
    };
    for (Pixels y = cells.j0; y <= cells.j1; ++y) {
        const double x = side - y;
        add({x, y}, {x, y + 1.0});
        add({x - 1, y + 1.0}, {x, y + 1.0});
    }
    return lines;
}

QLineF diagonal(const FaceLayout& layout, Level level)
{
    const double offset = 1.0 / 6 / level.resolution();
    return {toPoint(layout.map().point({1 + offset, offset})),
            toPoint(layout.map().point({offset, 1 + offset}))};
}

void drawLines(QPainter& painter, const std::vector<QLineF>& lines, double strength)
{
    if (strength <= 0 || lines.empty()) {
        return;
    }
    const auto pass = [&](QColor color, double alpha, double width) {
        color.setAlphaF(static_cast<float>(alpha * strength));
        QPen pen(color, width);
        pen.setCapStyle(Qt::FlatCap);
        painter.setPen(pen);
        painter.drawLines(lines.data(), static_cast<int>(lines.size()));
    };
    // Dark beside light: one of them shows on any colour.
    pass(Qt::black, 0.35, 1.6);
    pass(Qt::white, 0.35, 0.7);
}

void drawDots(QPainter& painter, const std::vector<QPointF>& dots, double radius, double strength)
{
    if (strength <= 0) {
        return;
    }
    QColor rim(Qt::black);
    QColor middle(Qt::white);
    rim.setAlphaF(static_cast<float>(0.75 * strength));
    middle.setAlphaF(static_cast<float>(0.95 * strength));
    painter.setPen(QPen(rim, 1));
    painter.setBrush(middle);
    for (const QPointF& dot : dots) {
        painter.drawEllipse(dot, radius, radius);
    }
    painter.setBrush(Qt::NoBrush);
}

double fadeIn(double size, double from, double to)
{
    return std::clamp((size - from) / (to - from), 0.0, 1.0);
}

} // namespace trixel::ui
