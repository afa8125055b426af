// SPDX-License-Identifier: GPL-3.0-or-later
//
// The limit surface: evaluating it, tessellating it for a camera, painting on it.
#include "core/mesh/limit_mesh.h"
#include "core/mesh/loop_refinement.h"
#include "core/paint/paint_surface.h"
#include "core/paint/stroke.h"
#include "tests/core/mesh/cages.h"

#include <benchmark/benchmark.h>

#include <glm/gtc/matrix_transform.hpp>

namespace trixel {
namespace {

/// 81,920 faces: an icosahedron refined six times; all but 60 are regular.
TriangleMesh smoothCage()
{
    TriangleMesh mesh = loopRefined(test::icosahedron(), 6).value();
    mesh.sourceFaces.clear();
    return mesh;
}

/// 98,000 faces, none of them regular: 7,000 solids with two vertices of seven faces.
TriangleMesh roughCage()
{
    const TriangleMesh one = test::bipyramid(7);
    TriangleMesh all;
    for (std::uint32_t k = 0; k < 7000; ++k) {
        const glm::vec3 place(
            2.2F * static_cast<float>(k % 84), 2.2F * static_cast<float>(k / 84), 0);
        const auto first = static_cast<std::uint32_t>(all.positions.size());
        for (const glm::vec3& p : one.positions) {
            all.positions.push_back((p + place) / 92.0F - glm::vec3(1, 1, 0));
        }
        for (const Triangle& t : one.triangles) {
            all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
        }
    }
    return all;
}

TriangleMesh cageOf(benchmark::State& state)
{
    return state.range(0) == 0 ? smoothCage() : roughCage();
}

std::shared_ptr<const LimitBends> bendsOf(const TriangleMesh& cage)
{
    NoProgress progress;
    return LimitBends::measure(LimitSurface::build(cage).value(), Threads::all(), progress).value();
}

/// A picture of 1600 × 1000 pixels.
ErrorScale pictureFrom(double x, double distance)
{
    const glm::dmat4 camera =
        glm::lookAt(glm::dvec3(x, 0, distance), glm::dvec3(0), glm::dvec3(0, 1, 0));
    return ErrorScale::ofPicture({camera, 1587, {800, 500}, 0.01});
}

void build(benchmark::State& state)
{
    const TriangleMesh cage = cageOf(state);
    for (auto _ : state) {
        benchmark::DoNotOptimize(LimitSurface::build(cage));
    }
}

void measureBends(benchmark::State& state)
{
    const auto surface = LimitSurface::build(cageOf(state)).value();
    NoProgress progress;
    for (auto _ : state) {
        benchmark::DoNotOptimize(LimitBends::measure(surface, Threads{1}, progress));
    }
}

/// Fifty points a face.
template <bool WithDerivatives>
void evaluate(benchmark::State& state)
{
    const auto surface = LimitSurface::build(cageOf(state)).value();
    LimitSurface::Evaluator evaluator(*surface);
    std::size_t face = 0;
    for (auto _ : state) {
        evaluator.moveTo(faceId(face++ % surface->faceCount()));
        for (int k = 0; k < 50; ++k) {
            const glm::dvec2 uv(0.013 * k, 0.3);
            if constexpr (WithDerivatives) {
                benchmark::DoNotOptimize(evaluator.at(uv));
            } else {
                benchmark::DoNotOptimize(evaluator.position(uv));
            }
        }
    }
    state.SetItemsProcessed(50 * state.iterations());
}

void tessellate(benchmark::State& state)
{
    const auto bends = bendsOf(cageOf(state));
    NoProgress progress;
    std::size_t triangles = 0;
    for (auto _ : state) {
        const auto cut =
            LimitTessellation::make(bends, {pictureFrom(0, 4), 0.5}, nullptr, Threads{1}, progress);
        triangles = (*cut)->triangles().size();
    }
    state.counters["triangles"] = static_cast<double>(triangles);
}

/// After the camera moved a little.
void tessellateAgain(benchmark::State& state)
{
    const auto bends = bendsOf(cageOf(state));
    NoProgress progress;
    const auto before =
        LimitTessellation::make(bends, {pictureFrom(0, 4), 0.5}, nullptr, Threads{1}, progress);
    for (auto _ : state) {
        benchmark::DoNotOptimize(LimitTessellation::make(
            bends, {pictureFrom(0.1, 4), 0.5}, *before, Threads{1}, progress));
    }
}

void planAgain(benchmark::State& state)
{
    const auto bends = bendsOf(cageOf(state));
    NoProgress progress;
    const LimitDemand demand{pictureFrom(0, 4), 0.5};
    const auto cut = LimitTessellation::make(bends, demand, nullptr, Threads{1}, progress);
    for (auto _ : state) {
        benchmark::DoNotOptimize((*cut)->isAsDemanded(demand));
    }
}

/// One dab on an icosahedron with faces of level 8; 0 on the cage, 1 on its limit surface when the
/// texels are first reached, 2 when they were before.
void dab(benchmark::State& state)
{
    NoProgress progress;
    const auto surface = Surface::build(test::icosahedron(), progress).value();
    const auto limit =
        state.range(0) > 0 ? limitToPaintOn(*surface, {}, Threads::all(), progress).value() : nullptr;
    TexelStore store(20, TexelFormat{}, Level(8), std::array<std::byte, 3>{});
    Brush brush;
    brush.radius = 0.4F;
    brush.color = {1, 0, 0, 1};
    brush.flow = 0.01F;
    const std::vector<std::byte> fill(3);
    std::optional<Stroke> stroke;
    for (auto _ : state) {
        if (!stroke || state.range(0) < 2) {
            stroke.emplace(surface, brush, fill, Threads{1}, limit);
        } else {
            stroke->lift();
        }
        benchmark::DoNotOptimize(stroke->add({faceId(3), {0.3F, 0.3F}}, store));
    }
}

BENCHMARK(build)->DenseRange(0, 1)->Unit(benchmark::kMillisecond);
BENCHMARK(measureBends)->DenseRange(0, 1)->Unit(benchmark::kMillisecond);
BENCHMARK(evaluate<false>)->DenseRange(0, 1);
BENCHMARK(evaluate<true>)->DenseRange(0, 1);
BENCHMARK(tessellate)->DenseRange(0, 1)->Unit(benchmark::kMillisecond);
BENCHMARK(tessellateAgain)->DenseRange(0, 1)->Unit(benchmark::kMillisecond);
BENCHMARK(planAgain)->DenseRange(0, 1)->Unit(benchmark::kMillisecond);
BENCHMARK(dab)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace trixel
