// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the footprint panel does on a mesh of a million faces: the net of a footprint, which
// hovering waits for, and the weights of its texels, which come from the background.
#include "core/filter/contributions.h"
#include "core/filter/footprint_clamps.h"
#include "core/filter/footprint_net.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace trixel {
namespace {

constexpr std::uint32_t kCells = 708; // twice its square: 1,002,528 faces

/// A million faces of level 2, on a wave.
struct Million
{
    TriangleMesh mesh;
    Adjacency adjacency;
    TexelStore texels;
    std::shared_ptr<const FilterScene> scene;

    Million()
    {
        const auto at = [](std::uint32_t x, std::uint32_t y) { return x + y * (kCells + 1); };
        for (std::uint32_t y = 0; y <= kCells; ++y) {
            for (std::uint32_t x = 0; x <= kCells; ++x) {
                const auto u = static_cast<float>(x) / kCells;
                const auto v = static_cast<float>(y) / kCells;
                mesh.positions.emplace_back(u, v, 0.1F * std::sin(40 * u) * std::cos(30 * v));
            }
        }
        for (std::uint32_t y = 0; y < kCells; ++y) {
            for (std::uint32_t x = 0; x < kCells; ++x) {
                mesh.triangles.push_back({at(x, y), at(x + 1, y), at(x, y + 1)});
                mesh.triangles.push_back({at(x + 1, y + 1), at(x, y + 1), at(x + 1, y)});
            }
        }
        adjacency = buildAdjacency(mesh.triangles);
        const std::array<std::byte, 3> fill{};
        texels = TexelStore(TexelFormat{}, FaceMap<Level>(mesh.faceCount(), Level(2)), fill);
        NoProgress progress;
        auto surface =
            std::make_shared<const FilterSurface>(FilterSurface::fromMesh(mesh, adjacency));
        scene = std::make_shared<const FilterScene>(
            *FilterScene::build(surface, texels, Threads::all(), progress));
    }
};

const Million& million()
{
    static const Million made;
    return made;
}

/// Somewhere else each time. \param width  of W1, in edges; W2 is a third of it
PlacedFootprint footprint(std::size_t k, double width)
{
    const FaceId face = faceId((k * 7919 + 501'000) % million().mesh.faceCount());
    return {face, {0.3, 0.3}, {{width, 0.2 * width}, {-0.1 * width, 0.3 * width}}};
}

void net(benchmark::State& state)
{
    const Million& made = million();
    std::size_t k = 0;
    std::size_t faces = 0;
    for (auto _ : state) {
        const PlacedFootprint asked = footprint(++k, static_cast<double>(state.range(0)) / 10);
        const FootprintNet laid = footprintNet(made.mesh, made.adjacency, made.texels, asked);
        benchmark::DoNotOptimize(clampsOf(asked, laid, true));
        faces = std::max(faces, laid.faces.size());
    }
    state.counters["faces"] = static_cast<double>(faces);
}
BENCHMARK(net)->Arg(1)->Arg(10)->Arg(40)->Arg(400)->Unit(benchmark::kMillisecond);

void weights(benchmark::State& state, const char* name)
{
    NoProgress progress;
    static auto meter = ContributionMeter::build(million().scene, Threads{1}, progress);
    const auto method = makeMethod(*parseMethod(name));
    std::size_t k = 0;
    std::size_t texels = 0;
    for (auto _ : state) {
        const PlacedFootprint asked = footprint(++k, static_cast<double>(state.range(0)) / 10);
        QueryArrays query;
        query.add(asked.face,
                  glm::vec2(asked.uv),
                  glm::vec2(asked.footprint.w1),
                  glm::vec2(asked.footprint.w2));
        const auto found = meter->measure(*method, query.queries(), {}, progress);
        texels = std::max(texels, found ? found->texels.size() : 0);
    }
    state.counters["texels"] = static_cast<double>(texels);
}
BENCHMARK_CAPTURE(weights, probes, "probes-2")->Arg(10)->Arg(40)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(weights, exact, "exact")->Arg(10)->Arg(40)->Unit(benchmark::kMillisecond);

void meter(benchmark::State& state)
{
    NoProgress progress;
    for (auto _ : state) {
        benchmark::DoNotOptimize(ContributionMeter::build(million().scene, Threads{1}, progress));
    }
}
BENCHMARK(meter)->Unit(benchmark::kMillisecond)->Iterations(2);

} // namespace
} // namespace trixel
