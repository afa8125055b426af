// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a context that is lost to the view complete again: what was on the card is made anew from
// mesh and store. Needs a display with OpenGL; see README.md for how to run it.
#include <QApplication>
#include <QOpenGLWidget>

#include "tests/bench/sheet_project.h"
#include "ui/document/document.h"
#include "ui/viewport/view_settings.h"
#include "ui/viewport/viewport.h"
#include "ui/window/application.h"

#include <benchmark/benchmark.h>

using namespace trixel;
using namespace trixel::ui;

namespace {

void loseContext(QOpenGLWidget& canvas)
{
    for (const QEvent::Type type :
         {QEvent::WindowAboutToChangeInternal, QEvent::WindowChangeInternal}) {
        QEvent event(type);
        QCoreApplication::sendEvent(&canvas, &event);
    }
}

/// \param state  sides of the sheet, and the level of its faces
void lost(benchmark::State& state)
{
    Document document;
    ViewSettings settings;
    Viewport view(document, settings);
    view.resize(1280, 800);
    view.show();
    document.open(
        sheetProject(static_cast<int>(state.range(0)), Level(static_cast<int>(state.range(1)))),
        {},
        "sheet");
    QCoreApplication::processEvents();
    view.settle();
    const QImage before = view.grabFramebuffer();
    QImage after;
    for (auto _ : state) {
        loseContext(*view.findChild<QOpenGLWidget*>());
        view.settle();
        after = view.grabFramebuffer();
    }
    if (before.isNull() || after != before) {
        state.SkipWithError("the view is not what it was");
    }
    state.counters["faces"] = static_cast<double>(document.texels().faceCount());
    state.counters["texels"] = static_cast<double>(document.texels().texelCount());
}
BENCHMARK(lost)
    ->Args({71, 3})
    ->Args({707, 1})
    ->Args({707, 3})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

} // namespace

int main(int argc, char** argv)
{
    prepareApplication();
    const QApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
