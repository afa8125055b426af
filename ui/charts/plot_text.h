// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QRectF>
#include <QString>

#include "ui/charts/plot_painter.h"

class QPainter;

namespace trixel::ui {

/// Writes into a plot, as text or as outlines.
class PlotText
{
public:
    PlotText(QPainter& painter, Lettering lettering)
        : m_painter(painter)
        , m_lettering(lettering)
    {
    }

    /// One line within a box.
    /// \param halo  drawn around the letters when valid, so that they can be read over lines
    void draw(const QRectF& box,
              Qt::Alignment alignment,
              const QString& text,
              const QFont& font,
              const QColor& color,
              const QColor& halo = {});

    /// As many lines as the box's width asks for, from its top; gives their height.
    double
    drawWrapped(const QRectF& box, const QString& text, const QFont& font, const QColor& color);

private:
    void drawAt(const QPointF& baseline,
                const QString& text,
                const QFont& font,
                const QColor& color,
                const QColor& halo);

    QPainter& m_painter;
    Lettering m_lettering;
};

} // namespace trixel::ui
