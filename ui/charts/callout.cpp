// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/callout.h"

#include <QFontMetricsF>
#include <QPainter>

#include "ui/charts/plot_text.h"

#include <algorithm>
#include <array>
#include <compare>

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

QSizeF cardSize(const QStringList& lines, const PlotFonts& fonts)
{
    const QFontMetricsF bold(boldOf(fonts.small));
    const QFontMetricsF plain(fonts.small);
    double width = 0;
    for (qsizetype k = 0; k < lines.size(); ++k) {
        width = std::max(width, (k == 0 ? bold : plain).horizontalAdvance(lines[k]));
    }
    const double height = plain.height() * static_cast<double>(lines.size());
    return {width + 2 * kPadding, height + 2 * kPadding};
}

/// Beside, above and below the point, the first being the first choice. Where a side has no room
/// the card may cover the point, but never leaves the plot.
std::array<QRectF, 8> placesAbout(const QPointF& at, const QSizeF& card, const QSizeF& plot)
{
    const double right = at.x() + kAway;
    const double left = at.x() - kAway - card.width();
    const double above = at.y() - kAway - card.height();
    const double below = at.y() + kAway;
    const double middle = at.x() - card.width() / 2;
    const double level = at.y() - card.height() / 2;
    std::array<QRectF, 8> places;
    std::ranges::transform(std::array<QPointF, 8>{{{right, above},
                                                   {left, above},
                                                   {right, below},
                                                   {left, below},
                                                   {right, level},
                                                   {left, level},
                                                   {middle, above},
                                                   {middle, below}}},
                           places.begin(),
                           [&](const QPointF& corner) {
                               const double x = std::min(corner.x(), plot.width() - card.width());
                               const double y = std::min(corner.y(), plot.height() - card.height());
                               return QRectF({std::max(0.0, x), std::max(0.0, y)}, card);
                           });
    return places;
}

/// What a card would hide, the worst first.
struct Hidden
{
    bool itsPoint = false;
    int points = 0;
    int words = 0;

    auto operator<=>(const Hidden&) const = default;
};

Hidden hiddenBy(const QRectF& card, const QPointF& at, const Plot& plot, const PlotLayout& layout)
{
    Hidden hidden{card.contains(at), 0, 0};
    const double r = layout.markRadius;
    const QRectF reach = card.adjusted(-r, -r, r, r);
    for (const PlotSeries& series : plot.series) {
        hidden.points +=
            static_cast<int>(std::ranges::count_if(series.points, [&](const PlotPoint& point) {
                return reach.contains(layout.at(point));
            }));
    }
    const auto covers = [&](const auto& words) { return card.intersects(words.box); };
    hidden.words += static_cast<int>(std::ranges::count_if(layout.labels, covers));
    hidden.words += static_cast<int>(std::ranges::count_if(layout.legend, covers));
    return hidden;
}

} // namespace

QRectF calloutBox(const QStringList& lines,
                  const PlotFonts& fonts,
                  const QPointF& at,
                  const Plot& plot,
                  const PlotLayout& layout)
{
    return std::ranges::min(placesAbout(at, cardSize(lines, fonts), layout.size),
                            {},
                            [&](const QRectF& card) { return hiddenBy(card, at, plot, layout); });
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
