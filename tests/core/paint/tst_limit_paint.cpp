// SPDX-License-Identifier: GPL-3.0-or-later
//
// Strokes on the limit surface.
#include "core/mesh/loop_refinement.h"
#include "core/paint/paint_surface.h"
#include "core/paint/stroke_file.h"
#include "tests/core/mesh/cages.h"
#include "tests/core/paint/paint_fixture.h"

#include <glm/geometric.hpp>
#include <gmock/gmock.h>

namespace trixel {
namespace {

using namespace test;
using testing::HasSubstr;

std::shared_ptr<const LimitMesh> limitOf(const Surface& surface)
{
    NoProgress progress;
    return limitToPaintOn(surface, {}, Threads::all(), progress).value();
}

FaceMap<Level> levelsOf(std::size_t faces, int least, int most)
{
    FaceMap<Level> levels(faces);
    for (std::size_t f = 0; f < faces; ++f) {
        levels[faceId(f)] = Level(least + static_cast<int>(f) % (most - least + 1));
    }
    return levels;
}

/// Calls work(face, texel, where its centroid lies on the limit).
void forEachLimitTexel(const LimitSurface& limit,
                       const TexelStore& store,
                       const std::function<void(FaceId, TexelIndex, const LimitPoint&)>& work)
{
    LimitSurface::Evaluator evaluator(limit);
    for (std::size_t f = 0; f < store.faceCount(); ++f) {
        const Level level = store.face(faceId(f)).level();
        evaluator.moveTo(faceId(f));
        for (std::uint32_t t = 0; t < level.texelCount(); ++t) {
            work(faceId(f),
                 TexelIndex{t},
                 evaluator.at(centroid(level, texelAt(level, TexelIndex{t}))));
        }
    }
}

TEST(LimitPaint, aDabCoversTexelsByWhereTheyLieOnTheLimitWhateverTheirLevel)
{
    const auto surface = surfaceOf(icosahedron());
    const auto limit = limitOf(*surface);
    for (const float radius : {0.02F, 0.3F, 0.9F}) {
        for (const int most : {3, 7}) {
            TexelStore store = coverageStore(levelsOf(20, most - 3, most));
            Brush brush = whiteBrush(radius);
            brush.hardness = 0.25F;
            brush.flow = 1;
            brush.paintThrough = true;
            const StrokeSample sample{faceId(4), {0.21F, 0.4F}};
            Stroke stroke(surface, brush, zeroFill(store), Threads{2}, limit);
            stroke.add(sample, store);
            const glm::dvec3 centre =
                limit->surface().at(sample.face, glm::dvec2(sample.uv)).position;
            int painted = 0;
            forEachLimitTexel(
                limit->surface(), store, [&](FaceId face, TexelIndex texel, const LimitPoint& p) {
                    const double distance = glm::distance(p.position, centre) / radius;
                    const double expected = falloffAt(distance, 0.25);
                    painted += expected > 0 ? 1 : 0;
                    ASSERT_NEAR(valueAt(store, face, texel), expected, 2e-4)
                        << indexOf(face) << ":" << indexOf(texel);
                });
            EXPECT_TRUE(painted > 0 || most == 3) << radius;
        }
    }
}

TEST(LimitPaint, facesThatFaceAwayAreLeftOutUnlessPaintedThrough)
{
    // A thin lens: its two sides are closer to each other than the brush is wide.
    TriangleMesh lens = bipyramid(8);
    lens.positions[0].z = 0.02F;
    lens.positions[1].z = -0.02F;
    const auto surface = surfaceOf(lens);
    const auto limit = limitOf(*surface);
    for (const bool through : {false, true}) {
        TexelStore store = coverageStore(levelsOf(16, 4, 4));
        Brush brush = whiteBrush(0.2F);
        brush.paintThrough = through;
        Stroke stroke(surface, brush, zeroFill(store), Threads{1}, limit);
        stroke.add({faceId(0), {0.3F, 0.3F}}, store); // even faces are above, odd ones below
        int above = 0;
        int below = 0;
        forEachLimitTexel(limit->surface(), store, [&](FaceId f, TexelIndex t, const LimitPoint&) {
            (indexOf(f) % 2 == 0 ? above : below) += valueAt(store, f, t) > 0 ? 1 : 0;
        });
        EXPECT_GT(above, 20);
        EXPECT_EQ(below > 0, through);
    }
}

/// A way over several faces.
std::vector<StrokeSample> samples()
{
    std::vector<StrokeSample> way;
    for (int k = 0; k < 12; ++k) {
        const std::uint32_t face = static_cast<std::uint32_t>(k) / 3;
        way.push_back({faceId(face),
                       {0.15F + 0.2F * static_cast<float>(k % 3), 0.25F},
                       0.5F + 0.04F * static_cast<float>(k),
                       0.01 * k});
    }
    return way;
}

TEST(LimitPaint, aReplayedFileGivesTheTexelsOfTheStrokeWhateverTheThreads)
{
    const auto surface = surfaceOf(icosahedron());
    RecordedStroke recorded{whiteBrush(0.2F), samples()};
    recorded.onLimit = true;
    recorded.brush.pressureToSize = true;

    TexelStore direct = coverageStore(levelsOf(20, 3, 6));
    Stroke stroke(surface, recorded.brush, zeroFill(direct), Threads{2}, limitOf(*surface));
    for (const StrokeSample& sample : recorded.samples) {
        stroke.add(sample, direct);
    }
    (void)stroke.finish(direct);

    const std::string text = writeStrokes(std::span(&recorded, 1));
    const auto parsed = parseStrokes(text, 20);
    ASSERT_TRUE(parsed);
    EXPECT_TRUE((*parsed)[0].onLimit);
    for (const unsigned threads : {1U, 3U}) {
        TexelStore replayed = coverageStore(levelsOf(20, 3, 6));
        NoProgress progress;
        ASSERT_TRUE(replayStrokes(
            *parsed, surface, zeroFill(replayed), replayed, Threads{threads}, progress));
        int painted = 0;
        for (std::size_t f = 0; f < 20; ++f) {
            const auto a = direct.face(faceId(f)).bytes();
            EXPECT_TRUE(std::ranges::equal(a, replayed.face(faceId(f)).bytes())) << f;
            painted += std::ranges::any_of(a, [](std::byte b) { return b != std::byte{}; }) ? 1 : 0;
        }
        EXPECT_GT(painted, 3);
    }
}

TEST(LimitPaint, aStrokeOnTheCageIsAnother)
{
    const auto surface = surfaceOf(icosahedron());
    TexelStore cage = coverageStore(levelsOf(20, 5, 5));
    TexelStore limit = cage;
    RecordedStroke recorded{whiteBrush(0.2F), samples()};
    NoProgress progress;
    ASSERT_TRUE(replayStrokes(
        std::span(&recorded, 1), surface, zeroFill(cage), cage, Threads{1}, progress));
    recorded.onLimit = true;
    ASSERT_TRUE(replayStrokes(
        std::span(&recorded, 1), surface, zeroFill(limit), limit, Threads{1}, progress));
    EXPECT_FALSE(std::ranges::equal(cage.face(faceId(1)).bytes(), limit.face(faceId(1)).bytes()));
}

TEST(LimitPaint, creasesAreWhereStrokesFindThem)
{
    // The top of a cube that its edges are creases of stays flat, and so as far as it was.
    const auto surface = surfaceOf(cube());
    NoProgress progress;
    const auto heightOf = [&](CreaseAngle creases) {
        const auto limit = limitToPaintOn(*surface, creases, Threads::all(), progress).value();
        return limit->raycast({{0.1F, 0.2F, 5}, {0, 0, -1}})->position.z;
    };
    EXPECT_NEAR(heightOf(30.0F), 1, 1e-5);
    EXPECT_LT(heightOf({}), 0.9);

    RecordedStroke recorded{whiteBrush(0.3F),
                            {{faceId(2), {0.3F, 0.3F}}, {faceId(3), {0.3F, 0.3F}}}};
    recorded.onLimit = true;
    std::vector<TexelStore> painted;
    for (const CreaseAngle creases : {CreaseAngle(), CreaseAngle(30.0F)}) {
        TexelStore store = coverageStore(levelsOf(12, 5, 5));
        ASSERT_TRUE(replayStrokes(std::span(&recorded, 1),
                                  surface,
                                  zeroFill(store),
                                  store,
                                  Threads{1},
                                  progress,
                                  creases));
        painted.push_back(store);
    }
    EXPECT_FALSE(
        std::ranges::equal(painted[0].face(faceId(2)).bytes(), painted[1].face(faceId(2)).bytes()));
}

TEST(LimitPaint, undoTakesBackAllOfIt)
{
    const auto surface = surfaceOf(icosahedron());
    TexelStore store = coverageStore(levelsOf(20, 0, 6));
    const TexelStore before = store;
    Stroke stroke(surface, whiteBrush(0.4F), zeroFill(store), Threads{2}, limitOf(*surface));
    std::size_t touched = 0;
    for (const StrokeSample& sample : samples()) {
        touched += stroke.add(sample, store).size();
    }
    EXPECT_GT(touched, 0U);
    TexelPatch patch = stroke.finish(store);
    patch.swap(store);
    for (std::size_t f = 0; f < 20; ++f) {
        EXPECT_TRUE(
            std::ranges::equal(before.face(faceId(f)).bytes(), store.face(faceId(f)).bytes()));
    }
}

TEST(LimitPaint, filesSayWhichSurfaceAndOldOnesMeanTheCage)
{
    const std::string old =
        R"({"version":1,"strokes":[{"brush":{"radius":1,"color":[1]},"samples":[]}]})";
    EXPECT_FALSE((*parseStrokes(old, 1))[0].onLimit);
    const RecordedStroke onCage{whiteBrush(1), {}};
    EXPECT_THAT(writeStrokes(std::span(&onCage, 1)), testing::Not(HasSubstr("surface")));
    const std::string other =
        R"({"version":1,"strokes":[{"surface":"sea","brush":{"radius":1,"color":[1]},"samples":[]}]})";
    EXPECT_THAT(parseStrokes(other, 1).error().message,
                testing::AllOf(HasSubstr("stroke 1"), HasSubstr("\"cage\" or \"limit\"")));
}

TEST(LimitPaint, aStrokeOnTheLimitOfWhatHasNoneIsRefusedAndChangesNothing)
{
    TriangleMesh broken = icosahedron();
    broken.triangles.push_back({0, 1, 0});
    const auto surface = surfaceOf(broken);
    TexelStore store = coverageStore(levelsOf(21, 2, 2));
    RecordedStroke recorded{whiteBrush(0.5F), samples()};
    recorded.onLimit = true;
    NoProgress progress;
    const Status replayed = replayStrokes(
        std::span(&recorded, 1), surface, zeroFill(store), store, Threads{1}, progress);
    ASSERT_FALSE(replayed);
    EXPECT_THAT(
        replayed.error().message,
        testing::AllOf(HasSubstr("limit surface"), HasSubstr("face 20 has a corner twice")));
}

} // namespace
} // namespace trixel
