// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QPointF>
#include <QString>

class QPainter;

namespace trixel::ui {

/// Writing that can be read on any texels.
struct HaloedInk
{
    QFont font;
    QColor color;
    QColor halo;
    double width = 3; ///< of the pen that draws the halo
};

/// Draws text about a centre: as shapes into files, into pictures of pixels as a picture that is
/// kept, because shaping letters takes a tenth of a millisecond and the same few names come with
/// every hover.
void drawHaloed(QPainter& painter, const HaloedInk& ink, QPointF centre, const QString& text);

} // namespace trixel::ui
