// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is particular to the filters that read texels in rectilinear rows.
#include "core/filter/rectilinear_rows.h"
#include "tests/core/filter/filter_footprints.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace trixel::test {
namespace {

TEST(RowTexel, rowsAlternateHalvesAtHalfTexelSteps)
{
    // Lower of cell i at x = i + j/2 + 1/2, upper at i + j/2 + 1.
    for (int j = -3; j < 4; ++j) {
        for (int i = -3; i < 4; ++i) {
            const RowTexel lower{2 * i + j + 1, j};
            const RowTexel upper{2 * i + j + 2, j};
            EXPECT_TRUE(lower.isLower());
            EXPECT_FALSE(upper.isLower());
            EXPECT_EQ(lower.i(), i);
            EXPECT_EQ(upper.i(), i);
        }
    }
}

TEST(RowReader, findsEveryTexelOfTheFaceByRowAndColumn)
{
    const TestScene scene = makeScene(flatPatch(1), Level(3), noiseContent(1));
    const RowReader reader(scene.filter, {faceId(0), {0.3, 0.3}}, Level(3), 0);
    const LevelTexels texels = scene.filter.mips().texels(faceId(0), Level(3));
    for (std::uint32_t t = 0; t < 64; ++t) {
        const TexelCoord at = texelAt(Level(3), static_cast<TexelIndex>(t));
        const int column = 2 * at.i + at.j + (at.half == TexelHalf::Lower ? 1 : 2);
        EXPECT_EQ(reader.texel({column, at.j}), texels.texel(static_cast<TexelIndex>(t)));
    }
}

TEST(RowReader, beyondTheFaceItReadsTheNeighboursTexels)
{
    const TestScene scene = makeScene(flatPatch(3), Level(2), affineContent({1, 10, 0}, 0));
    const FaceId face = faceId(8); // in the middle
    const auto corners = scene.mesh.corners(face);
    const RowReader reader(scene.filter, {face, {0.25, 0.25}}, Level(2), 0);
    for (int row = -2; row < 5; ++row) {
        for (int column = -1; column < 8; ++column) {
            const RowTexel at{column, row};
            const double third = at.isLower() ? 1.0 / 3 : 2.0 / 3;
            const glm::vec3 p = pointAt(corners,
                                        static_cast<float>((at.i() + third) / 4),
                                        static_cast<float>((at.j() + third) / 4));
            EXPECT_NEAR(reader.texel(at)[0], p.x + 10 * p.y, 1e-4) << column << " " << row;
        }
    }
}

TEST(RectilinearBilinear, keepsAnAffineTextureEverywhereInAFlatPatch)
{
    const TestScene scene = makeScene(flatPatch(4), Level(3), affineContent({0.1, 0.1, 0}, 0));
    Dice dice(3);
    for (int k = 0; k < 3000; ++k) {
        const FaceId face = faceId(10 + dice.below(4)); // one row of inner faces
        const glm::dvec2 uv = randomPoint(dice);
        TexelSum sum;
        addRectilinearBilinear(scene.filter, {face, uv}, Level(3), 0, 1, sum);
        const glm::vec3 p =
            pointAt(scene.mesh.corners(face), static_cast<float>(uv.x), static_cast<float>(uv.y));
        EXPECT_NEAR(sum.channels[0], 0.1 * p.x + 0.1 * p.y, 1e-6);
        EXPECT_NEAR(sum.weight, 1, 1e-15);
    }
}

TEST(RectilinearBilinear, doesNotReadWhatHasNoWeight)
{
    // On a column exactly: the texels to its right have weight 0 and are not numbers.
    TriangleMesh mesh = flatPatch(1);
    TexelStore texels =
        filledStore(mesh, FaceMap<Level>(mesh.faceCount(), Level(3)), constantContent(0.5F));
    const TestScene clean = makeScene(mesh, texels);
    const RowReader reader(clean.filter, {faceId(0), {0.25, 0.25}}, Level(3), 0);
    const float* first = clean.filter.mips().texels(faceId(0), Level(3)).values;
    for (const int row : {1, 2}) {
        const auto index =
            static_cast<std::size_t>(reader.texelInside({7, row}) - first) / kGroupChannels;
        const float nan = std::nanf("");
        std::memcpy(&texels.writable(faceId(0))[index * sizeof nan], &nan, sizeof nan);
    }
    const TestScene spoiled = makeScene(std::move(mesh), std::move(texels));
    TexelSum sum;
    // 2u + v = 6/8 is column 6, v = 2/8 lies between rows 1 and 2.
    addRectilinearBilinear(spoiled.filter, {faceId(0), {0.25, 0.25}}, Level(3), 0, 1, sum);
    EXPECT_EQ(sum.channels[0], 0.5);
}

TEST(RectilinearBilinear, hasNoJumpsInsideAFace)
{
    const TestScene scene = makeScene(flatPatch(1), Level(3), noiseContent(2));
    Dice dice(4);
    const auto at = [&](glm::dvec2 uv) {
        TexelSum sum;
        addRectilinearBilinear(scene.filter, {faceId(0), uv}, Level(3), 0, 1, sum);
        return sum.channels[0];
    };
    for (int k = 0; k < 10000; ++k) {
        // Away from the edges, where taps move with the face's shape.
        const glm::dvec2 uv = 0.15 + 0.55 * randomPoint(dice);
        EXPECT_NEAR(at(uv), at(uv + glm::dvec2(1e-7, -1e-7)), 1e-5);
    }
}

TEST(Trilinear, passesThroughTheLevelsWithoutAJump)
{
    const TestScene scene = makeScene(flatPatch(2), Level(5), noiseContent(2));
    for (const double level : {0.0, 0.5, 1.0, 2.0, 3.5, 4.0, 5.0}) {
        std::array<double, 3> values{};
        for (int k = 0; k < 3; ++k) {
            TexelSum sum;
            addTrilinear(scene.filter, {faceId(3), {0.4, 0.3}}, level + (k - 1) * 1e-7, 0, 1, sum);
            values[static_cast<std::size_t>(k)] = sum.channels[0];
        }
        EXPECT_NEAR(values[0], values[1], 1e-6);
        EXPECT_NEAR(values[2], values[1], 1e-6);
    }
}

} // namespace
} // namespace trixel::test
