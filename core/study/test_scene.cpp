// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/test_scene.h"

#include "core/io/ptx.h"
#include "core/lattice/texel.h"
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

/// Rhombi along a side.
int rhombiAcross(const TestPatch& patch)
{
    return patch.tiles * rhombiAcross(patch.faces);
}

/// Face of a patch that repeats a face of the tile, in tile (column, row).
FaceId inPatch(FaceId face, int column, int row, const TestPatch& patch)
{
    const auto across = static_cast<std::size_t>(rhombiAcross(patch.faces));
    const std::size_t a = rhombusOf(face) % across + static_cast<std::size_t>(column) * across;
    const std::size_t b = rhombusOf(face) / across + static_cast<std::size_t>(row) * across;
    const auto size = static_cast<std::size_t>(rhombiAcross(patch));
    return faceId(2 * (a + b * size) + (isUpper(face) ? 1 : 0));
}

/// Edge of a face in edges of small faces.
double edgeOf(TestFaces faces)
{
    return static_cast<double>(kTileRhombi) / rhombiAcross(faces);
}

/// A point of a face.
struct FacePoint
{
    FaceId face{};
    glm::dvec2 uv{0};
};

/// The point of the tile that `inTile` puts there.
FacePoint pointOfTile(glm::dvec2 at, TestFaces faces)
{
    const int across = rhombiAcross(faces);
    const glm::dvec2 rhombi = at / edgeOf(faces);
    const int a = std::clamp(static_cast<int>(rhombi.x), 0, across - 1);
    const int b = std::clamp(static_cast<int>(rhombi.y), 0, across - 1);
    const glm::dvec2 uv = rhombi - glm::dvec2(a, b);
    const bool upper = uv.x + uv.y > 1;
    const auto face = static_cast<std::size_t>(2 * (a + across * b) + (upper ? 1 : 0));
    return {faceId(face), upper ? 1.0 - uv : uv};
}

/// The texels of the tile dealt out to other faces.
TexelStore rearranged(const TexelStore& tile, TestFaces faces)
{
    const auto rhombi = static_cast<std::uint32_t>(rhombiAcross(faces));
    const Level level = levelOf(faces);
    const std::size_t size = tile.format().texelBytes();
    TexelStore store(2 * rhombi * rhombi, tile.format(), level, tile.face(faceId(0)).texel(0));
    for (std::uint32_t f = 0; f < store.faceCount(); ++f) {
        const std::span<std::byte> texels = store.writable(faceId(f));
        for (std::uint32_t t = 0; t < level.texelCount(); ++t) {
            const glm::dvec2 middle = centroid(level, texelAt(level, TexelIndex{t}));
            const FacePoint from = pointOfTile(inTile(faceId(f), middle, faces), TestFaces::Small);
            const TexelIndex index = texelIndex(kTileLevel, texelAt(kTileLevel, from.uv));
            std::ranges::copy(tile.face(from.face).texel(indexOf(index)),
                              texels.begin() + static_cast<std::ptrdiff_t>(t * size));
        }
    }
    return store;
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
TexelStore repeated(const TexelStore& tile, const TestPatch& patch)
{
    const int size = rhombiAcross(patch);
    const auto rhombi = static_cast<std::uint32_t>(size * size);
    const std::array<std::byte, kChannels> black{};
    TexelStore store(2 * rhombi, tile.format(), levelOf(patch.faces), black);
    for (int row = 0; row < patch.tiles; ++row) {
        for (int column = 0; column < patch.tiles; ++column) {
            for (std::uint32_t f = 0; f < tile.faceCount(); ++f) {
                store.exchange(inPatch(faceId(f), column, row, patch), tile.face(faceId(f)));
            }
        }
    }
    return store;
}

/// A stored query on the middle tile of a patch.
void addQuery(const QueryArrays& from, std::size_t i, const TestPatch& patch, QueryArrays& out)
{
    const FacePoint at = pointOfTile(inTile(from.face[i], {from.u[i], from.v[i]}), patch.faces);
    // Vectors turn over with their faces.
    const bool same = isUpper(from.face[i]) == isUpper(at.face);
    const double scale = (same ? 1 : -1) / edgeOf(patch.faces);
    const auto moved = [&](float u, float v) { return scale * glm::dvec2(u, v); };
    out.add(inPatch(at.face, patch.tiles / 2, patch.tiles / 2, patch),
            at.uv,
            moved(from.uw1[i], from.vw1[i]),
            moved(from.uw2[i], from.vw2[i]));
}

/// The stored queries that stay inside, moved to the middle tile, with their exact values.
void selectQueries(const TestData& data,
                   TestContent content,
                   const TestPatch& patch,
                   TestScene& out)
{
    const QueryArrays& all = data.queries;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (staysInside(all, i, patch.tiles)) {
            out.stored.push_back(i);
            addQuery(all, i, patch, out.queries);
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

std::string_view nameOf(TestFaces faces)
{
    return faces == TestFaces::Small ? "small" : "large";
}

int rhombiAcross(TestFaces faces)
{
    return faces == TestFaces::Small ? kTileRhombi : 1;
}

Level levelOf(TestFaces faces)
{
    return faces == TestFaces::Small ? kTileLevel : Level(9);
}

glm::dvec2 inTile(FaceId face, glm::dvec2 uv, TestFaces faces)
{
    const auto across = static_cast<std::size_t>(rhombiAcross(faces));
    const glm::dvec2 corner(static_cast<double>(rhombusOf(face) % across),
                            static_cast<double>(rhombusOf(face) / across));
    return edgeOf(faces) * (isUpper(face) ? corner + 1.0 - uv : corner + uv);
}

FaceId tileFace(FaceId patchFace, const TestPatch& patch)
{
    const auto size = static_cast<std::size_t>(rhombiAcross(patch));
    const auto across = static_cast<std::size_t>(rhombiAcross(patch.faces));
    const std::size_t a = rhombusOf(patchFace) % size % across;
    const std::size_t b = rhombusOf(patchFace) / size % across;
    return faceId(2 * (a + b * across) + (isUpper(patchFace) ? 1 : 0));
}

Adjacency tileAdjacency(TestFaces faces)
{
    return rhombicAdjacency(rhombiAcross(faces), around);
}

TexelStore tileOf(const TestData& data, TestContent content, TestFaces faces)
{
    const TexelStore& stored = data.tiles[static_cast<std::size_t>(content)];
    return faces == TestFaces::Small ? stored : rearranged(stored, faces);
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

Result<TestScene> buildTestScene(const TestData& data,
                                 TestContent content,
                                 const TestPatch& patch,
                                 Threads threads,
                                 Progress& progress)
{
    check(patch.tiles >= 1 && patch.tiles <= kAllQueriesTiles && patch.tiles % 2 == 1,
          "an odd number of tiles");
    TestScene made;
    selectQueries(data, content, patch, made);
    const TexelStore store = repeated(tileOf(data, content, patch.faces), patch);
    auto surface = std::make_shared<const FilterSurface>(
        FilterSurface::equilateral(rhombicAdjacency(rhombiAcross(patch), nothingBeyond)));
    auto scene = FilterScene::build(std::move(surface), store, threads, progress);
    if (!scene) {
        return tl::unexpected(scene.error());
    }
    made.scene = std::move(*scene);
    return made;
}

} // namespace trixel
