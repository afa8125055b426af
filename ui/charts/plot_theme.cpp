// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/plot_theme.h"

#include <QTransform>

#include <array>
#include <cmath>
#include <numbers>

namespace trixel::ui {

namespace {

constexpr int kColors = 7;
constexpr int kShapes = 9;
constexpr double kSmaller = 0.88;

/// Blue, vermillion, bluish green, orange, reddish purple, sky blue; the seventh is the text's.
constexpr std::array kOnLight{0x0072B2, 0xD55E00, 0x009E73, 0xDA9400, 0xC2649A, 0x3FA2DB};
/// The same, the dark ones lighter.
constexpr std::array kOnDark{0x2E8FD0, 0xE8732A, 0x14B88A, 0xE69F00, 0xCC79A7, 0x7CC8F2};

/// A regular polygon; with an inner radius, a star.
QPainterPath polygon(int corners, double radius, double startDegrees, double inner = 0)
{
    QPolygonF points;
    const int steps = inner > 0 ? 2 * corners : corners;
    for (int k = 0; k < steps; ++k) {
        const double angle =
            startDegrees * std::numbers::pi / 180 + 2 * std::numbers::pi * k / steps;
        const double r = inner > 0 && k % 2 == 1 ? inner : radius;
        points += QPointF(r * std::cos(angle), r * std::sin(angle));
    }
    QPainterPath path;
    path.addPolygon(points);
    path.closeSubpath();
    return path;
}

QPainterPath plus()
{
    constexpr double kLong = 1.15;
    constexpr double kWide = 0.42;
    QPainterPath path;
    path.setFillRule(Qt::WindingFill); // of the union, the middle too
    path.addRect(-kLong, -kWide, 2 * kLong, 2 * kWide);
    path.addRect(-kWide, -kLong, 2 * kWide, 2 * kLong);
    return path.simplified();
}

} // namespace

PlotTheme lightPlotTheme()
{
    return {.background = QColor(0xffffff),
            .text = QColor(0x1d1d1d),
            .faint = QColor(0x666666),
            .grid = QColor(0xd4d4d4),
            .fineGrid = QColor(0xececec),
            .front = QColor(0xc3cbd3),
            .level = QColor(0x444444),
            .isDark = false};
}

PlotTheme darkPlotTheme()
{
    return {.background = QColor(0x222222),
            .text = QColor(0xe8e8e8),
            .faint = QColor(0xa2a2a2),
            .grid = QColor(0x444444),
            .fineGrid = QColor(0x303030),
            .front = QColor(0x525b64),
            .level = QColor(0xc8c8c8),
            .isDark = true};
}

QColor colorOf(int look, const PlotTheme& theme)
{
    const auto color = static_cast<std::size_t>(look % kColors);
    const auto& known = theme.isDark ? kOnDark : kOnLight;
    return color < known.size() ? QColor(static_cast<QRgb>(known[color])) : theme.text;
}

QPainterPath shapeOf(int look)
{
    // One further shape each time the colours start again.
    switch ((look % kColors + look / kColors) % kShapes) {
    case 1: {
        QPainterPath square;
        square.addRect(-kSmaller, -kSmaller, 2 * kSmaller, 2 * kSmaller);
        return square;
    }
    case 2:
        return polygon(3, 1.35, -90);
    case 3:
        return polygon(4, 1.25, 0);
    case 4:
        return polygon(3, 1.35, 90);
    case 5:
        return polygon(5, 1.5, -90, 0.65);
    case 6:
        return plus();
    case 7:
        return polygon(6, 1.1, 0);
    case 8:
        return QTransform().rotate(45).map(plus());
    default: {
        QPainterPath circle;
        circle.addEllipse(QPointF(), 1, 1);
        return circle;
    }
    }
}

PlotFonts::PlotFonts(const QFont& base)
    : title(base)
    , text(base)
    , small(base)
{
    const auto scaled = [&](QFont& font, double factor) {
        if (base.pixelSize() > 0) {
            font.setPixelSize(static_cast<int>(std::lround(base.pixelSize() * factor)));
        } else {
            font.setPointSizeF(base.pointSizeF() * factor);
        }
    };
    title.setBold(true);
    scaled(title, 1.2);
    scaled(small, 0.87);
}

} // namespace trixel::ui
