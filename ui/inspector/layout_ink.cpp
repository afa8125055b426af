// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/layout_ink.h"

#include <QPainter>

#include "ui/inspector/haloed_text.h"

#include <algorithm>

namespace trixel::ui {

namespace {

constexpr int kMiddle = 128;
constexpr double kHalo = 3;

QFont scaled(const QFont& base, double factor, bool bold)
{
    QFont font = base;
    if (base.pointSizeF() > 0) {
        font.setPointSizeF(base.pointSizeF() * factor);
    } else {
        font.setPixelSize(std::max(1, static_cast<int>(base.pixelSize() * factor)));
    }
    font.setBold(bold);
    return font;
}

} // namespace

LayoutInk::LayoutInk(const QPalette& palette, const QFont& base)
    : isDark(palette.color(QPalette::Window).lightness() < kMiddle)
    , background(palette.color(QPalette::Base))
    , text(palette.color(QPalette::Text))
    , faint(palette.color(QPalette::PlaceholderText))
    , halo(isDark ? QColor(0, 0, 0, 190) : QColor(255, 255, 255, 215))
    , rim(isDark ? QColor(0x9a9a9a) : QColor(0x6a6a6a))
    , selection(255, 158, 26) // as in the 3D view
    // After M. Okabe and K. Ito, darker on light windows.
    , edges(isDark ? std::array{QColor(0xe58fc0), QColor(0x56b4e9), QColor(0x2fc79c)}
                   : std::array{QColor(0xb0487f), QColor(0x0072b2), QColor(0x008f68)})
    , lowerTint(qPremultiply(qRgba(240, 180, 40, 56)))
    , upperTint(qPremultiply(qRgba(40, 120, 255, 72)))
    , font(base)
    , bold(scaled(base, 1, true))
    , small(scaled(base, 0.88, false))
{
}

void drawHaloed(QPainter& painter,
                const LayoutInk& ink,
                const QFont& font,
                QPointF centre,
                const QString& text,
                const QColor& color)
{
    drawHaloed(painter, {font, color, ink.halo, kHalo}, centre, text);
}

} // namespace trixel::ui
