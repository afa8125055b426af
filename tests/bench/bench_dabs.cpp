// SPDX-License-Identifier: GPL-3.0-or-later
//
// What painting costs: one dab by texel type and threads, the same dab on a small and on a large
// mesh, whole strokes by the slowest of their samples, and the hierarchy they stand on.
#include "core/mesh/bvh.h"
#include "core/mesh/surface.h"
#include "core/paint/stroke.h"
#include "tests/core/test_meshes.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <memory>
#include <vector>

using namespace trixel;

namespace {

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

TexelStore blank(const Surface& surface, TexelType type, int level)
{
    const TexelFormat format{type, 3, std::nullopt};
    const std::vector<std::byte> fill(format.texelBytes());
    return TexelStore(
        static_cast<std::uint32_t>(surface.mesh().faceCount()), format, Level(level), fill);
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

/// One dab of about so many texels as the first of its stroke: everything it touches is new to it.
void dab(benchmark::State& state, TexelType type)
{
    const auto threads = static_cast<unsigned>(state.range(0));
    const int level = static_cast<int>(state.range(1));
    constexpr std::uint32_t kCells = 300;
    const auto texels = static_cast<double>(state.range(2));
    const auto surface = cells(kCells);
    TexelStore store = blank(*surface, type, level);
    const Brush brush = brushOver(texels, level);
    const std::vector<std::byte> fill(store.format().texelBytes());
    // Once beforehand: constant faces are spread out by the first stroke over them only.
    Stroke(surface, brush, fill, Threads{1}).add(middleOf(kCells), store);
    for (auto _ : state) {
        Stroke stroke(surface, brush, fill, Threads{threads});
        benchmark::DoNotOptimize(stroke.add(middleOf(kCells), store));
    }
}

void dabArguments(benchmark::internal::Benchmark* bench)
{
    bench->ArgNames({"threads", "level", "texels"});
    bench->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
    for (const int level : {3, 6, 9}) {
        bench->Args({1, level, 100'000});
    }
    // Few enough texels stay on one thread; these do not.
    bench->Args({1, 6, 1'000'000})->Args({2, 6, 1'000'000});
}

BENCHMARK_CAPTURE(dab, uint8, TexelType::UInt8)->Apply(dabArguments);
BENCHMARK_CAPTURE(dab, uint16, TexelType::UInt16)->Apply(dabArguments);
BENCHMARK_CAPTURE(dab, half, TexelType::Half)->Apply(dabArguments);
BENCHMARK_CAPTURE(dab, float, TexelType::Float)->Apply(dabArguments);

/// The same dab of 3,000 texels of level 4 in the middle of a mesh of 10 thousand and of a million.
void localDab(benchmark::State& state)
{
    const auto n = static_cast<std::uint32_t>(state.range(0));
    const auto surface = cells(n);
    TexelStore store = blank(*surface, TexelType::UInt8, 4);
    const Brush brush = brushOver(3000, 4);
    const std::vector<std::byte> fill(3);
    Stroke(surface, brush, fill, Threads{1}).add(middleOf(n), store);
    for (auto _ : state) {
        Stroke stroke(surface, brush, fill, Threads{1});
        benchmark::DoNotOptimize(stroke.add(middleOf(n), store));
    }
    state.counters["triangles"] = static_cast<double>(surface->mesh().faceCount());
}
BENCHMARK(localDab)->ArgName("cells")->Arg(71)->Arg(707)->Unit(benchmark::kMicrosecond);

/// A stroke of 400 samples on constant faces, as a hand draws it: time of each add().
void strokeSamples(benchmark::State& state)
{
    const auto level = static_cast<int>(state.range(0));
    const auto texels = static_cast<double>(state.range(1));
    constexpr std::uint32_t kCells = 100;
    const auto surface = cells(kCells);
    const TexelStore untouched = blank(*surface, TexelType::UInt8, level);
    const Brush brush = brushOver(texels, level);
    const std::vector<std::byte> fill(3);
    std::vector<double> times;
    for (auto _ : state) {
        TexelStore store = untouched;
        Stroke stroke(surface, brush, fill);
        for (int k = 0; k < 400; ++k) {
            // A loop over a third of the square, half a radius a sample.
            const double angle = k * 0.5 * static_cast<double>(brush.radius) / (kCells / 3.0);
            const double x = kCells / 2.0 + kCells / 3.0 * std::cos(angle);
            const double y = kCells / 2.0 + kCells / 3.0 * std::sin(angle);
            const auto column = static_cast<std::size_t>(x);
            const auto row = static_cast<std::size_t>(y);
            const auto u = static_cast<float>(x - std::floor(x));
            const auto v = static_cast<float>(y - std::floor(y));
            const std::size_t cell = 2 * (row * kCells + column);
            const StrokeSample sample = u + v <= 1 ? StrokeSample{faceId(cell), {u, v}}
                                                   : StrokeSample{faceId(cell + 1), {1 - u, 1 - v}};
            // Processor time of all threads: what other programs take does not count.
            const std::clock_t begin = std::clock();
            benchmark::DoNotOptimize(stroke.add(sample, store));
            times.push_back(1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
        }
        benchmark::DoNotOptimize(stroke.finish(store));
    }
    std::ranges::sort(times);
    const auto share = [&](double part) {
        return times[static_cast<std::size_t>(part * static_cast<double>(times.size() - 1))];
    };
    state.counters["add_p50_ms"] = share(0.5);
    state.counters["add_p99_ms"] = share(0.99);
    state.counters["add_max_ms"] = share(1.0);
}
BENCHMARK(strokeSamples)
    ->ArgNames({"level", "texels"})
    ->Args({5, 3000})
    ->Args({7, 30'000})
    ->Args({7, 100'000})
    ->Args({3, 100'000})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

/// Rays from all round towards points inside a sphere of 1.3 million triangles.
void raycast(benchmark::State& state)
{
    const TriangleMesh mesh = test::sphereMesh(8);
    const Bvh bvh(mesh);
    std::uint32_t k = 0;
    for (auto _ : state) {
        const auto angle = static_cast<float>(k++) * 0.37F;
        const glm::vec3 from(3 * std::cos(angle), 2 * std::sin(1.7F * angle), 3 * std::sin(angle));
        benchmark::DoNotOptimize(
            bvh.raycast({from, 0.7F * glm::cross(from, {0.1F, 0.2F, 0}) - from}));
    }
}
BENCHMARK(raycast)->Unit(benchmark::kMicrosecond);

/// Back onto the same sphere from a little beside it, as every dab does.
void closestPoint(benchmark::State& state)
{
    const TriangleMesh mesh = test::sphereMesh(8);
    const Bvh bvh(mesh);
    std::uint32_t k = 0;
    for (auto _ : state) {
        const auto angle = static_cast<float>(k++) * 0.37F;
        const glm::vec3 beside(0.6F * std::cos(angle), 0.8F, 0.59F * std::sin(angle));
        benchmark::DoNotOptimize(bvh.closestPoint(beside, 1.0F));
    }
}
BENCHMARK(closestPoint)->Unit(benchmark::kMicrosecond);

void buildHierarchy(benchmark::State& state)
{
    const TriangleMesh mesh = test::sphereMesh(8); // 1.3 million
    const auto threads = static_cast<unsigned>(state.range(0));
    std::size_t bytes = 0;
    for (auto _ : state) {
        bytes = Bvh(mesh, Threads{threads}).memoryBytes();
    }
    const auto faces = static_cast<double>(mesh.faceCount());
    state.counters["bytes_per_face"] = static_cast<double>(bytes) / faces;
}
BENCHMARK(buildHierarchy)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

} // namespace
