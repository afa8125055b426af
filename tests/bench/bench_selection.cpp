// SPDX-License-Identifier: GPL-3.0-or-later
//
// Choosing faces of a large mesh: what the window's thread does until the selection is told of.
#include <QCoreApplication>

#include "tests/ui/fixtures.h"
#include "ui/document/document.h"
#include "ui/document/face_selection.h"

#include <benchmark/benchmark.h>

#include <array>

using namespace trixel;
using namespace trixel::ui;

namespace {

constexpr int kSide = 707; // a million faces

Document& document()
{
    static Document made;
    if (!made.isOpen()) {
        made.open(gridProject(kSide, 0), {}, "sheet");
    }
    return made;
}

void selectAll(benchmark::State& state)
{
    FaceSelection selection(document());
    for (auto _ : state) {
        selection.selectAll();
        state.PauseTiming();
        selection.clear();
        state.ResumeTiming();
    }
}

void invertOne(benchmark::State& state)
{
    FaceSelection selection(document());
    for (auto _ : state) {
        state.PauseTiming();
        selection.set({FaceId{5}});
        state.ResumeTiming();
        selection.invert();
    }
}

/// All but a hole in the middle; growing closes it by a ring.
void growAlmostAll(benchmark::State& state)
{
    FaceSelection selection(document());
    for (auto _ : state) {
        state.PauseTiming();
        selection.set({FaceId{500'000}});
        selection.grow();
        selection.grow();
        selection.invert();
        state.ResumeTiming();
        selection.grow();
    }
}

void growAFew(benchmark::State& state)
{
    FaceSelection selection(document());
    for (auto _ : state) {
        state.PauseTiming();
        selection.set({FaceId{500'000}});
        state.ResumeTiming();
        selection.grow();
    }
}

/// Every second face: as scattered as it gets.
void growHalf(benchmark::State& state)
{
    FaceSelection selection(document());
    std::vector<FaceId> even;
    for (std::size_t k = 0; k < document().texels().faceCount(); k += 2) {
        even.push_back(faceId(k));
    }
    for (auto _ : state) {
        state.PauseTiming();
        selection.set(even);
        state.ResumeTiming();
        selection.grow();
    }
}

void setUp(benchmark::internal::Benchmark* bench)
{
    bench->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
}

BENCHMARK(selectAll)->Apply(setUp);
BENCHMARK(invertOne)->Apply(setUp);
BENCHMARK(growAlmostAll)->Apply(setUp);
BENCHMARK(growHalf)->Apply(setUp);
BENCHMARK(growAFew)->Apply(setUp);

} // namespace

BENCHMARK_MAIN();
