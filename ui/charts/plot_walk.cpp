// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/plot_walk.h"

#include <algorithm>
#include <cmath>

namespace trixel::ui {

namespace {

/// How far two places are apart on a logarithmic axis.
double apart(double a, double b)
{
    constexpr double kTiny = 1e-300;
    return std::abs(std::log(std::max(a, kTiny)) - std::log(std::max(b, kTiny)));
}

std::optional<PlotMark> firstOf(const Plot& plot)
{
    const std::vector<PlotMark> front = frontOf(plot);
    if (!front.empty()) {
        return front.front();
    }
    for (std::size_t s = 0; s < plot.series.size(); ++s) {
        if (!plot.series[s].points.empty()) {
            return PlotMark{s, 0};
        }
    }
    return std::nullopt;
}

PlotMark onCurve(const Plot& plot, PlotMark from, bool forward)
{
    const std::size_t last = plot.series[from.series].points.size() - 1;
    if (forward) {
        return {from.series, std::min(from.point + 1, last)};
    }
    return {from.series, from.point > 0 ? from.point - 1 : 0};
}

PlotMark onOtherCurve(const Plot& plot, PlotMark from, bool forward)
{
    const std::size_t count = plot.series.size();
    const double x = pointOf(plot, from).x;
    for (std::size_t k = 1; k <= count; ++k) {
        const std::size_t s = (from.series + (forward ? k : count - k % count)) % count;
        const auto& points = plot.series[s].points;
        if (!points.empty() && s != from.series) {
            const auto nearest = std::ranges::min_element(
                points, {}, [&](const PlotPoint& p) { return apart(p.x, x); });
            return {s, static_cast<std::size_t>(nearest - points.begin())};
        }
    }
    return from;
}

PlotMark onFront(const Plot& plot, PlotMark from, bool forward)
{
    const std::vector<PlotMark> front = frontOf(plot);
    if (front.empty()) {
        return from;
    }
    const auto at = std::ranges::find(front, from);
    if (at == front.end()) {
        const double x = pointOf(plot, from).x;
        return *std::ranges::min_element(
            front, {}, [&](PlotMark mark) { return apart(pointOf(plot, mark).x, x); });
    }
    if (forward) {
        return at + 1 != front.end() ? *(at + 1) : *at;
    }
    return at != front.begin() ? *(at - 1) : *at;
}

} // namespace

std::optional<PlotMark> step(const Plot& plot, std::optional<PlotMark> from, PlotStep step)
{
    const std::optional<PlotMark> first = firstOf(plot);
    if (!from || !first) {
        return first;
    }
    switch (step) {
    case PlotStep::NextOnCurve:
    case PlotStep::LastOnCurve:
        return onCurve(plot, *from, step == PlotStep::NextOnCurve);
    case PlotStep::NextCurve:
    case PlotStep::LastCurve:
        return onOtherCurve(plot, *from, step == PlotStep::NextCurve);
    case PlotStep::NextOnFront:
    case PlotStep::LastOnFront:
        return onFront(plot, *from, step == PlotStep::NextOnFront);
    case PlotStep::FrontStart:
        return first;
    case PlotStep::FrontEnd:
        break;
    }
    const std::vector<PlotMark> front = frontOf(plot);
    return front.empty() ? first : std::optional(front.back());
}

} // namespace trixel::ui
