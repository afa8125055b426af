// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/test_scene.h"

#include "core/io/ptx.h"
#include "core/study/query_table.h"

#include <algorithm>
#include <cmath>

namespace trixel {
namespace {

constexpr int kChannels = 3;

std::size_t rhombusOf(FaceId face)
{
    return indexOf(face) / 2;
}

bool isUpper(FaceId face)
{
    return indexOf(face) % 2 != 0;
}

/// Where a lattice of rhombi finds the one across its border; nothing: there is none.
using Wrap = std::optional<std::uint32_t> (*)(int position, int size);

std::optional<std::uint32_t> around(int position, int size)
{
    return static_cast<std::uint32_t>((position + size) % size);
}

std::optional<std::uint32_t> nothingBeyond(int position, int size)
{
    return position >= 0 && position < size ? std::optional(static_cast<std::uint32_t>(position))
                                            : std::nullopt;
}

/// Both halves meet along edge 1; edges 0 and 2 meet those of the rhombi below and to the left.
Adjacency rhombicAdjacency(int size, Wrap wrap)
{
    Adjacency adjacency(2 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    const auto half = [&](std::uint32_t a, std::uint32_t b, std::uint32_t upper) {
        return faceId(2 * (a + std::size_t{b} * static_cast<std::size_t>(size)) + upper);
    };
    for (int b = 0; b < size; ++b) {
        for (int a = 0; a < size; ++a) {
            const auto x = static_cast<std::uint32_t>(a);
            const auto y = static_cast<std::uint32_t>(b);
            const FaceId lower = half(x, y, 0);
            adjacency.connect(lower, LocalEdge::E1, half(x, y, 1), LocalEdge::E1);
            if (const auto below = wrap(b - 1, size)) {
                adjacency.connect(lower, LocalEdge::E0, half(x, *below, 1), LocalEdge::E0);
            }
            if (const auto left = wrap(a - 1, size)) {
                adjacency.connect(lower, LocalEdge::E2, half(*left, y, 1), LocalEdge::E2);
            }
        }
    }
    return adjacency;
}

/// Face of a patch of size² rhombi that repeats a face of the tile, in tile (column, row).
FaceId inPatch(FaceId face, int column, int row, int size)
{
    const std::size_t a =
        rhombusOf(face) % kTileRhombi + static_cast<std::size_t>(column * kTileRhombi);
    const std::size_t b =
        rhombusOf(face) / kTileRhombi + static_cast<std::size_t>(row * kTileRhombi);
    return faceId(2 * (a + b * static_cast<std::size_t>(size)) + (isUpper(face) ? 1 : 0));
}

Status expectTile(const TexelStore& tile)
{
    const TexelFormat rgb{TexelType::UInt8, kChannels, std::nullopt};
    bool same = tile.faceCount() == kTileFaces && tile.format() == rgb;
    for (std::uint32_t f = 0; same && f < kTileFaces; ++f) {
        same = tile.face(faceId(f)).level() == kTileLevel;
    }
    return same ? Status() : contentsError("expected 128 faces of level 6, uint8 RGB.");
}

Result<TexelStore> parseTile(std::string_view name, std::string_view bytes)
{
    NoProgress progress;
    auto contents = parsePtx(bytes, progress);
    if (!contents) {
        return prefixed(std::string(name), contents.error());
    }
    if (const Status tile = expectTile(contents->texels); !tile) {
        return prefixed(std::string(name), tile.error());
    }
    return std::move(contents->texels);
}

/// How far the ellipse at six standard deviations reaches, in edges.
double reachOf(const QueryArrays& queries, std::size_t i)
{
    const auto squaredLength = [](double u, double v) { return u * u + u * v + v * v; };
    const double trace = squaredLength(queries.uw1[i], queries.vw1[i]) +
                         squaredLength(queries.uw2[i], queries.vw2[i]);
    const double texel = 1.0 / kTileLevel.resolution();
    // The trace of the covariance bounds its larger eigenvalue.
    return 6 * std::sqrt(trace / 4 + texel * texel / 4);
}

/// Whether a query on the middle tile stays inside a patch of so many.
bool staysInside(const QueryArrays& queries, std::size_t i, int tiles)
{
    const glm::dvec2 at = inTile(queries.face[i], {queries.u[i], queries.v[i]}) +
                          static_cast<double>(tiles / 2 * kTileRhombi);
    // A circle of radius r spans 2r / sin 60° along an oblique axis.
    const double reach = reachOf(queries, i) / 0.86602540378443865;
    const double end = tiles * kTileRhombi;
    return std::min(at.x, at.y) >= reach && std::max(at.x, at.y) + reach <= end;
}

/// Every face of the patch shares the bytes of its face of the tile.
TexelStore repeated(const TexelStore& tile, int tiles)
{
    const int size = tiles * kTileRhombi;
    const auto rhombi = static_cast<std::uint32_t>(size * size);
    const std::array<std::byte, kChannels> black{};
    TexelStore store(2 * rhombi, tile.format(), kTileLevel, black);
    for (int row = 0; row < tiles; ++row) {
        for (int column = 0; column < tiles; ++column) {
            for (std::uint32_t f = 0; f < kTileFaces; ++f) {
                store.exchange(inPatch(faceId(f), column, row, size), tile.face(faceId(f)));
            }
        }
    }
    return store;
}

/// The stored queries that stay inside, moved to the middle tile, with their exact values.
void selectQueries(const TestData& data, TestContent content, int tiles, TestScene& out)
{
    const QueryArrays& all = data.queries;
    const int size = tiles * kTileRhombi;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (staysInside(all, i, tiles)) {
            out.stored.push_back(i);
            out.queries.add(inPatch(all.face[i], tiles / 2, tiles / 2, size),
                            {all.u[i], all.v[i]},
                            {all.uw1[i], all.vw1[i]},
                            {all.uw2[i], all.vw2[i]});
        }
    }
    const std::vector<float>& exact = data.exact[static_cast<std::size_t>(content)];
    for (std::size_t c = 0; c < kChannels; ++c) {
        for (const std::size_t i : out.stored) {
            out.exact.push_back(exact[c * all.size() + i]);
        }
    }
}

} // namespace

std::string_view nameOf(TestContent content)
{
    return content == TestContent::Natural ? "natural" : "hard-edged";
}

glm::dvec2 inTile(FaceId face, glm::dvec2 uv)
{
    const glm::dvec2 corner(static_cast<double>(rhombusOf(face) % kTileRhombi),
                            static_cast<double>(rhombusOf(face) / kTileRhombi));
    return isUpper(face) ? corner + 1.0 - uv : corner + uv;
}

FaceId tileFace(FaceId patchFace, int tiles)
{
    const auto size = static_cast<std::size_t>(tiles * kTileRhombi);
    const std::size_t a = rhombusOf(patchFace) % size % kTileRhombi;
    const std::size_t b = rhombusOf(patchFace) / size % kTileRhombi;
    return faceId(2 * (a + b * kTileRhombi) + (isUpper(patchFace) ? 1 : 0));
}

Adjacency tileAdjacency()
{
    return rhombicAdjacency(kTileRhombi, around);
}

Result<TestData> parseTestData(const TestDataFiles& files)
{
    TestData data;
    auto natural = parseTile("natural.ptx", files.natural);
    if (!natural) {
        return tl::unexpected(natural.error());
    }
    auto hardEdged = parseTile("hard-edged.ptx", files.hardEdged);
    if (!hardEdged) {
        return tl::unexpected(hardEdged.error());
    }
    auto table = parseQueryTable(files.queries, kTileFaces, 2 * kChannels);
    if (!table) {
        return prefixed("queries.csv", table.error());
    }
    data.tiles = {std::move(*natural), std::move(*hardEdged)};
    data.queries = std::move(table->queries);
    const std::size_t half = kChannels * data.queries.size();
    const auto middle = table->values.begin() + static_cast<std::ptrdiff_t>(half);
    data.exact[0].assign(table->values.begin(), middle);
    data.exact[1].assign(middle, table->values.end());
    return data;
}

Result<TestScene> buildTestScene(
    const TestData& data, TestContent content, int tiles, Threads threads, Progress& progress)
{
    check(tiles >= 1 && tiles <= kAllQueriesTiles && tiles % 2 == 1, "an odd number of tiles");
    TestScene made;
    selectQueries(data, content, tiles, made);
    const TexelStore store = repeated(data.tiles[static_cast<std::size_t>(content)], tiles);
    auto surface = std::make_shared<const FilterSurface>(
        FilterSurface::equilateral(rhombicAdjacency(tiles * kTileRhombi, nothingBeyond)));
    auto scene = FilterScene::build(std::move(surface), store, threads, progress);
    if (!scene) {
        return tl::unexpected(scene.error());
    }
    made.scene = std::move(*scene);
    return made;
}

} // namespace trixel
