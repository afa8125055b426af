// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ellipses and footprints of pixels, one test a row of the table of hazards.
#include "core/filter/query_ellipse.h"
#include "core/footprint/covariance.h"
#include "core/footprint/footprint.h"
#include "core/footprint/projected_face.h"
#include "core/footprint/screen_derivatives.h"
#include "core/study/stability/scenes.h"
#include "core/study/stability/truth.h"
#include "tests/stability/hazard_row.h"

#include <bit>
#include <glm/geometric.hpp>
#include <numbers>

namespace trixel::test {
namespace {

using sweeps::LongLengths;
using sweeps::LongVec2;

glm::dvec2 unit(double angle)
{
    return {std::cos(angle), std::sin(angle)};
}

TEST(FootprintHazards, parallelVectorsKeepAPositiveDeterminant)
{
    expectKept("parallel-vectors");
    Random random(1);
    for (int k = 0; k < 20000; ++k) {
        const double angle = std::pow(10, random.in(-6, 0));
        const double turn = random.in(0, 7);
        const glm::dvec2 a = random.in(0.1, 3) * unit(turn);
        const glm::dvec2 b = random.in(0.1, 3) * unit(turn + angle);
        const long double area = sweeps::cross(LongVec2(a), LongVec2(b));
        const double found = covarianceOf(a, b, 0).determinant;
        ASSERT_GT(found, 0);
        ASSERT_NEAR(static_cast<double>(found / (area * area)), 1, 1e-6) << angle;
    }
}

TEST(FootprintHazards, theMinorAxisKeepsItsDigitsAtAnyAnisotropy)
{
    expectKept("minor-axis");
    Random random(2);
    for (int k = 0; k < 20000; ++k) {
        const double anisotropy = std::pow(10, random.in(0, 6));
        const double turn = random.in(0, 7);
        const Covariance c = covarianceOf(
            random.in(1, 2) * anisotropy * unit(turn), unit(turn + random.in(0.5, 2.5)), 0);
        const CovarianceAxes axes = axesOf(c);
        ASSERT_GT(axes.minorSigma, 0);
        ASSERT_NEAR(axes.majorSigma * axes.minorSigma / std::sqrt(c.determinant), 1, 1e-6);
        ASSERT_LE(axes.minorSigma, axes.majorSigma);
    }
}

TEST(FootprintHazards, theMajorDirectionHasUnitLengthAtACircle)
{
    expectKept("near-circle");
    for (const double size : {1e-100, 1.0, 1e50}) {
        for (const Covariance& c : {covarianceOf({size, 0}, {0, size}, 0),
                                    covarianceOf({2 * size, 0}, {0, size}, 0),
                                    covarianceOf({size, 0}, {0, 2 * size}, 0),
                                    covarianceOf({0, 0}, {0, 0}, size)}) {
            ASSERT_NEAR(glm::length(axesOf(c).majorAxis), 1, 1e-12);
        }
    }
    EXPECT_EQ(axesOf({}).majorAxis, glm::dvec2(1, 0));
}

TEST(FootprintHazards, vectorsOfAnyBitPatternGiveAFiniteEllipse)
{
    expectKept("vector-length");
    const FilterScene scene = sweeps::flatScene(Level(6));
    Random random(4);
    for (int k = 0; k < 50000; ++k) {
        const auto any = [&] {
            return static_cast<double>(
                std::bit_cast<float>(static_cast<std::uint32_t>(random.engine())));
        };
        const QueryEllipse e =
            queryEllipse(scene, FaceId{0}, {any(), any()}, {any(), any()}, {any(), any()});
        ASSERT_TRUE(std::isfinite(e.majorSigma) && std::isfinite(e.determinant));
        ASSERT_GT(e.minorSigma, 0);
        ASSERT_LE(e.minorSigma, e.majorSigma);
        ASSERT_GE(e.minorSigma, 0.5 / 64 * (1 - 1e-6)); // half a texel
        ASSERT_NEAR(glm::length(e.majorAxis), 1, 1e-9);
    }
}

TEST(FootprintHazards, silhouettesStayOrderedAndWithinTheLimit)
{
    expectKept("silhouette");
    Random random(5);
    const auto expectOrdered = [](const ScreenDerivatives& d) {
        const Footprint f = footprintOf(d, 64);
        const LongLengths lengths{LongVec2(f.w1), LongVec2(f.w2)};
        ASSERT_TRUE(std::isfinite(static_cast<double>(lengths.major)));
        ASSERT_LE(lengths.minor, lengths.major * (1 + 1e-12L));
        ASSERT_LE(lengths.major, 64 * (1 + 1e-12L));
    };
    expectOrdered({{0, 0}, {0, 0}});
    expectOrdered({{3, 4}, {3, 4}});
    expectOrdered({{3, 4}, {0, 0}});
    for (int k = 0; k < 20000; ++k) {
        const glm::dvec2 a(random.ofAnySize(-30, 30), random.ofAnySize(-30, 30));
        const double ratio = random.ofAnySize(-3, 3);
        expectOrdered({a, ratio * a});
        expectOrdered({a, ratio * a + glm::dvec2(random.ofAnySize(-30, 30), 0)});
    }
}

TEST(FootprintHazards, sweepingWThroughZeroGivesNoNaNAndNothingBehind)
{
    expectKept("camera-plane");
    for (int k = -2000; k <= 2000; ++k) {
        const double w = k / 2000.0;
        const ProjectedFace face{{200, 100, w}, {300, 40, 0.5}, {-60, 280, -0.3}};
        const auto f = footprintOf(face, {0, 0}, 64);
        ASSERT_EQ(f.has_value(), w > 0) << w;
        if (f) {
            const LongLengths lengths{LongVec2(f->w1), LongVec2(f->w2)};
            ASSERT_TRUE(std::isfinite(static_cast<double>(lengths.major)));
            ASSERT_LE(lengths.major, 64.000001L);
        }
    }
}

TEST(FootprintHazards, pixelsAcrossASeamOfTheAtlasSeeTheFacesOwnDerivative)
{
    expectKept("atlas-seam");
    // From straight above, a pixel is the same everywhere: up to the border and beyond it.
    const std::array<glm::vec3, 3> face{glm::vec3{0, 0, 0}, glm::vec3{1, 0, 0}, glm::vec3{0, 1, 0}};
    for (double x = 0.4; x < 0.6; x += 0.01) {
        const PixelRay ray{{x, 0.5, 3}, {0, 0, -1}, {0.01, 0, 0}, {0, 0.01, 0}};
        const Footprint f = screenFootprint(ray, face);
        ASSERT_NEAR(glm::length(f.w1 - glm::dvec2(0.03, 0)), 0, 1e-12) << x;
        ASSERT_NEAR(glm::length(f.w2 - glm::dvec2(0, 0.03)), 0, 1e-12) << x;
    }
}

} // namespace
} // namespace trixel::test
