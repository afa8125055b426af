// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/study_plot.h"

#include <QLocale>

#include <algorithm>
#include <array>
#include <cmath>

namespace trixel::ui {

namespace {

/// Errors further below the largest are those of rounding: they count as none.
constexpr double kErrorDecades = 5;
constexpr double kCostDecades = 12;

QString dot()
{
    return QString::fromUtf8(" · ");
}

QString text(std::string_view utf8)
{
    return QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()));
}

double errorOf(const StudyPoint& point, ErrorMeasure measure)
{
    return measure == ErrorMeasure::Rms ? point.rms : point.p99;
}

bool isShown(const StudyPoint& point, const StudyView& view)
{
    const double error = errorOf(point, view.measure);
    return point.footprintClass == view.footprintClass && std::isfinite(point.cost) &&
           point.cost >= 0 && std::isfinite(error) && error >= 0;
}

/// What tells a point from the others of its series.
QString tagOf(const StudyPoint& point)
{
    return point.method && point.method->parameter
               ? QString::number(*point.method->parameter, 'g', 4)
               : QString();
}

/// Methods keep their number in the table, all else follows in order of appearance.
int lookOf(const StudyPoint& point, int& others)
{
    const auto methods = filterMethods();
    if (point.method) {
        const auto found = std::ranges::find(methods, point.method->name, &MethodEntry::name);
        if (found != methods.end()) {
            return static_cast<int>(found - methods.begin());
        }
    }
    return static_cast<int>(methods.size()) + others++;
}

PlotSeries& seriesOf(Plot& plot, const StudyPoint& point, int& others)
{
    const QString name = text(point.series);
    const auto found = std::ranges::find(plot.series, name, &PlotSeries::name);
    if (found != plot.series.end()) {
        return *found;
    }
    plot.series.push_back({name, lookOf(point, others), !point.method, {}});
    return plot.series.back();
}

void markFront(Plot& plot)
{
    std::vector<PlotPoint*> points;
    for (PlotSeries& series : plot.series) {
        for (PlotPoint& point : series.points) {
            points.push_back(&point);
        }
    }
    std::ranges::sort(points, {}, [](const PlotPoint* p) { return std::array{p->x, p->y}; });
    const PlotPoint* last = nullptr;
    for (PlotPoint* point : points) {
        const bool equalsLast = last != nullptr && point->x == last->x && point->y == last->y;
        if (last == nullptr || point->y < last->y || equalsLast) {
            point->onFront = true;
            last = point;
        }
    }
}

/// The same choice with its parameter written out.
MethodChoice withParameter(MethodChoice choice)
{
    const MethodEntry* entry = findMethod(choice.name);
    if (!choice.parameter && entry != nullptr && entry->parameter) {
        choice.parameter = entry->parameter->standard;
    }
    return choice;
}

QString whoIs(const StudyPoint& point)
{
    QString who = text(point.series);
    if (point.method) {
        if (const MethodEntry* entry = findMethod(point.method->name)) {
            who = text(entry->title);
        }
    }
    return point.variant.empty() ? who : who + dot() + text(point.variant);
}

QString costText(const Study& study, double cost)
{
    const Quantity quantity = quantityOf(study.costUnit);
    const QString number = quantityText(cost, quantity);
    return quantity == Quantity::Number ? number + QChar(0x00A0) + text(study.costUnit) : number;
}

QString costTitle(const Study& study)
{
    const QString title = text(study.costTitle);
    return quantityOf(study.costUnit) == Quantity::Number && !study.costUnit.empty()
               ? title + " (" + text(study.costUnit) + ")"
               : title;
}

} // namespace

QString nameOf(ErrorMeasure measure)
{
    return measure == ErrorMeasure::Rms ? QString("RMS error")
                                        : QString("99th percentile of error");
}

QString nameOf(const std::optional<FootprintClass>& footprintClass)
{
    if (!footprintClass) {
        return "All footprints";
    }
    QString name = text(trixel::nameOf(*footprintClass));
    name[0] = name[0].toUpper();
    return name;
}

Plot plotOf(const Study& study, const StudyView& view)
{
    Plot plot;
    plot.title = text(study.title);
    plot.subtitle = text(study.subject) + dot() + nameOf(view.footprintClass);
    plot.note = text(study.conditions);
    plot.x = {costTitle(study), quantityOf(study.costUnit), kCostDecades};
    plot.y = {nameOf(view.measure), Quantity::Fraction, kErrorDecades};
    plot.frontName = "Pareto front";
    if (view.tolerance) {
        plot.level = {*view.tolerance,
                      "Tolerance " + quantityText(*view.tolerance, plot.y.quantity)};
    }
    int others = 0;
    for (std::size_t k = 0; k < study.points.size(); ++k) {
        const StudyPoint& point = study.points[k];
        if (isShown(point, view)) {
            seriesOf(plot, point, others)
                .points.push_back(
                    {point.cost, errorOf(point, view.measure), k, tagOf(point), false});
        }
    }
    // A study without methods compares equals.
    if (std::ranges::all_of(plot.series, &PlotSeries::isPeer)) {
        std::ranges::for_each(plot.series, [](PlotSeries& series) { series.isPeer = false; });
    }
    std::ranges::stable_sort(plot.series, {}, &PlotSeries::look);
    markFront(plot);
    return plot;
}

std::vector<std::optional<FootprintClass>> classesOf(const Study& study)
{
    std::vector<std::optional<FootprintClass>> classes;
    const auto add = [&](std::optional<FootprintClass> one) {
        if (std::ranges::any_of(study.points,
                                [&](const StudyPoint& p) { return p.footprintClass == one; })) {
            classes.push_back(one);
        }
    };
    add(std::nullopt);
    std::ranges::for_each(footprintClasses(), add);
    return classes;
}

std::optional<PlotMark> markOf(const Study& study, const Plot& plot, const MethodChoice& method)
{
    const MethodChoice wanted = withParameter(method);
    for (std::size_t s = 0; s < plot.series.size(); ++s) {
        for (std::size_t p = 0; p < plot.series[s].points.size(); ++p) {
            const auto& found = study.points[plot.series[s].points[p].source].method;
            if (found && withParameter(*found) == wanted) {
                return PlotMark{s, p};
            }
        }
    }
    return std::nullopt;
}

std::optional<std::size_t> cheapestWithin(const Study& study, const StudyView& view)
{
    std::optional<std::size_t> best;
    for (const PlotSeries& series : plotOf(study, view).series) {
        for (const PlotPoint& point : series.points) {
            if (!series.isPeer && view.tolerance && point.y <= *view.tolerance &&
                (!best || point.x < study.points[*best].cost)) {
                best = point.source;
            }
        }
    }
    return best;
}

QString inBrief(const Study& study, std::size_t point)
{
    const StudyPoint& p = study.points[point];
    const QString who = text(p.series) + (p.variant.empty() ? "" : ", " + text(p.variant));
    return who + dot() + costText(study, p.cost);
}

QStringList describe(const Study& study, std::size_t point)
{
    const StudyPoint& p = study.points[point];
    const auto percent = [](double error) { return quantityText(error, Quantity::Fraction); };
    QStringList lines{whoIs(p)};
    lines += costText(study, p.cost) + dot() + "RMS " + percent(p.rms);
    lines += "99 % below " + percent(p.p99) + dot() + "worst " + percent(p.worst);
    lines += QLocale(QLocale::English).toString(static_cast<qulonglong>(p.samples)) + " samples" +
             dot() + nameOf(p.footprintClass).toLower();
    return lines;
}

} // namespace trixel::ui
