// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/stability_plot.h"

#include <cmath>

namespace trixel::ui {

namespace {

constexpr int kNaiveLook = 1;
/// Errors from rounding to nonsense.
constexpr double kErrorDecades = 45;

QString text(const std::string& utf8)
{
    return QString::fromStdString(utf8);
}

QString errorText(double error)
{
    return std::isinf(error) ? QString(QChar(0x221E)) : quantityText(error, Quantity::Number, 2);
}

} // namespace

Plot plotOf(const StabilitySweep& sweep)
{
    Plot plot;
    plot.title = text(sweep.title);
    plot.subtitle = text(sweep.property);
    plot.note = text(sweep.hazard);
    plot.x.title = text(sweep.axisTitle);
    for (const SweepValue& value : sweep.values) {
        plot.x.list.push_back(text(value.label));
    }
    plot.y = {text(sweep.errorTitle), Quantity::Number, kErrorDecades, {}};
    plot.level = {sweep.bound, "Bound " + errorText(sweep.bound)};
    int ours = 0;
    for (std::size_t c = 0; c < sweep.curves.size(); ++c) {
        const StabilityCurve& curve = sweep.curves[c];
        // Ours take all looks but the textbook's.
        const int look = curve.naive ? kNaiveLook : (ours == 0 ? 0 : ours + 1);
        ours += curve.naive ? 0 : 1;
        PlotSeries series{text(curve.form), look, false, {}};
        for (std::size_t v = 0; v < curve.errors.size(); ++v) {
            series.points.push_back({static_cast<double>(v),
                                     curve.errors[v],
                                     c * sweep.values.size() + v,
                                     QString(),
                                     false});
        }
        plot.series.push_back(std::move(series));
    }
    return plot;
}

QStringList describe(const StabilitySweep& sweep, std::size_t source)
{
    const StabilityCurve& curve = sweep.curves[source / sweep.values.size()];
    const std::size_t value = source % sweep.values.size();
    const double error = curve.errors[value];
    QStringList lines{text(curve.form)};
    lines += text(sweep.axisTitle) + ": " + text(sweep.values[value].label);
    lines += text(sweep.errorTitle) + ": " +
             (std::isinf(error) ? QString("no usable answer") : errorText(error));
    lines += error <= sweep.bound ? QString("within the bound") : QString("beyond the bound");
    return lines;
}

QString worstText(const StabilitySweep& sweep, bool naive)
{
    return errorText(sweep.worst(naive));
}

} // namespace trixel::ui
