// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every filter of the table where filters fail, one test a row of the table of hazards.
#include "core/filter/filter_method.h"
#include "core/filter/query_ellipse.h"
#include "core/study/stability/scenes.h"
#include "tests/stability/hazard_row.h"

#include <array>
#include <glm/geometric.hpp>

namespace trixel::test {
namespace {

TEST(FilterHazards, constantsComeOutOfFootprintsFarBelowATexel)
{
    expectKept("narrow-footprints");
}

TEST(FilterHazards, anisotropyToAMillionCostsNoMoreThanTheCap)
{
    expectKept("long-footprints");
}

TEST(FilterHazards, constantTexturesComeOutAsTheyAre)
{
    expectKept("constant-texels");
}

TEST(FilterHazards, aNaNTexelStaysWhereItIs)
{
    expectKept("nan-texels");
}

TEST(FilterHazards, needlesAndFacesWithoutAreaKeepConstants)
{
    expectKept("needle-faces");
    Random random(31);
    for (int k = 0; k < 20000; ++k) {
        const auto any = [&] { return static_cast<float>(random.ofAnySize(-12, 12)); };
        const glm::vec3 a(any(), any(), any());
        const glm::vec3 b(any(), any(), any());
        const std::array<glm::vec3, 3> corners{a,
                                               b,
                                               k % 3 == 0   ? a
                                               : k % 3 == 1 ? (a + b) / 2.0F
                                                            : glm::vec3(any(), any(), any())};
        const FaceShape shape = faceShapeOf(corners);
        const glm::dvec2 back = shape.toUv(shape.toPlane({0.25, 0.5}));
        ASSERT_LE(glm::length(back - glm::dvec2(0.25, 0.5)), 1e-6);
    }
}

/// Value of a texel by where it lies: waves of all lengths, and steps.
float pattern(glm::dvec2 p)
{
    const double waves = std::sin(9 * p.x + 4 * p.y) + std::sin(130 * p.y - 70 * p.x);
    return static_cast<float>(waves + (p.x * 7 - std::floor(p.x * 7) < 0.5 ? 1 : 0));
}

TEST(FilterHazards, exactWeighsLongRowsAsExpDoes)
{
    const Level level(8);
    const TriangleMesh mesh = sweeps::pairOfFaces(); // in the plane of its first face
    const auto placeOf = [&](FaceId face, TexelIndex texel) {
        const auto corners = mesh.corners(face);
        const glm::dvec2 uv = centroid(level, texelAt(level, texel));
        const glm::dvec2 v0(corners[0]);
        return v0 + uv.x * (glm::dvec2(corners[1]) - v0) + uv.y * (glm::dvec2(corners[2]) - v0);
    };
    const std::array<Level, 2> levels{level, level};
    const FilterScene scene =
        sweeps::sceneOf(mesh, levels, [&](FaceId face, Level, TexelIndex texel) {
            return pattern(placeOf(face, texel));
        });
    for (const double length : {0.2, 0.8, 3.0}) {
        QueryArrays queries;
        queries.add(FaceId{0}, {0.4F, 0.3F}, {length, 0.1 * length}, {0.02F, 0.15F});
        ResultArrays results(1, 1);
        makeMethod({"exact", std::nullopt})->filter(scene, queries.queries(), results.results());
        const QueryEllipse e = queryEllipse(scene, queries.queries(), 0);
        long double sum = 0;
        long double weights = 0;
        for (const FaceId face : {FaceId{0}, FaceId{1}}) {
            for (std::uint32_t t = 0; t < level.texelCount(); ++t) {
                const auto texel = static_cast<TexelIndex>(t);
                const glm::dvec2 place = placeOf(face, texel);
                const glm::dvec2 d = place - e.centre;
                const long double q = e.yy * d.x * d.x - 2 * e.xy * d.x * d.y + e.xx * d.y * d.y;
                const long double weight = std::exp(-q / e.determinant / 2);
                weights += weight;
                sum += weight * pattern(place);
            }
        }
        EXPECT_NEAR(results.values[0], static_cast<double>(sum / weights), 1e-5) << length;
    }
}

TEST(FilterHazards, edgesAreSeamlessAboutVerticesOfValence3To100)
{
    expectKept("valence");
}

TEST(FilterHazards, edgesAreSeamlessBetweenFacesTenLevelsApart)
{
    expectKept("level-step");
}

} // namespace
} // namespace trixel::test
