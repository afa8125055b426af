// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QPalette>
#include <QRgb>
#include <QString>

#include "core/base/ids.h"

#include <array>

class QPainter;

namespace trixel::ui {

/// The colours and the writing of drawn layouts.
struct LayoutInk
{
    LayoutInk(const QPalette& palette, const QFont& base);

    bool isDark = true;
    QColor background; ///< around faces
    QColor text;
    QColor faint;
    QColor halo; ///< around writing and lines that lie on texels
    QColor rim;  ///< of faces, where it is no edge of the main one
    QColor selection;
    /// Of E0, E1, E2, which colour-blind people tell apart; they are always named as well.
    std::array<QColor, 3> edges;
    QRgb lowerTint = 0; ///< premultiplied
    QRgb upperTint = 0;
    QFont font;
    QFont bold;
    QFont small;

    const QColor& edge(LocalEdge edge) const { return edges[indexOf(edge)]; }
};

/// Writes with a halo, so that it can be read on any texels. \param centre  of the text
void drawHaloed(QPainter& painter,
                const LayoutInk& ink,
                const QFont& font,
                QPointF centre,
                const QString& text,
                const QColor& color);

} // namespace trixel::ui
