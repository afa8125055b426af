// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/plot_text.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <QTextLayout>

#include <array>

namespace trixel::ui {

namespace {

constexpr double kHalo = 1.5;
constexpr double kDiagonal = 0.7;
constexpr std::array kAround{QPointF(1, 0),
                             QPointF(-1, 0),
                             QPointF(0, 1),
                             QPointF(0, -1),
                             QPointF(kDiagonal, kDiagonal),
                             QPointF(kDiagonal, -kDiagonal),
                             QPointF(-kDiagonal, kDiagonal),
                             QPointF(-kDiagonal, -kDiagonal)};

} // namespace

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
    if (m_lettering == Lettering::Outlines) {
        QPainterPath letters;
        letters.addText(baseline, font, text);
        if (halo.isValid()) {
            m_painter.strokePath(letters,
                                 QPen(halo, 2 * kHalo, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        }
        m_painter.fillPath(letters, color);
        return;
    }
    m_painter.setFont(font);
    if (halo.isValid()) {
        // Letters are cheap to draw again, their outlines dear to stroke.
        m_painter.setPen(halo);
        for (const QPointF& away : kAround) {
            m_painter.drawText(baseline + away * kHalo, text);
        }
    }
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
