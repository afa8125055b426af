// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/stored_faces.h"
#include "tests/core/filter/filter_scenes.h"
#include "tests/core/filter/test_scenes.h"

#include <gtest/gtest.h>

namespace trixel::test {
namespace {

/// The whole of a face is new.
TouchedRect all(FaceId face)
{
    TouchedRect rect{face};
    rect.wholeFace = true;
    return rect;
}

/// Texels are measured about every vertex of a face whose level changed, in its neighbours too.
TEST(FilterScene, updatedItIsTheSceneBuiltAnewAlsoWhereALevelChanged)
{
    const TriangleMesh mesh = sphereMesh(1);
    FaceMap<Level> levels(mesh.faceCount(), Level(2));
    TexelStore store = storeOf(levels, noise(1));
    FilterScene scene = sceneOf(surfaceOf(mesh), store);
    const FilterScene before = scene;

    const FaceId changed = faceId(17);
    levels[changed] = Level(5);
    const TexelStore other = storeOf(levels, noise(2));
    store.exchange(changed, other.face(changed));
    const TouchedRect rect = all(changed);
    scene.update(store, std::span(&rect, 1));

    const FilterScene anew = sceneOf(surfaceOf(mesh), store);
    int moved = 0;
    for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) {
        for (std::uint8_t corner = 0; corner < 3; ++corner) {
            const double size = scene.log2TexelSize(faceId(f), corner);
            ASSERT_EQ(size, anew.log2TexelSize(faceId(f), corner)) << "face " << f;
            moved += size != before.log2TexelSize(faceId(f), corner) ? 1 : 0;
        }
    }
    EXPECT_GE(moved, 15); // three rings of five or six corners

    std::vector<Query> queries;
    for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) {
        queries.push_back({faceId(f), {0.3F, 0.2F}, {0.4F, 0.1F}, {-0.1F, 0.2F}});
    }
    for (const char* name : {"trilinear", "probes-2", "ewa"}) {
        const auto method = makeMethod({name, std::nullopt});
        const auto now = ask(*method, scene, queries);
        const auto wanted = ask(*method, anew, queries);
        for (std::size_t q = 0; q < queries.size(); ++q) {
            ASSERT_EQ(difference(now[q], wanted[q]), 0) << name << " face " << q;
        }
    }
}

/// Of a parabola every filter sees its value and the footprint's variance. A texel under a random
/// point is no point: it adds its own spread, which has to be taken off the points before.
TEST(Stochastic, spreadsNoWiderThanTheFootprint)
{
    const TriangleMesh mesh = flatPatch(5);
    const FaceMap<Level> levels(mesh.faceCount(), Level(4));
    const double texel = 1.0 / 16; // edges are 1 long
    const TexelStore store = storeOf(levels, [&](FaceId face, glm::dvec2 uv, int channel) {
        const glm::vec3 p =
            pointAt(mesh.corners(face), static_cast<float>(uv.x), static_cast<float>(uv.y));
        const double along = (channel == 0 ? p.x : p.y) / texel;
        return static_cast<float>(channel == 2 ? 1 : along * along);
    });
    const FilterScene scene = sceneOf(surfaceOf(mesh), store);
    const auto stochastic = makeMethod({"stochastic", 4096});
    const auto exact = makeMethod({"exact", std::nullopt});
    Dice dice(4);
    std::vector<Query> queries;
    for (int k = 0; k < 60; ++k) {
        const double u = dice.between(0.1, 0.5);
        queries.push_back({faceId(24 + dice.below(2)), {u, dice.between(0.1, 0.45)}, {}, {}});
    }
    double surplus = 0;
    const auto drawn = ask(*stochastic, scene, queries);
    const auto sums = ask(*exact, scene, queries);
    for (std::size_t q = 0; q < queries.size(); ++q) {
        for (std::size_t c = 0; c < 2; ++c) {
            surplus += (drawn[q].value[c] - sums[q].value[c]) / (2.0 * double(queries.size()));
        }
    }
    // The floor is a quarter of a squared texel; a texel's own spread is a twenty-fourth.
    EXPECT_NEAR(surplus, 0, 0.25 * 1 / 24);
}

/// Faces that nobody may read.
class Unread final : public FaceReader
{
public:
    Result<bool>
    read(FaceId /*face*/, Level /*level*/, std::span<std::byte> /*texels*/) const override
    {
        ADD_FAILURE() << "was read";
        return false;
    }
    bool stores(FaceId /*face*/, Level /*level*/) const override { return false; }
    std::span<const std::byte> mean(FaceId /*face*/) const override { return {}; }
};

TEST(FilterScene, thatWouldNotFitIntoMemoryIsRefusedBeforeAnythingIsRead)
{
    const TriangleMesh mesh = sphereMesh(3);
    const TexelFormat format{TexelType::Float, 4, {}};
    const auto faces = StoredFaces::make(format, std::make_unique<Unread>());
    TexelStore store(static_cast<std::uint32_t>(mesh.faceCount()),
                     format,
                     Level(),
                     std::vector<std::byte>(format.texelBytes()));
    for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) {
        store.exchange(faceId(f), faces->face(faceId(f), Level(12)));
    }
    NoProgress progress;
    const auto scene = FilterScene::build(
        std::make_shared<const FilterSurface>(surfaceOf(mesh)), store, Threads{1}, progress);
    ASSERT_FALSE(scene);
    EXPECT_NE(scene.error().message.find("MiB of memory"), std::string::npos);
}

} // namespace
} // namespace trixel::test
