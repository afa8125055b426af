// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every filter of the table where filters fail, one test a row of the table of hazards.
#include "core/filter/filter_method.h"
#include "core/study/stability_scenes.h"
#include "tests/stability/hazard_row.h"

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
