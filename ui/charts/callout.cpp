// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/callout.h"

#include <QFontMetricsF>
#include <QPainter>

#include "ui/charts/plot_text.h"

#include <algorithm>

namespace trixel::ui {

namespace {

constexpr double kPadding = 8;
constexpr double kAway = 14; ///< from the point
constexpr double kRounding = 4;

QFont boldOf(QFont font)
{
    font.setBold(true);
    return font;
}

} // namespace

QRectF
calloutBox(const QStringList& lines, const PlotFonts& fonts, const QPointF& at, const QSizeF& size)
{
    const QFontMetricsF bold(boldOf(fonts.small));
    const QFontMetricsF plain(fonts.small);
    double width = 0;
    for (qsizetype k = 0; k < lines.size(); ++k) {
        width = std::max(width, (k == 0 ? bold : plain).horizontalAdvance(lines[k]));
    }
    const double height = plain.height() * static_cast<double>(lines.size());
    QRectF box(0, 0, width + 2 * kPadding, height + 2 * kPadding);
    const bool right = at.x() + kAway + box.width() <= size.width();
    const bool above = at.y() - kAway - box.height() >= 0;
    box.moveLeft(right ? at.x() + kAway : at.x() - kAway - box.width());
    box.moveTop(above ? at.y() - kAway - box.height() : at.y() + kAway);
    // Where neither side has room the card may cover the point, but never leave the plot.
    box.moveLeft(std::max(0.0, std::min(box.left(), size.width() - box.width())));
    box.moveTop(std::max(0.0, std::min(box.top(), size.height() - box.height())));
    return box;
}

void paintCallout(QPainter& painter,
                  const QStringList& lines,
                  const PlotFonts& fonts,
                  const PlotTheme& theme,
                  const QRectF& box)
{
    QColor paper = theme.background;
    paper.setAlphaF(0.95F);
    painter.setPen(QPen(theme.faint, 1));
    painter.setBrush(paper);
    painter.drawRoundedRect(box, kRounding, kRounding);
    PlotText text(painter, Lettering::Text);
    const double height = QFontMetricsF(fonts.small).height();
    QRectF line(box.left() + kPadding, box.top() + kPadding, box.width(), height);
    for (qsizetype k = 0; k < lines.size(); ++k) {
        text.draw(line,
                  Qt::AlignLeft | Qt::AlignVCenter,
                  lines[k],
                  k == 0 ? boldOf(fonts.small) : fonts.small,
                  theme.text);
        line.translate(0, height);
    }
}

} // namespace trixel::ui
