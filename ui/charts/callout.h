// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>
#include <QStringList>

#include "ui/charts/plot_painter.h"

namespace trixel::ui {

/// Where the words about a point go: beside it and inside the plot's whole size, on the side where
/// they cover the fewest points, and of such sides where they cover the fewest other words.
/// \param at  where the point lies
QRectF calloutBox(const QStringList& lines,
                  const PlotFonts& fonts,
                  const QPointF& at,
                  const Plot& plot,
                  const PlotLayout& layout);

/// A small card of lines, the first in bold, beside the point that it is about.
void paintCallout(QPainter& painter,
                  const QStringList& lines,
                  const PlotFonts& fonts,
                  const PlotTheme& theme,
                  const QRectF& box);

} // namespace trixel::ui
