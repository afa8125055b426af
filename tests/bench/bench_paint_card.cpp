// SPDX-License-Identifier: GPL-3.0-or-later
//
// The same dabs and fills by the graphics card, into the sheet that the view shows, and by the
// processor, into the store. Needs a display with OpenGL; see README.md for how to run it.
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>

#include "core/paint/dab_painter.h"
#include "render/paint_preview.h"
#include "tests/core/test_meshes.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>

using namespace trixel;
using namespace trixel::render;

namespace {

/// What every benchmark draws with.
struct Card
{
    QOffscreenSurface surface;
    QOpenGLContext context;
    std::unique_ptr<Gl> gl;

    Card()
    {
        QSurfaceFormat format;
        format.setVersion(4, 1);
        format.setProfile(QSurfaceFormat::CoreProfile);
        surface.setFormat(format);
        surface.create();
        context.setFormat(format);
        if (context.create() && context.makeCurrent(&surface)) {
            gl = currentGl();
        }
    }
};

/// A flat sheet of cells of side 1 at a level; `dab` covers about so many texels of its middle.
struct Sheet
{
    TriangleMesh mesh;
    TexelStore store;
    PlacedDab dab;

    Sheet(double texels, int level)
    {
        const double perCell = 2.0 * Level(level).texelCount();
        const double radius = std::sqrt(texels / perCell / 3.14159265);
        const auto cells = static_cast<std::uint32_t>(std::ceil(2 * radius)) + 2;
        mesh = test::gridMesh(cells);
        for (glm::vec3& p : mesh.positions) {
            p *= static_cast<float>(cells);
        }
        const TexelFormat format{TexelType::UInt8, 3, std::nullopt};
        store = TexelStore(static_cast<std::uint32_t>(mesh.faceCount()),
                           format,
                           Level(level),
                           std::vector<std::byte>(3));
        const float middle = 0.5F * static_cast<float>(cells);
        dab.dab = {{middle, middle, 0}, {0, 0, 1}, static_cast<float>(radius), 1};
        for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
            (void)store.writable(faceId(f));
            dab.faces.push_back(faceId(f));
        }
    }
};

/// \param state  texels, level; the second dab of a stroke, so that squares and tiles are there
void processorDab(benchmark::State& state)
{
    Sheet sheet(static_cast<double>(state.range(0)), static_cast<int>(state.range(1)));
    const std::array<float, 3> color{1, 0.5F, 0};
    DabPainter painter(sheet.store.format(), color, 0.3F, 0.1F, Threads::all());
    painter.paint(sheet.dab.dab, sheet.mesh, sheet.dab.faces, sheet.store);
    for (auto _ : state) {
        painter.paint(sheet.dab.dab, sheet.mesh, sheet.dab.faces, sheet.store);
    }
}

/// \param state  texels, level, dabs drawn together
void cardDab(benchmark::State& state, Card* card)
{
    const Sheet sheet(static_cast<double>(state.range(0)), static_cast<int>(state.range(1)));
    const auto together = static_cast<std::size_t>(state.range(2));
    auto preview = PaintPreview::create(*card->gl);
    if (!preview) {
        state.SkipWithError(preview.error().message.c_str());
        return;
    }
    (*preview)->begin(sheet.mesh.faceCount(), {{1, 0.5F, 0}, {0.3F, 0.1F}, true});
    const std::vector<PlacedDab> dabs(together, sheet.dab);
    (*preview)->add(sheet.mesh, sheet.store, dabs);
    card->gl->glFinish();
    for (auto _ : state) {
        (*preview)->add(sheet.mesh, sheet.store, dabs);
        card->gl->glFinish();
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(together) * state.iterations());
}

void processorFill(benchmark::State& state)
{
    const Sheet sheet(1, 3);
    const auto cells = static_cast<std::uint32_t>(state.range(0));
    const TriangleMesh mesh = test::gridMesh(cells);
    std::vector<FaceId> faces;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        faces.push_back(faceId(f));
    }
    const std::vector<std::byte> black(3);
    const std::vector<std::byte> white(3, std::byte{255});
    const TexelStore untouched(
        static_cast<std::uint32_t>(mesh.faceCount()), sheet.store.format(), Level(6), black);
    for (auto _ : state) {
        TexelStore store = untouched;
        benchmark::DoNotOptimize(fillFaces(store, faces, white));
    }
}

void cardFill(benchmark::State& state, Card* card)
{
    const auto cells = static_cast<std::uint32_t>(state.range(0));
    std::vector<FaceId> faces;
    for (std::size_t f = 0; f < 2 * std::size_t{cells} * cells; ++f) {
        faces.push_back(faceId(f));
    }
    auto preview = PaintPreview::create(*card->gl);
    for (auto _ : state) {
        (*preview)->begin(faces.size(), {{1, 1, 1}, {1, 1}, true});
        (*preview)->fill(faces);
        card->gl->glFinish();
    }
}

} // namespace

int main(int argc, char** argv)
{
    QGuiApplication application(argc, argv);
    auto card = std::make_unique<Card>();
    if (!card->gl) {
        return 1;
    }
    const auto plain = [](const char* name, auto work) {
        return benchmark::RegisterBenchmark(name, work)
            ->Unit(benchmark::kMillisecond)
            ->MeasureProcessCPUTime()
            ->UseRealTime();
    };
    for (const std::int64_t texels : {10'000, 100'000, 1'000'000, 10'000'000}) {
        plain("processorDab", processorDab)->ArgNames({"texels", "level"})->Args({texels, 6});
        for (const int together : {1, 16}) {
            plain("cardDab", [&card](benchmark::State& state) { cardDab(state, card.get()); })
                ->ArgNames({"texels", "level", "dabs"})
                ->Args({texels, 6, together});
        }
    }
    plain("processorDab", processorDab)->ArgNames({"texels", "level"})->Args({1'000'000, 3});
    plain("cardDab", [&card](benchmark::State& state) { cardDab(state, card.get()); })
        ->ArgNames({"texels", "level", "dabs"})
        ->Args({1'000'000, 3, 1});
    for (const std::int64_t cells : {70, 700}) {
        plain("processorFill", processorFill)->ArgName("cells")->Arg(cells);
        plain("cardFill", [&card](benchmark::State& state) { cardFill(state, card.get()); })
            ->ArgName("cells")
            ->Arg(cells);
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    card.reset();
    return 0;
}
