// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/plot_layout.h"

#include <QFontMetricsF>
#include <QPolygonF>

#include "ui/charts/plot_labels.h"

#include <algorithm>
#include <cmath>

namespace trixel::ui {

namespace {

constexpr double kGap = 6;           ///< between parts
constexpr double kLegendSample = 26; ///< line and marker before a name
constexpr double kLegendSpace = 14;  ///< between columns of the legend
/// From here on the legend stands beside the plot, below it under it.
constexpr double kWide = 620;
constexpr double kMostLegendShare = 0.42;
/// A plot lower than this is left without a legend below it.
constexpr double kLeastFrameHeight = 110;
/// Room that a number on an axis wants.
constexpr double kTickWidth = 52;
constexpr double kTickHeight = 26;
/// Many points are drawn smaller.
constexpr std::size_t kMany = 400;
constexpr double kSmallMarkRadius = 2.8;
constexpr double kThinLine = 1; // painters draw these several times as fast

std::size_t countOf(const Plot& plot)
{
    std::size_t count = 0;
    for (const PlotSeries& series : plot.series) {
        count += series.points.size();
    }
    return count;
}

void makeAxes(const Plot& plot, PlotLayout& layout)
{
    std::vector<double> xs;
    std::vector<double> ys;
    for (const PlotSeries& series : plot.series) {
        for (const PlotPoint& point : series.points) {
            xs.push_back(point.x);
            ys.push_back(point.y);
        }
    }
    if (plot.level) {
        ys.push_back(plot.level->y);
    }
    if (!plot.x.list.empty()) {
        layout.xList = ListAxis(plot.x.list);
    }
    layout.xAxis = LogAxis(xs, plot.x.quantity, plot.x.decades);
    layout.yAxis = LogAxis(ys, plot.y.quantity, plot.y.decades);
}

/// Numbers as they find room in the frame; the frame's left side as the numbers need it.
void placeTicks(PlotLayout& layout, const PlotFonts& fonts)
{
    const QFontMetricsF metrics(fonts.small);
    layout.yTicks =
        layout.yAxis.ticks(std::max(2, static_cast<int>(layout.frame.height() / kTickHeight)));
    double widest = 0;
    for (const Tick& tick : layout.yTicks) {
        widest = std::max(widest, metrics.horizontalAdvance(tick.text));
    }
    layout.frame.setLeft(layout.edge + widest + kGap);
    const int across = std::max(2, static_cast<int>(layout.frame.width() / kTickWidth));
    layout.xTicks = layout.xList ? layout.xList->ticks(across) : layout.xAxis.ticks(across);
}

QString nameOfEntry(const Plot& plot, const LegendEntry& entry)
{
    return entry.series ? plot.series[*entry.series].name : plot.frontName;
}

std::vector<LegendEntry> legendOf(const Plot& plot, const PlotFonts& fonts)
{
    const QFontMetricsF metrics(fonts.small);
    std::vector<LegendEntry> legend;
    for (std::size_t s = 0; s < plot.series.size(); ++s) {
        legend.push_back({{}, s});
    }
    if (!plot.frontName.isEmpty()) {
        legend.push_back({{}, std::nullopt});
    }
    for (LegendEntry& entry : legend) {
        const double width = metrics.horizontalAdvance(nameOfEntry(plot, entry));
        entry.box = QRectF(0, 0, kLegendSample + width, metrics.height() + 2);
    }
    return legend;
}

/// In columns at the right; false where they would leave too little to the plot.
bool placeBeside(std::vector<LegendEntry>& legend, PlotLayout& layout)
{
    const double row = legend.front().box.height();
    const auto rows = static_cast<std::size_t>(std::max(1.0, layout.frame.height() / row));
    const std::size_t columns = (legend.size() + rows - 1) / rows;
    std::vector<double> widths(columns, 0);
    for (std::size_t k = 0; k < legend.size(); ++k) {
        widths[k / rows] = std::max(widths[k / rows], legend[k].box.width());
    }
    double width = kLegendSpace * static_cast<double>(columns);
    for (const double w : widths) {
        width += w;
    }
    if (width > layout.size.width() * kMostLegendShare) {
        return false;
    }
    layout.frame.setRight(layout.frame.right() - width);
    double left = layout.frame.right() + kLegendSpace;
    for (std::size_t k = 0; k < legend.size(); ++k) {
        if (k > 0 && k % rows == 0) {
            left += widths[k / rows - 1] + kLegendSpace;
        }
        legend[k].box.moveTopLeft({left, layout.frame.top() + row * static_cast<double>(k % rows)});
    }
    return true;
}

/// In rows under the plot; false where they would leave too little to it.
bool placeBelow(std::vector<LegendEntry>& legend, PlotLayout& layout)
{
    const double row = legend.front().box.height();
    const double right = layout.size.width() - layout.edge;
    QPointF at(layout.edge, 0);
    for (LegendEntry& entry : legend) {
        if (at.x() > layout.edge && at.x() + entry.box.width() > right) {
            at = {layout.edge, at.y() + row};
        }
        entry.box.moveTopLeft(at);
        at.rx() += entry.box.width() + kLegendSpace;
    }
    const double height = at.y() + row;
    if (layout.frame.height() - height - kGap < kLeastFrameHeight) {
        return false;
    }
    const double below = layout.size.height() - (layout.note.isValid() ? layout.note.height() : 0);
    for (LegendEntry& entry : legend) {
        entry.box.translate(0, below - layout.edge / 2 - height);
    }
    layout.frame.setBottom(layout.frame.bottom() - height - kGap);
    return true;
}

double wrappedHeight(const QFont& font, double width, const QString& text)
{
    const QRectF room(0, 0, width, 1000);
    return QFontMetricsF(font).boundingRect(room, Qt::TextWordWrap, text).height();
}

void placeTexts(const Plot& plot,
                const PlotFonts& fonts,
                const PlotParts& parts,
                PlotLayout& layout)
{
    const double width = layout.size.width() - 2 * layout.edge;
    double top = layout.edge;
    if (parts.heading) {
        const double title = wrappedHeight(fonts.title, width, plot.title);
        const double subtitle = wrappedHeight(fonts.text, width, plot.subtitle);
        layout.heading = QRectF(layout.edge, top, width, title + subtitle);
        top = layout.heading.bottom() + kGap;
    }
    double bottom = layout.size.height() - layout.edge;
    if (parts.note && !plot.note.isEmpty()) {
        const double height = wrappedHeight(fonts.small, width, plot.note) + kGap;
        layout.note = QRectF(layout.edge, bottom - height + kGap, width, height - kGap);
        bottom -= height;
    }
    const double axisTitle = QFontMetricsF(fonts.text).height();
    const double tickText = QFontMetricsF(fonts.small).height();
    layout.frame =
        QRectF(QPointF(layout.edge, top + axisTitle + kGap),
               QPointF(layout.size.width() - layout.edge, bottom - axisTitle - tickText - kGap));
}

} // namespace

PlotLayout
layOut(const Plot& plot, const QSizeF& size, const PlotFonts& fonts, const PlotParts& parts)
{
    PlotLayout layout;
    layout.size = size;
    if (countOf(plot) > kMany) {
        layout.markRadius = kSmallMarkRadius;
        layout.lineWidth = kThinLine;
    }
    makeAxes(plot, layout);
    placeTexts(plot, fonts, parts, layout);
    std::vector<LegendEntry> legend = legendOf(plot, fonts);
    if (!legend.empty()) {
        const bool beside = size.width() >= kWide && placeBeside(legend, layout);
        if (beside || placeBelow(legend, layout)) {
            layout.legend = std::move(legend);
        }
    }
    placeTicks(layout, fonts);
    placeLabels(plot, fonts, layout);
    return layout;
}

std::optional<PlotMark>
markAt(const Plot& plot, const PlotLayout& layout, const QPointF& position, double reach)
{
    std::optional<PlotMark> nearest;
    for (std::size_t s = 0; s < plot.series.size(); ++s) {
        for (std::size_t p = 0; p < plot.series[s].points.size(); ++p) {
            const QPointF away = layout.at(plot.series[s].points[p]) - position;
            const double distance = std::hypot(away.x(), away.y());
            if (distance <= reach) {
                reach = distance;
                nearest = PlotMark{s, p};
            }
        }
    }
    return nearest;
}

std::optional<std::size_t> legendSeriesAt(const PlotLayout& layout, const QPointF& position)
{
    const auto found = std::ranges::find_if(
        layout.legend, [&](const LegendEntry& entry) { return entry.box.contains(position); });
    return found != layout.legend.end() ? found->series : std::nullopt;
}

QPolygonF frontLine(const Plot& plot, const PlotLayout& layout)
{
    QPolygonF line;
    for (const PlotMark mark : frontOf(plot)) {
        const QPointF at = layout.at(pointOf(plot, mark));
        line += QPointF(at.x(), line.isEmpty() ? layout.frame.top() : line.last().y());
        line += at;
    }
    if (!line.isEmpty()) {
        line += QPointF(layout.frame.right(), line.last().y());
    }
    return line;
}

} // namespace trixel::ui
