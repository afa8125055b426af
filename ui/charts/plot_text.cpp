// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/plot_text.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <QTextLayout>

namespace trixel::ui {

namespace {

constexpr double kHaloWidth = 3;

}

void PlotText::draw(const QRectF& box,
                    Qt::Alignment alignment,
                    const QString& text,
                    const QFont& font,
                    const QColor& color,
                    const QColor& halo)
{
    const QFontMetricsF metrics(font);
    const double width = metrics.horizontalAdvance(text);
    double x = box.left();
    if (alignment.testFlag(Qt::AlignRight)) {
        x = box.right() - width;
    } else if (alignment.testFlag(Qt::AlignHCenter)) {
        x = box.center().x() - width / 2;
    }
    const double y = box.center().y() + (metrics.ascent() - metrics.descent()) / 2;
    drawAt({x, y}, text, font, color, halo);
}

void PlotText::drawAt(const QPointF& baseline,
                      const QString& text,
                      const QFont& font,
                      const QColor& color,
                      const QColor& halo)
{
    QPainterPath letters;
    if (halo.isValid() || m_lettering == Lettering::Outlines) {
        letters.addText(baseline, font, text);
    }
    if (halo.isValid()) {
        m_painter.strokePath(letters,
                             QPen(halo, kHaloWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    }
    if (m_lettering == Lettering::Outlines) {
        m_painter.fillPath(letters, color);
        return;
    }
    m_painter.setFont(font);
    m_painter.setPen(color);
    m_painter.drawText(baseline, text);
}

double PlotText::drawWrapped(const QRectF& box,
                             const QString& text,
                             const QFont& font,
                             const QColor& color)
{
    const QFontMetricsF metrics(font);
    QTextLayout layout(text, font);
    layout.beginLayout();
    double height = 0;
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
        line.setLineWidth(box.width());
        const QString words = text.mid(line.textStart(), line.textLength());
        drawAt(box.topLeft() + QPointF(0, height + metrics.ascent()), words, font, color, {});
        height += metrics.height();
    }
    layout.endLayout();
    return height;
}

} // namespace trixel::ui
