// SPDX-License-Identifier: GPL-3.0-or-later
//
// How fast images come onto faces and off them again, in texels and pixels a second: each way of
// looking up beside the nearest pixel, and the way back beside its own filter alone.
#include "core/filter/filter_method.h"
#include "core/mapping/bake.h"
#include "core/mapping/uv_mapping.h"
#include "core/resample/uv_image.h"
#include "tests/core/test_meshes.h"

#include <benchmark/benchmark.h>

#include <cmath>

namespace trixel {
namespace {

constexpr int kImage = 1024;

TriangleMesh uvGrid(std::uint32_t n)
{
    TriangleMesh mesh = test::gridMesh(n);
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) {
            mesh.cornerUvs.emplace_back(mesh.positions[vertex]);
        }
    }
    return mesh;
}

Image picture()
{
    Image image(kImage,
                kImage,
                {TexelType::UInt8, 3, std::nullopt},
                std::vector<ColorSpace>(3, ColorSpace::SRgb));
    std::uint32_t state = 1;
    for (std::byte& byte : image.writable()) {
        state = state * 1664525U + 1013904223U;
        byte = static_cast<std::byte>(state >> 24U);
    }
    return image;
}

std::vector<FaceId> facesOf(const TriangleMesh& mesh)
{
    std::vector<FaceId> faces;
    for (std::uint32_t k = 0; k < mesh.faceCount(); ++k) {
        faces.push_back(faceId(k));
    }
    return faces;
}

TexelStore emptyStore(const TriangleMesh& mesh, Level level)
{
    const std::vector<std::byte> texel(3);
    return {static_cast<std::uint32_t>(mesh.faceCount()),
            {TexelType::UInt8, 3, std::nullopt},
            level,
            texel};
}

/// \param lookup, level of faces: 8² cells whose faces have 4^level texels
void lookUp(benchmark::State& state)
{
    const TriangleMesh mesh = uvGrid(8);
    const UvMapping mapping(mesh);
    SamplerOptions options;
    options.lookup = static_cast<ImageLookup>(state.range(0));
    const auto tiles = ImageTiles::make({{UdimTile{}, picture(), ""}}, options, Threads{1}).value();
    const Level level(static_cast<int>(state.range(1)));
    const auto faces = facesOf(mesh);
    BakeOptions bakeOptions;
    bakeOptions.threads = Threads{static_cast<unsigned>(state.range(2))};
    for (auto _ : state) {
        TexelStore store = emptyStore(mesh, level);
        NoProgress progress;
        benchmark::DoNotOptimize(bake(store, faces, mapping, tiles, bakeOptions, progress));
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * mesh.faceCount()) *
                            level.texelCount());
}

BENCHMARK(lookUp)
    ->ArgNames({"lookup", "level", "threads"})
    ->ArgsProduct({{0, 1, 2, 3}, {4, 6}, {1}})
    ->Args({1, 6, 2})
    ->Args({3, 6, 2})
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

struct Painted
{
    TriangleMesh mesh = uvGrid(8);
    TexelStore store = emptyStore(mesh, Level(6));
    FilterScene scene;

    Painted()
    {
        NoProgress progress;
        const auto tiles = ImageTiles::make({{UdimTile{}, picture(), ""}}, {}, Threads{1}).value();
        benchmark::DoNotOptimize(bake(store, facesOf(mesh), UvMapping(mesh), tiles, {}, progress));
        const auto surface = std::make_shared<const FilterSurface>(
            FilterSurface::fromMesh(mesh, buildAdjacency(mesh.triangles)));
        scene = FilterScene::build(surface, store, Threads{1}, progress).value();
    }
};

/// \param size of the image: 724 has as many pixels as there are texels
void comeBack(benchmark::State& state)
{
    const Painted painted;
    UvImageOptions options;
    options.width = options.height = static_cast<int>(state.range(0));
    options.colors.assign(3, ColorSpace::SRgb);
    options.threads = Threads{1};
    for (auto _ : state) {
        NoProgress progress;
        benchmark::DoNotOptimize(
            makeUvImage(painted.scene, painted.mesh, painted.store.format(), options, progress));
    }
    state.SetItemsProcessed(state.iterations() * state.range(0) * state.range(0));
}

BENCHMARK(comeBack)->ArgName("size")->Arg(724)->Arg(181)->MeasureProcessCPUTime()->Unit(
    benchmark::kMillisecond);

/// The filter of `comeBack` alone, on as many places.
void filterAlone(benchmark::State& state)
{
    const Painted painted;
    const auto method = makeMethod({"lattice-linear", std::nullopt});
    QueryArrays queries;
    for (int k = 0; k < 724 * 724; ++k) {
        const double at = 0.618033988749895 * k;
        const auto u = static_cast<float>(0.5 * (at - std::floor(at)));
        queries.add(faceId(static_cast<std::size_t>(k) * 128 / (724 * 724)),
                    {u, 0.3F},
                    glm::vec2(0),
                    glm::vec2(0));
    }
    std::vector<float> values(3 * queries.size());
    for (auto _ : state) {
        method->filter(painted.scene, queries.queries(), {values, queries.size(), {}, {}});
        benchmark::DoNotOptimize(values.data());
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * queries.size()));
}

BENCHMARK(filterAlone)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

} // namespace
} // namespace trixel
