// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/filter/golden_queries.h"
#include "tests/core/filter/irregular_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace trixel;
using namespace trixel::test;

namespace {

std::unique_ptr<const FilterMethod> referenceLoop()
{
    return makeMethod({"reference-loop", std::nullopt});
}

} // namespace

TEST(ReferenceLoop, givesWhatTheLibraryGave)
{
    // Its reductions are rounded to the file's half floats, ours are not: half an ulp a level.
    const GoldenQueries golden = goldenQueries();
    const auto answers = ask(*referenceLoop(), goldenScene(), golden.queries);
    double squares = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double error = answers[i].value[c] - golden.library[i][c];
            EXPECT_LE(std::abs(error), 3e-4) << "query " << i;
            squares += error * error;
        }
    }
    EXPECT_LE(std::sqrt(squares / static_cast<double>(3 * answers.size())), 8e-5);
}

TEST(ReferenceLoop, isExactWhereItReadsTheBaseLevelAndCutsLittleOff)
{
    // Of footprints as narrow as a texel the library reads the base level too; what differs from
    // the exact answer is the tail beyond 3.5 sigma, which holds 0.2 % of the weight.
    const TriangleMesh mesh = gridMesh(4);
    const FilterSurface surface = FilterSurface::equilateral(buildAdjacency(mesh.triangles));
    const FaceMap<Level> levels(mesh.faceCount(), Level(5));
    const FilterScene scene = sceneOf(surface, storeOf(levels, noise(1)));
    std::mt19937 random(1);
    for (int k = 0; k < 100; ++k) {
        const auto face = faceId(random() % mesh.faceCount());
        const float u = static_cast<float>(random() % 100) / 200;
        const float v = static_cast<float>(random() % 100) / 200;
        const Query query{face, {u, v}, {1.0F / 64, 0}, {0, 1.0F / 64}};
        const Answer answer = ask(*referenceLoop(), scene, query);
        EXPECT_EQ(answer.level, 5.0F);
        const Answer exact = ask(*makeMethod({"exact", std::nullopt}), scene, query);
        EXPECT_LE(difference(answer, exact), 4e-3);
    }
}

TEST(ReferenceLoop, seesWideFootprintsWholeWhenTheCutIsMovedAway)
{
    // Ten texels long and one wide, over faces of four: the library reads a face and a bit.
    const TriangleMesh mesh = gridMesh(12);
    const FilterSurface surface = FilterSurface::equilateral(buildAdjacency(mesh.triangles));
    const FaceMap<Level> levels(mesh.faceCount(), Level(2));
    const FilterScene scene = sceneOf(surface, storeOf(levels, noise(3)));
    double worstWhole = 0;
    double worstCut = 0;
    for (const float turn : {0.0F, 0.5F, 1.1F, 1.7F, 2.3F, 2.9F}) {
        const glm::vec2 along(std::cos(turn), std::sin(turn));
        const Query query{faceId(144), {0.3F, 0.4F}, 2.5F * along, {-along.y / 8, along.x / 8}};
        const Answer exact = ask(*makeMethod({"exact", std::nullopt}), scene, query);
        const Answer whole = ask(*makeMethod({"reference-loop", 26.0}), scene, query);
        ASSERT_EQ(whole.level, 2.0F);
        worstWhole = std::max(worstWhole, difference(whole, exact));
        worstCut = std::max(worstCut, difference(ask(*referenceLoop(), scene, query), exact));
    }
    EXPECT_LE(worstWhole, 4e-3);
    EXPECT_GE(worstCut, 2e-2);
}

TEST(ReferenceLoop, givesANumberForEveryFootprint)
{
    const TriangleMesh mesh = irregularSphere(1, 2);
    const FaceMap<Level> levels = randomLevels(mesh.faceCount(), 0, 4, 2);
    const FilterScene scene = sceneOf(surfaceOf(mesh), storeOf(levels, noise(2)));
    const float inf = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::array<float, 11> sizes = {
        0, 1e-45F, 1e-20F, 1e-6F, 1e-3F, 0.1F, 1, 1e4F, 1e38F, inf, nan};
    std::mt19937 random(3);
    for (int k = 0; k < 3000; ++k) {
        const auto pick = [&] {
            return sizes[random() % sizes.size()] * (random() % 2 == 0 ? 1.0F : -1.0F);
        };
        const float u = static_cast<float>(random() % 129) / 128;
        Query query{
            faceId(random() % mesh.faceCount()), {u, 1 - u}, {pick(), pick()}, {pick(), pick()}};
        if (random() % 3 == 0) {
            query.uv = {pick(), pick()};
        }
        for (const double value : ask(*referenceLoop(), scene, query).value) {
            EXPECT_GE(value, 0.0);
            EXPECT_LE(value, 1.0);
        }
    }
}

TEST(ReferenceLoop, takesAHugeFootprintAsTheWidest)
{
    const FilterScene scene = goldenScene();
    const auto along = [&](float length) {
        return ask(*referenceLoop(), scene, {faceId(60), {0.3F, 0.3F}, {length, 0}, {0, length}});
    };
    const Answer widest = along(1024);
    EXPECT_GT(widest.taps, 1U);
    for (const float length : {1e6F, 1e20F, 3e38F}) {
        EXPECT_EQ(along(length).value, widest.value) << length;
    }
}
