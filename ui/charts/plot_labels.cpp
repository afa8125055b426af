// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/plot_labels.h"

#include <QFontMetricsF>

#include "ui/charts/label_room.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace trixel::ui {

namespace {

/// Where a text may stand about its point: its direction, and how readily it is taken.
struct Side
{
    int x; ///< -1 left of the point, 1 right of it
    int y; ///< -1 above, 1 below
    double cost;
};

constexpr std::array kNameSides{Side{1, 0, 0},
                                Side{0, -1, 1},
                                Side{0, 1, 1},
                                Side{-1, 0, 1.5},
                                Side{1, -1, 1.5},
                                Side{1, 1, 1.5},
                                Side{-1, 1, 2},
                                Side{-1, -1, 2}};
/// Nothing lies below the front.
constexpr std::array kTagSides{Side{-1, 1, 0}, Side{0, 1, 1}, Side{-1, 0, 1}};

constexpr double kAway = 3;             ///< between a marker and its text
constexpr double kTagAway = 5;          ///< leaves room for the ring around the chosen point
constexpr double kMiddleCost = 4;       ///< of standing at a point within the curve, not at an end
constexpr double kMostCost = 14;        ///< rather no name than one over so much
constexpr std::size_t kMostPoints = 12; ///< of a curve that are tried

/// \param away  of the box from the point
QRectF boxAt(const QPointF& point, const QSizeF& size, const Side& side, double away)
{
    // A diagonal neighbour may come nearer.
    const double reach = side.x != 0 && side.y != 0 ? away * 0.6 : away;
    const QPointF middle(point.x() + side.x * (reach + size.width() / 2),
                         point.y() + side.y * (reach + size.height() / 2));
    return {QPointF(middle.x() - size.width() / 2, middle.y() - size.height() / 2), size};
}

struct Candidate
{
    QRectF box;
    double cost = LabelRoom::kImpossible;
};

template <std::size_t N>
void tryAround(const QPointF& point,
               const QSizeF& size,
               const std::array<Side, N>& sides,
               double away,
               double extra,
               const LabelRoom& room,
               Candidate& best)
{
    for (const Side& side : sides) {
        const QRectF box = boxAt(point, size, side, away);
        const double cost = extra + side.cost + room.cost(box);
        if (cost < best.cost) {
            best = {box, cost};
        }
    }
}

LabelRoom roomOf(const Plot& plot, const PlotLayout& layout)
{
    LabelRoom room(layout.frame);
    const double r = layout.markRadius;
    for (const PlotSeries& series : plot.series) {
        QPointF last;
        for (std::size_t p = 0; p < series.points.size(); ++p) {
            const QPointF at = layout.at(series.points[p]);
            room.take(QRectF(at.x() - r, at.y() - r, 2 * r, 2 * r));
            if (p > 0 && isCurve(series)) {
                room.take(QLineF(last, at));
            }
            last = at;
        }
    }
    if (plot.level) {
        const double y = layout.yAt(plot.level->y);
        room.take(QLineF(layout.frame.left(), y, layout.frame.right(), y));
    }
    return room;
}

/// At the right end of the line, above it where there is room.
QRectF levelNameBox(const Plot& plot, const QFontMetricsF& metrics, const PlotLayout& layout)
{
    const QSizeF size(metrics.horizontalAdvance(plot.level->name), metrics.height());
    const double y = layout.yAt(plot.level->y);
    const bool above = y - size.height() > layout.frame.top();
    return {QPointF(layout.frame.right() - size.width() - kAway, above ? y - size.height() : y + 1),
            size};
}

/// The ends of a curve, then points between them.
std::vector<std::size_t> pointsToTry(std::size_t count)
{
    std::vector<std::size_t> order{count - 1};
    if (count > 1) {
        order.push_back(0);
    }
    const std::size_t step = std::max<std::size_t>(1, count / kMostPoints);
    for (std::size_t p = step; p + 1 < count; p += step) {
        order.push_back(p);
    }
    return order;
}

void placeName(const Plot& plot,
               std::size_t s,
               const QFontMetricsF& metrics,
               LabelRoom& room,
               PlotLayout& layout)
{
    const PlotSeries& series = plot.series[s];
    if (series.points.empty()) {
        return;
    }
    const QSizeF size(metrics.horizontalAdvance(series.name), metrics.height() - 2);
    Candidate best;
    for (const std::size_t p : pointsToTry(series.points.size())) {
        const bool isEnd = p == 0 || p + 1 == series.points.size();
        tryAround(layout.at(series.points[p]),
                  size,
                  kNameSides,
                  layout.markRadius + kAway,
                  isEnd ? 0 : kMiddleCost,
                  room,
                  best);
    }
    if (best.cost <= kMostCost) {
        room.take(best.box);
        layout.labels.push_back({best.box, series.name, s, false});
    }
}

void placeTags(const Plot& plot, const QFontMetricsF& metrics, LabelRoom& room, PlotLayout& layout)
{
    for (const PlotMark mark : frontOf(plot)) {
        const PlotPoint& point = pointOf(plot, mark);
        if (point.tag.isEmpty()) {
            continue;
        }
        const QSizeF size(metrics.horizontalAdvance(point.tag), metrics.height() - 2);
        Candidate best;
        tryAround(layout.at(point), size, kTagSides, layout.markRadius + kTagAway, 0, room, best);
        if (best.cost <= kMostCost) {
            room.take(best.box);
            layout.labels.push_back({best.box, point.tag, mark.series, true});
        }
    }
}

} // namespace

void placeLabels(const Plot& plot, const PlotFonts& fonts, PlotLayout& layout)
{
    const QFontMetricsF metrics(fonts.small);
    LabelRoom room = roomOf(plot, layout);
    if (plot.level) {
        layout.levelName = levelNameBox(plot, metrics, layout);
        room.take(layout.levelName);
    }
    std::vector<std::size_t> order(plot.series.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    // Curves of few points have the fewest places to choose from; then the front has the first
    // word.
    std::ranges::stable_sort(order, {}, [&](std::size_t s) {
        const auto& points = plot.series[s].points;
        const bool onFront = std::ranges::any_of(points, &PlotPoint::onFront);
        return std::pair(std::min<std::size_t>(points.size(), 3), !onFront);
    });
    for (const std::size_t s : order) {
        placeName(plot, s, metrics, room, layout);
    }
    placeTags(plot, metrics, room, layout);
}

} // namespace trixel::ui
