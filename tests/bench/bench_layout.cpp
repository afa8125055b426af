// SPDX-License-Identifier: GPL-3.0-or-later
//
// The layout dock as the window's thread draws it: a face of 4096² texels opened, moved and zoomed,
// and the texel looked at going from face to face of a million. Needs no display and no vsync.
#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>

#include "core/io/new_project.h"
#include "tests/core/test_meshes.h"
#include "ui/document/document.h"
#include "ui/document/face_selection.h"
#include "ui/document/inspection.h"
#include "ui/inspector/layout_panel.h"
#include "ui/viewport/view_settings.h"

#include <benchmark/benchmark.h>

#include <memory>
#include <random>

using namespace trixel;
using namespace trixel::ui;

namespace {

FaceTexels noiseFace(Level level, unsigned seed)
{
    std::mt19937 random(seed);
    std::vector<std::byte> bytes(3 * std::size_t{level.texelCount()});
    for (std::byte& byte : bytes) {
        byte = static_cast<std::byte>(random() & 0xffU);
    }
    return FaceTexels::full(level, 3, bytes);
}

/// A dock of the size that it has below the view.
struct Dock
{
    Dock(TriangleMesh mesh, Level level, std::size_t painted, Level paintedLevel)
        : selection(document)
        , inspection(document)
        , panel(document, settings, inspection, selection)
    {
        NoProgress progress;
        const LevelPlan plan = planUniform(mesh.faceCount(), level);
        const std::vector<float> fill{0.5F, 0.5F, 0.5F};
        Project project = newProject(std::move(mesh), plan, {}, fill, progress).value();
        for (std::size_t k = 0; k < painted; ++k) {
            (void)project.texels.exchange(faceId(k),
                                          noiseFace(paintedLevel, static_cast<unsigned>(k)));
        }
        document.open(std::move(project), {}, "bench");
        panel.resize(1100, 360);
        panel.show();
        QApplication::processEvents();
    }

    void paint()
    {
        for (const LayoutKind kind :
             {LayoutKind::Net, LayoutKind::Packed, LayoutKind::Rectilinear}) {
            panel.view(kind).repaint();
        }
    }

    Document document;
    FaceSelection selection;
    ViewSettings settings;
    Inspection inspection;
    LayoutPanel panel;
};

/// Made when first used; gone before the application is.
struct Docks
{
    std::unique_ptr<Dock> large;
    std::unique_ptr<Dock> many;
};

Docks& docks()
{
    static Docks all;
    return all;
}

Dock& largeFaces()
{
    std::unique_ptr<Dock>& dock = docks().large;
    if (!dock) {
        dock = std::make_unique<Dock>(test::gridMesh(2), Level(2), 1, Level(12));
    }
    return *dock;
}

/// 1,002,528 faces, the first of them painted.
constexpr std::size_t kPainted = 4000;
Dock& manyFaces()
{
    std::unique_ptr<Dock>& dock = docks().many;
    if (!dock) {
        dock = std::make_unique<Dock>(test::gridMesh(708), Level(3), kPainted, Level(5));
    }
    return *dock;
}

/// From nothing kept of the face to its first picture in all three views.
void openLargeFace(benchmark::State& state)
{
    Dock& dock = largeFaces();
    for (auto _ : state) {
        state.PauseTiming();
        dock.inspection.pointAt(FaceId{7}, {0.2F, 0.2F});
        dock.panel.hide(); // forgets
        dock.panel.show();
        QApplication::processEvents();
        state.ResumeTiming();
        dock.inspection.pointAt(FaceId{0}, {0.3F, 0.3F});
        dock.paint();
    }
}

/// The same until all levels are reduced, which else happens in the background.
void openLargeFaceWhole(benchmark::State& state)
{
    Dock& dock = largeFaces();
    for (auto _ : state) {
        state.PauseTiming();
        dock.inspection.pointAt(FaceId{7}, {0.2F, 0.2F});
        dock.panel.hide();
        dock.panel.show();
        QApplication::processEvents();
        state.ResumeTiming();
        dock.inspection.pointAt(FaceId{0}, {0.3F, 0.3F});
        dock.panel.complete();
        dock.paint();
    }
}

/// One frame of moving a view. \param state  times as large as the whole face
void panLargeFace(benchmark::State& state)
{
    Dock& dock = largeFaces();
    dock.inspection.pointAt(FaceId{0}, {0.3F, 0.3F});
    dock.panel.complete();
    dock.panel.frameAll();
    const auto zoom = static_cast<double>(state.range(0));
    for (const LayoutKind kind : {LayoutKind::Net, LayoutKind::Packed, LayoutKind::Rectilinear}) {
        dock.panel.view(kind).zoomBy(zoom);
    }
    dock.paint();
    double moved = 1;
    for (auto _ : state) {
        moved = -moved;
        for (const LayoutKind kind :
             {LayoutKind::Net, LayoutKind::Packed, LayoutKind::Rectilinear}) {
            dock.panel.view(kind).zoomBy(1 + moved / 1000);
        }
        dock.paint();
    }
}

/// The texel looked at goes on, in the same face or (1) to any other.
void hover(benchmark::State& state)
{
    Dock& dock = manyFaces();
    const bool anyFace = state.range(0) != 0;
    std::mt19937 random(1);
    for (auto _ : state) {
        // Painted ones cost most.
        const FaceId face = faceId(anyFace ? random() % kPainted : 77);
        const auto texel = texelAt(Level(5), static_cast<TexelIndex>(random() % 1024));
        dock.inspection.pointAt(TexelPlace{face, texel});
        dock.paint();
    }
}

BENCHMARK(openLargeFace)->Unit(benchmark::kMillisecond);
BENCHMARK(openLargeFaceWhole)->Unit(benchmark::kMillisecond);
BENCHMARK(panLargeFace)->Arg(1)->Arg(8)->Arg(64)->Arg(512)->Unit(benchmark::kMillisecond);
BENCHMARK(hover)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

} // namespace

int main(int argc, char** argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QTemporaryDir settings;
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
    const QApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    docks() = {};
}
