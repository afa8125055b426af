// SPDX-License-Identifier: GPL-3.0-or-later
//
// What counting the values of a texture costs, by texel type and threads.
#include "core/texture/value_histogram.h"

#include <benchmark/benchmark.h>

#include <cstring>
#include <random>
#include <vector>

using namespace trixel;

namespace {

constexpr int kLevel = 10; // 1,048,576 texels a face

/// Faces of noise in [0, 1], three channels; every face holds the same texels.
TexelStore noise(TexelType type, std::uint32_t faces)
{
    const TexelFormat format{type, 3, std::nullopt};
    std::mt19937 random(1);
    std::uniform_real_distribution<float> in(0, 1);
    std::vector<float> values(Level(kLevel).texelCount() * 3);
    for (float& value : values) {
        value = in(random);
    }
    std::vector<std::byte> texels(values.size() * byteSize(type));
    encode(type, values, texels);
    const FaceTexels face = FaceTexels::full(Level(kLevel), format.texelBytes(), texels);
    TexelStore store(faces, format, Level(0), std::vector<std::byte>(format.texelBytes()));
    for (std::uint32_t f = 0; f < faces; ++f) {
        store.exchange(FaceId{f}, face);
        (void)store.writable(FaceId{f}); // memory of its own
    }
    return store;
}

void countRgb(benchmark::State& state)
{
    const auto type = static_cast<TexelType>(state.range(0));
    const TexelStore store = noise(type, static_cast<std::uint32_t>(state.range(1)));
    const Threads threads{static_cast<unsigned>(state.range(2))};
    const std::vector<TexelNumber> numbers{{0, {}}, {1, {}}, {2, {}}};
    for (auto _ : state) {
        NoProgress progress;
        auto counted = countValues(store, numbers, threads, progress);
        benchmark::DoNotOptimize(counted);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(store.texelCount()));
}

void countConstantFaces(benchmark::State& state)
{
    const TexelStore store(static_cast<std::uint32_t>(state.range(0)),
                           TexelFormat{},
                           Level(3),
                           std::vector<std::byte>(3));
    const std::vector<TexelNumber> numbers{{0, {}}, {1, {}}, {2, {}}};
    for (auto _ : state) {
        NoProgress progress;
        auto counted = countValues(store, numbers, Threads::all(), progress);
        benchmark::DoNotOptimize(counted);
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

} // namespace

// 100 million texels of bytes; a sixteenth of that of the larger types, per texel the same.
BENCHMARK(countRgb)
    ->Args({0, 100, 1})
    ->Args({0, 100, 2})
    ->ArgsProduct({{1, 2, 3}, {16}, {1, 2}})
    ->ArgNames({"type", "faces", "threads"})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK(countConstantFaces)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
