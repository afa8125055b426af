// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the pointer moving over a mesh to the panels having drawn what is under it, as the window's
// thread does it. Needs no display: the view finds and describes the texel, but draws nothing.
// A panel of its own: add its dock's name to kDocks.
#include <QApplication>
#include <QDockWidget>
#include <QMouseEvent>
#include <QSettings>
#include <QTemporaryDir>

#include "core/study/processor_clock.h"
#include "tests/bench/sheet_project.h"
#include "ui/document/inspection.h"
#include "ui/viewport/viewport.h"
#include "ui/window/application.h"
#include "ui/window/main_window.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

using namespace trixel;
using namespace trixel::ui;

namespace {

const std::vector<std::string> kDocks{
    "readoutPanel", "layoutPanel", "mipPanel", "footprintPanel", "facesPanel", "lookPanel"};

/// Side by side, so that all can be seen at once: in the window's own layout tabs cover some.
void layOut(MainWindow& window)
{
    for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
        dock->hide();
    }
    for (const std::string& name : kDocks) {
        auto* dock = window.findChild<QDockWidget*>(QString::fromStdString(name));
        const bool isBelow = window.dockWidgetArea(dock) == Qt::BottomDockWidgetArea;
        window.removeDockWidget(dock);
        window.addDockWidget(isBelow ? Qt::BottomDockWidgetArea : Qt::RightDockWidgetArea,
                             dock,
                             isBelow ? Qt::Horizontal : Qt::Vertical);
    }
}

using Windows = std::map<int, std::unique_ptr<MainWindow>>;

MainWindow& windowOn(Windows& windows, int n)
{
    std::unique_ptr<MainWindow>& window = windows[n];
    if (!window) {
        window = std::make_unique<MainWindow>();
        window->resize(1920, 1080);
        window->show();
        layOut(*window);
        window->document().open(sheetProject(n, Level(1)), {}, "sheet");
        window->viewport().lookFrom(0, 0);
    }
    return *window;
}

void move(QWidget& widget, QPointF to)
{
    QMouseEvent event(
        QEvent::MouseMove, to, widget.mapToGlobal(to), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&widget, &event);
}

/// Until nothing is left to do that the move asked for: panels draw what they were told.
void drawAll()
{
    for (int k = 0; k < 4; ++k) {
        QCoreApplication::processEvents();
    }
}

void hover(benchmark::State& state, Windows& windows, const std::vector<std::string>& dockNames)
{
    MainWindow& window = windowOn(windows, static_cast<int>(state.range(0)));
    Viewport& view = window.viewport();
    QList<QDockWidget*> docks;
    for (const std::string& name : dockNames) {
        docks += window.findChild<QDockWidget*>(QString::fromStdString(name));
        docks.back()->show();
        docks.back()->raise();
    }
    drawAll();
    for (const QDockWidget* dock : docks) {
        if (!dock->widget()->isVisible() || dock->widget()->height() == 0) {
            state.SkipWithError("a panel cannot be seen");
        }
    }
    std::mt19937 random(7);
    std::vector<double> times;
    for (auto _ : state) {
        const auto part = [&random] {
            return 0.4 + 0.2 * (static_cast<double>(random()) / 4294967296.0);
        };
        const QPointF to(part() * view.width(), part() * view.height());
        const double began = processorSeconds(); // other programs do not count
        move(view, to);
        drawAll();
        times.push_back(1e3 * (processorSeconds() - began));
    }
    if (times.empty()) {
        return; // skipped
    }
    if (!window.inspection().isPointedAt()) {
        state.SkipWithError("the pointer is not on the surface");
    }
    std::ranges::sort(times);
    state.counters["faces"] = static_cast<double>(window.document().texels().faceCount());
    state.counters["p99_ms"] = times[times.size() * 99 / 100];
    state.counters["most_ms"] = times.back();
    for (QDockWidget* dock : docks) {
        dock->hide();
    }
}

} // namespace

int main(int argc, char** argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    prepareApplication();
    QApplication application(argc, argv);
    const QTemporaryDir settings;
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
    setUpApplication(application);
    Windows windows; // closed before the application ends
    benchmark::Initialize(&argc, argv);
    const auto add = [&windows](const std::string& name, const std::vector<std::string>& docks) {
        benchmark::RegisterBenchmark(
            ("hover/" + name).c_str(),
            [&windows, docks](benchmark::State& state) { hover(state, windows, docks); })
            ->Arg(71)
            ->Arg(707)
            ->Unit(benchmark::kMillisecond);
    };
    for (const std::string& dock : kDocks) {
        add(dock, {dock});
    }
    add("all", kDocks);
    benchmark::RunSpecifiedBenchmarks();
}
