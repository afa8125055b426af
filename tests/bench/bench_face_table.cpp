// SPDX-License-Identifier: GPL-3.0-or-later
//
// The table of a million faces: what the window's thread waits for, and what is done behind it.
// Needs no display.
#include <QApplication>
#include <QScrollBar>
#include <QThread>
#include <QTimer>

#include "core/io/new_project.h"
#include "core/study/processor_clock.h"
#include "tests/ui/fixtures.h"
#include "ui/document/document.h"
#include "ui/document/face_selection.h"
#include "ui/document/inspection.h"
#include "ui/inspector/face_listing.h"
#include "ui/inspector/face_panel.h"
#include "ui/inspector/face_table_model.h"
#include "ui/inspector/face_table_view.h"
#include "ui/viewport/view_settings.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <memory>

using namespace trixel;
using namespace trixel::ui;

namespace {

constexpr int kCells = 708; // 1,002,528 faces

/// A panel on a million faces of levels 0 to 3, a tenth of them painted.
struct Shown
{
    Shown()
    {
        NoProgress progress;
        TriangleMesh mesh = gridMesh(kCells);
        LevelPlan plan = planUniform(mesh.faceCount(), Level(2));
        std::uint32_t random = 1;
        for (Level& level : plan.levels.values()) {
            random = random * 1664525U + 1013904223U;
            level = Level(static_cast<int>(random >> 30U));
        }
        const std::vector<float> fill{0.8F, 0.8F, 0.8F};
        Project project = newProject(std::move(mesh), plan, {}, fill, progress).value();
        for (std::uint32_t face = 0; face < project.texels.faceCount(); face += 10) {
            for (std::byte& byte : project.texels.writable(FaceId{face})) {
                random = random * 1664525U + 1013904223U;
                byte = static_cast<std::byte>(random >> 24U);
            }
        }
        document.open(std::move(project), {}, "million");
        panel.resize(900, 500);
        panel.show();
        wait();
        QApplication::processEvents();
    }
    /// Until nothing is being worked out and all is drawn.
    /// \return the longest turn of the window's thread meanwhile, in its own processor time, s
    double wait()
    {
        double longest = 0;
        QTimer alarm; // wakes the event loop
        alarm.start(1);
        for (int calm = 0; calm < 3; calm = panel.listing().isBusy() ? 0 : calm + 1) {
            const double begun = processorSeconds();
            QApplication::processEvents(QEventLoop::WaitForMoreEvents);
            longest = std::max(longest, processorSeconds() - begun);
        }
        return longest;
    }
    void draw() { benchmark::DoNotOptimize(panel.grab()); }

    Document document;
    FaceSelection selection{document};
    Inspection inspection{document};
    ViewSettings settings;
    BackgroundJobs jobs;
    FacePanel panel{document, selection, inspection, settings, jobs};
};

Shown& shown()
{
    static const auto kShown = std::make_unique<Shown>();
    return *kShown;
}

void measuring(benchmark::State& state)
{
    const Project project = shown().document.snapshot();
    NoProgress progress;
    for (auto _ : state) {
        benchmark::DoNotOptimize(FaceFigures::measure(
            project.surface->mesh(), project.texels, {}, Threads::all(), progress));
    }
}

void sorting(benchmark::State& state)
{
    const auto column = static_cast<FaceColumn>(state.range(0));
    state.SetLabel(std::string(nameOf(column)));
    NoProgress progress;
    for (auto _ : state) {
        benchmark::DoNotOptimize(arrangeFaces(
            shown().panel.listing().facts(), {column, true, {}}, Threads::all(), progress));
    }
}

void filtering(benchmark::State& state)
{
    const FaceFilter filter = parseFaceFilter("level>=2 mean<0.6 !constant").value();
    NoProgress progress;
    for (auto _ : state) {
        benchmark::DoNotOptimize(arrangeFaces(shown().panel.listing().facts(),
                                              {FaceColumn::Mean, false, filter},
                                              Threads::all(),
                                              progress));
    }
}

/// The longest turn of the window's thread while another order, of all or of other faces, comes
/// and is drawn.
void takingRows(benchmark::State& state)
{
    Shown& table = shown();
    const bool filters = state.range(0) != 0;
    state.SetLabel(filters ? "another filter" : "another order");
    bool turn = false;
    for (auto _ : state) {
        turn = !turn;
        if (filters) {
            table.panel.listing().setFilter(parseFaceFilter(turn ? "face>0" : "face>1").value());
        } else {
            table.panel.listing().sortBy(turn ? FaceColumn::Mean : FaceColumn::Face, turn);
        }
        state.SetIterationTime(table.wait());
    }
    table.panel.listing().setFilter({});
    table.panel.listing().sortBy(FaceColumn::Face, false);
    table.wait();
}

/// The same when a face was painted while rows are sorted by mean.
void painting(benchmark::State& state)
{
    Shown& table = shown();
    table.panel.listing().sortBy(FaceColumn::Mean, false);
    table.wait();
    std::uint32_t face = 0;
    for (auto _ : state) {
        face = (face + 123'457) % 1'000'000;
        table.document.fillFaces(std::array{FaceId{face}}, {1, 0, 0, 1});
        double longest = 0;
        for (int k = 0; k < 8; ++k) { // the figures come when painting rests
            longest = std::max(longest, table.wait());
            QThread::msleep(25);
        }
        state.SetIterationTime(longest);
    }
    table.panel.listing().sortBy(FaceColumn::Face, false);
    table.wait();
}

void scrolling(benchmark::State& state)
{
    Shown& table = shown();
    QScrollBar* bar = table.panel.table().verticalScrollBar();
    int row = 0;
    for (auto _ : state) {
        row = (row + 123'457) % bar->maximum();
        bar->setValue(row);
        table.draw();
    }
}

void hovering(benchmark::State& state)
{
    Shown& table = shown();
    std::uint32_t face = 0;
    for (auto _ : state) {
        face = (face + 123'457) % 1'000'000;
        table.inspection.pointAt(FaceId{face}, {0.3F, 0.3F});
        QApplication::processEvents();
    }
}

void selectingAll(benchmark::State& state)
{
    Shown& table = shown();
    const bool sorted = state.range(0) != 0;
    state.SetLabel(sorted ? "in the order of a column" : "in the order of the file");
    table.panel.listing().sortBy(sorted ? FaceColumn::Mean : FaceColumn::Face, sorted);
    table.wait();
    for (auto _ : state) {
        table.panel.table().selectAll();
        table.draw();
        state.PauseTiming();
        table.selection.clear();
        QApplication::processEvents();
        state.ResumeTiming();
    }
    table.panel.listing().sortBy(FaceColumn::Face, false);
    table.wait();
}

BENCHMARK(measuring)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK(sorting)->DenseRange(0, 9)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK(filtering)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK(takingRows)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseManualTime();
BENCHMARK(painting)->Iterations(5)->Unit(benchmark::kMillisecond)->UseManualTime();
BENCHMARK(scrolling)->Unit(benchmark::kMillisecond);
BENCHMARK(hovering)->Unit(benchmark::kMillisecond);
BENCHMARK(selectingAll)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

} // namespace

int main(int argc, char** argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
