// SPDX-License-Identifier: GPL-3.0-or-later
//
// Laying out and painting charts of many points, as the window's thread does it. Needs no display.
#include <QApplication>
#include <QPainter>
#include <QPixmap>

#include "ui/charts/plot_layout.h"
#include "ui/charts/plot_painter.h"
#include "ui/docks/chart_view.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

using namespace trixel::ui;

namespace {

constexpr QSize kSize(1000, 420);

/// Twenty methods of as many points each; the first are curves, the last four are peers.
Plot crowded(std::size_t points)
{
    constexpr std::size_t kSeries = 20;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> spread(-0.05, 0.05);
    Plot plot;
    plot.x = {"Time per sample", Quantity::Nanoseconds};
    plot.y = {"RMS error", Quantity::Fraction};
    plot.frontName = "Front";
    for (std::size_t s = 0; s < kSeries; ++s) {
        PlotSeries series;
        series.name = QString("method %1").arg(s + 1);
        series.look = static_cast<int>(s);
        series.isPeer = s >= kSeries - 4;
        const std::size_t count = points / kSeries;
        for (std::size_t p = 0; p < count; ++p) {
            const double along = static_cast<double>(p) / static_cast<double>(count);
            series.points.push_back({std::pow(10, 1 + 3 * along + spread(random)),
                                     std::pow(10, -1 - 3 * along + spread(random)),
                                     s * count + p,
                                     {},
                                     s == 3 && p % 20 == 0});
        }
        plot.series.push_back(std::move(series));
    }
    return plot;
}

void layOutPlot(benchmark::State& state)
{
    const Plot plot = crowded(static_cast<std::size_t>(state.range(0)));
    const PlotFonts fonts{QFont()};
    for (auto _ : state) {
        benchmark::DoNotOptimize(layOut(plot, kSize, fonts, {.heading = false, .note = false}));
    }
}

void paintPlotAtTwiceThePixels(benchmark::State& state)
{
    constexpr double kRatio = 2;
    const Plot plot = crowded(static_cast<std::size_t>(state.range(0)));
    const PlotFonts fonts{QFont()};
    const PlotLayout layout = layOut(plot, kSize, fonts, {.heading = false, .note = false});
    PlotLook look;
    look.theme = darkPlotTheme();
    for (auto _ : state) {
        QPixmap picture(kSize * kRatio);
        picture.setDevicePixelRatio(kRatio);
        QPainter painter(&picture);
        paintPlot(painter, plot, layout, fonts, look);
    }
}

BENCHMARK(layOutPlot)->Arg(200)->Arg(2000)->Unit(benchmark::kMillisecond);
BENCHMARK(paintPlotAtTwiceThePixels)->Arg(200)->Arg(2000)->Unit(benchmark::kMillisecond);

} // namespace

int main(int argc, char** argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
