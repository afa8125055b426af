// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>
#include <QStringList>

#include "ui/charts/plot_painter.h"

namespace trixel::ui {

/// Where the words about a point go: beside it, inside the plot's whole size.
QRectF
calloutBox(const QStringList& lines, const PlotFonts& fonts, const QPointF& at, const QSizeF& size);

/// A small card of lines, the first in bold, beside the point that it is about.
void paintCallout(QPainter& painter,
                  const QStringList& lines,
                  const PlotFonts& fonts,
                  const PlotTheme& theme,
                  const QRectF& box);

} // namespace trixel::ui
