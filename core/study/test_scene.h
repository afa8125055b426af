// SPDX-License-Identifier: GPL-3.0-or-later
//
// What methods are compared on where the user has nothing of his own: two stored textures and
// 3,000 stored footprints. Texels and queries are data, because what computes them differs between
// builds.
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/filter/filter_queries.h"
#include "core/filter/filter_scene.h"
#include "core/texture/texel_store.h"

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace trixel {

/// The tile as stored: kTileRhombi² rhombi of two equilateral faces of edge 1, periodic. Rhombus
/// (a, b) is the faces 2 (a + kTileRhombi b), its lower half, and the one after, its upper half.
inline constexpr int kTileRhombi = 8;
inline constexpr std::uint32_t kTileFaces = 2 * kTileRhombi * kTileRhombi;
inline constexpr Level kTileLevel{6};

enum class TestContent {
    Natural,  ///< soft edges, structure of all sizes, power that falls with frequency
    HardEdged ///< checks, stripes, rings, letter-like signs
};
inline constexpr std::array<TestContent, 2> kTestContents = {TestContent::Natural,
                                                             TestContent::HardEdged};
std::string_view nameOf(TestContent content);

/// How the tile's texels are dealt out to faces. Texels, footprints and what is exact are the same
/// either way; what differs is how many faces a footprint lies on.
enum class TestFaces {
    Small, ///< as stored: kTileRhombi² rhombi of level kTileLevel, 18 faces a footprint
    Large  ///< one rhombus of two faces of level 9, which few footprints leave
};
inline constexpr std::array<TestFaces, 2> kTestFaces = {TestFaces::Small, TestFaces::Large};
std::string_view nameOf(TestFaces faces);
/// Rhombi along a side of the tile; rhombus (a, b) is the faces 2 (a + b times this) and after.
int rhombiAcross(TestFaces faces);
Level levelOf(TestFaces faces);

/// A square of equal tiles.
struct TestPatch
{
    TestPatch(int tilesAcross, TestFaces cutInto = TestFaces::Small)
        : tiles(tilesAcross)
        , faces(cutInto)
    {
    }

    int tiles; ///< along each side
    TestFaces faces;
};

/// Oblique coordinates of a point of a face of the tile, in edges of its small faces: (1,0) and
/// (0,1) are its axes.
glm::dvec2 inTile(FaceId face, glm::dvec2 uv, TestFaces faces = TestFaces::Small);

/// The face of the tile that a face of a patch repeats.
FaceId tileFace(FaceId patchFace, const TestPatch& patch);

/// Neighbours on the tile, which closes upon itself.
Adjacency tileAdjacency(TestFaces faces = TestFaces::Small);

/// The files of tests/data/study.
struct TestDataFiles
{
    std::string_view natural;   ///< natural.ptx
    std::string_view hardEdged; ///< hard-edged.ptx
    std::string_view queries;   ///< queries.csv
};

/// The same, as the program carries them with it.
TestDataFiles storedTestFiles();

struct TestData
{
    std::array<TexelStore, 2> tiles; ///< by TestContent: kTileFaces faces of level kTileLevel, RGB
    /// Width ¼ to 64 texels and anisotropy 1 to 64, both log-uniform, at random places of the tile
    /// and in random directions; W1 and W2 any conjugate radii of the ellipse.
    QueryArrays queries;
    /// By TestContent: what `exact` answers on an endless plane of tiles; channel c of query i at
    /// c * queries.size() + i.
    std::array<std::vector<float>, 2> exact;
};

/// Errors name the file and the place in it.
Result<TestData> parseTestData(const TestDataFiles& files);

/// The tile of a content, texel for texel, in faces of either size.
TexelStore tileOf(const TestData& data, TestContent content, TestFaces faces);

/// A flat patch of equal tiles whose faces share their texels, and the queries on its middle one.
struct TestScene
{
    FilterScene scene;
    QueryArrays queries;
    std::vector<float> exact; ///< channel c of query i at c * queries.size() + i
    /// Number of each query among those stored.
    std::vector<std::size_t> stored;
};

/// Tiles along each side of a patch so large that no query reaches its border.
inline constexpr int kAllQueriesTiles = 57;

/// \param patch  of an odd number of tiles a side in [1, kAllQueriesTiles] (checked). Queries whose
///               ellipse at six standard deviations reaches beyond it are left out, the same ones
///               whatever the faces.
/// Fails only when cancelled.
Result<TestScene> buildTestScene(const TestData& data,
                                 TestContent content,
                                 const TestPatch& patch,
                                 Threads threads,
                                 Progress& progress);

} // namespace trixel
