// SPDX-License-Identifier: GPL-3.0-or-later
//
// What layers cost: a dab on one of them and what is shown brought up to date, on a small and on a
// large mesh; all of a mesh put together; and an edit that changes few faces of many.
#include "core/layers/compose.h"
#include "core/mesh/surface.h"
#include "core/paint/stroke.h"
#include "tests/core/test_meshes.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

using namespace trixel;

namespace {

constexpr TexelFormat kFormat{TexelType::UInt8, 3, std::nullopt};

/// A flat square of cells of side 1, so that meshes of any size look the same close up.
std::shared_ptr<const Surface> cells(std::uint32_t n)
{
    TriangleMesh mesh = test::gridMesh(n);
    for (glm::vec3& p : mesh.positions) {
        p = glm::round(p * static_cast<float>(n));
    }
    NoProgress progress;
    return *Surface::build(std::move(mesh), progress);
}

StrokeSample middleOf(std::uint32_t n)
{
    return {faceId(2 * std::size_t{n / 2 * n + n / 2}), {0.4F, 0.3F}};
}

/// A brush whose dab covers this many texels of cells at a level.
Brush brushOver(double texels, int level)
{
    const double perCell = 2.0 * Level(level).texelCount();
    Brush brush;
    brush.radius = static_cast<float>(std::sqrt(texels / perCell / 3.14159265));
    brush.flow = 0.5F;
    brush.color = {0.8F, 0.4F, 0.2F, 1};
    return brush;
}

TexelStore blank(std::uint32_t faces, int level)
{
    const std::vector<std::byte> fill(kFormat.texelBytes());
    return TexelStore(faces, kFormat, Level(level), fill);
}

/// Every texel of every `step`th face is written to: all of it covered about half.
void paint(TexelStore& store, std::uint32_t step)
{
    for (std::uint32_t f = 0; f < store.faceCount(); f += step) {
        const std::span<std::byte> texels = store.writable(faceId(f));
        std::memset(texels.data(), static_cast<int>(96 + f % 64), texels.size());
    }
}

LayerStack painted(std::uint32_t faces, int level, int layers, std::uint32_t step)
{
    LayerStack stack(blank(faces, level));
    paint(stack.texels(kBaseLayer), 1);
    for (int k = 0; k < layers; ++k) {
        const LayerBlend blend = k % 2 == 0 ? LayerBlend::Normal : LayerBlend::Multiply;
        paint(stack.texels(stack.insert(static_cast<std::size_t>(k), {"", 0.9F, blend, true})),
              step);
    }
    return stack;
}

/// A stack around the middle of the mesh, painted there as many times as there are layers, and the
/// rectangles of a dab of 3,000 texels of level 4 on its uppermost layer.
struct Dabbed
{
    Dabbed(std::uint32_t n, int layerCount)
        : surface(cells(n))
        , layers(blank(static_cast<std::uint32_t>(surface->mesh().faceCount()), 4))
    {
        for (int k = 0; k < layerCount; ++k) {
            top = layers.insert(static_cast<std::size_t>(k), {"", 0.9F, LayerBlend::Normal, true});
            Stroke wide(surface, brushOver(9000, 4), Ground::layer(), Threads{1});
            wide.add(middleOf(n), layers.texels(top));
        }
        NoProgress progress;
        shown = composed(layers, Threads{2}, progress)->shown;
        touched = Stroke(surface, brushOver(3000, 4), Ground::layer(), Threads{1})
                      .add(middleOf(n), layers.texels(top));
        recompose(layers, touched, shown, Threads{1}); // makes the faces writable
    }

    std::shared_ptr<const Surface> surface;
    LayerStack layers;
    LayerId top{};
    TexelStore shown;
    std::vector<TouchedRect> touched;
};

void dabOnLayer(benchmark::State& state)
{
    const auto n = static_cast<std::uint32_t>(state.range(0));
    Dabbed dabbed(n, 1);
    const Brush brush = brushOver(3000, 4);
    for (auto _ : state) {
        Stroke stroke(dabbed.surface, brush, Ground::layer(), Threads{1});
        benchmark::DoNotOptimize(stroke.add(middleOf(n), dabbed.layers.texels(dabbed.top)));
    }
    state.counters["triangles"] = static_cast<double>(dabbed.surface->mesh().faceCount());
}
BENCHMARK(dabOnLayer)->ArgName("cells")->Arg(71)->Arg(707)->Unit(benchmark::kMicrosecond);

void recomposeDab(benchmark::State& state)
{
    Dabbed dabbed(static_cast<std::uint32_t>(state.range(0)), static_cast<int>(state.range(1)));
    double texels = 0;
    for (const TouchedRect& rect : dabbed.touched) {
        texels += rect.width * rect.height;
    }
    for (auto _ : state) {
        recompose(dabbed.layers, dabbed.touched, dabbed.shown, Threads{1});
    }
    state.counters["triangles"] = static_cast<double>(dabbed.surface->mesh().faceCount());
    state.counters["texels"] = texels;
}
BENCHMARK(recomposeDab)
    ->ArgNames({"cells", "layers"})
    ->Args({71, 1})
    ->Args({707, 1})
    ->Args({71, 8})
    ->Args({707, 8})
    ->Unit(benchmark::kMicrosecond);

constexpr std::uint32_t kManyFaces = 1'000'000;

/// A million faces of 64 texels, every texel of every layer painted.
void composeAll(benchmark::State& state)
{
    const LayerStack layers = painted(kManyFaces, 3, static_cast<int>(state.range(0)), 1);
    NoProgress progress;
    for (auto _ : state) {
        benchmark::DoNotOptimize(composed(layers, Threads{1}, progress));
    }
    state.counters["texels_per_second"] =
        benchmark::Counter(64.0 * kManyFaces, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(composeAll)
    ->ArgName("layers")
    ->Arg(1)
    ->Arg(4)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

/// Four layers that paint one face in a hundred; one of them is made paler.
void recomposeFew(benchmark::State& state)
{
    LayerStack layers = painted(kManyFaces, 3, 4, 100);
    NoProgress progress;
    const Layered before = *composed(layers, Threads{2}, progress);
    const LayerId changed = layers.layers()[2].id;
    layers.set(changed, {"", 0.5F, LayerBlend::Normal, true});
    for (auto _ : state) {
        benchmark::DoNotOptimize(recomposed(layers, before, Threads{1}, progress));
    }
}
BENCHMARK(recomposeFew)->Unit(benchmark::kMillisecond);

} // namespace
