// SPDX-License-Identifier: GPL-3.0-or-later
//
// A table of a million and a half edges getting its rows, as the window's thread does it. Needs no
// display.
#include <QApplication>
#include <QHeaderView>
#include <QTableView>

#include "ui/docks/seam_model.h"

#include <benchmark/benchmark.h>

using namespace trixel;
using namespace trixel::ui;

namespace {

void showReport(benchmark::State& state)
{
    auto report = std::make_shared<SeamReport>();
    report->jumps.resize(static_cast<std::size_t>(state.range(0)));
    SeamModel model;
    QTableView table;
    table.verticalHeader()->hide();
    table.verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    table.setModel(&model);
    table.resize(300, 400);
    table.show();
    for (auto _ : state) {
        model.setReport(report);
        QApplication::processEvents();
        benchmark::DoNotOptimize(table.grab());
        state.PauseTiming();
        model.setReport(nullptr);
        QApplication::processEvents();
        state.ResumeTiming();
    }
}

BENCHMARK(showReport)->Arg(1500)->Arg(1'500'000)->Unit(benchmark::kMillisecond);

} // namespace

int main(int argc, char** argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
