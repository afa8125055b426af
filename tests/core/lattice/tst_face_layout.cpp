// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lattice/face_layout.h"
#include "core/lattice/paint_projection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>
#include <vector>

using namespace trixel;

namespace {

std::vector<FaceLayout> layouts()
{
    const PlaneMap turned{{30, -2}, {12, 5}, {-5, 12}};
    return {FaceLayout::triangle({1, 2}, {5, 1}, {2, 7}),
            FaceLayout::rectilinear(),
            FaceLayout::packed(),
            FaceLayout::packed().moved(turned),
            FaceLayout::rectilinear().moved({{0, 100}, {80, 0}, {0, -80}})};
}

double areaOf(std::span<const glm::dvec2> corners)
{
    double twice = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const glm::dvec2 a = corners[k];
        const glm::dvec2 b = corners[(k + 1) % corners.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return twice / 2;
}

template <class Visit>
void forEachTexel(Level level, Visit visit)
{
    for (std::uint32_t k = 0; k < level.texelCount(); ++k) {
        visit(texelAt(level, static_cast<TexelIndex>(k)));
    }
}

} // namespace

TEST(PlaneMap, inverseTakesPointsBack)
{
    const PlaneMap map{{3, -4}, {2, 1}, {-1, 5}};
    const glm::dvec2 p(0.3, 0.9);
    EXPECT_LT(glm::distance(map.inverse().point(map.point(p)), p), 1e-14);
    EXPECT_LT(glm::distance(map.after(map.inverse()).point(p), p), 1e-14);
}

TEST(FaceLayout, theTexelAtItsOwnCentreIsThatTexel)
{
    for (const FaceLayout& layout : layouts()) {
        for (const Level level : {Level(0), Level(1), Level(3), Level(5)}) {
            forEachTexel(level, [&](TexelCoord texel) {
                EXPECT_EQ(layout.texelAt(level, layout.centre(level, texel)), texel);
            });
        }
    }
}

TEST(FaceLayout, outlinesTileTheFace)
{
    for (const FaceLayout& layout : layouts()) {
        const Level level(4);
        const double face = areaOf(layout.outline().corners());
        double sum = 0;
        forEachTexel(level, [&](TexelCoord texel) {
            const TexelOutline outline = layout.outline(level, texel);
            const double area = areaOf(outline.corners());
            EXPECT_NEAR(area, face / level.texelCount(), 1e-9 * std::abs(face)); // none turned over
            sum += area;
            glm::dvec2 middle(0);
            for (const glm::dvec2 corner : outline.corners()) {
                middle += corner / static_cast<double>(outline.corners().size());
            }
            EXPECT_LT(glm::distance(middle, layout.centre(level, texel)), 1e-9);
        });
        EXPECT_NEAR(sum, face, 1e-9 * std::abs(face));
    }
}

TEST(FaceLayout, everyPointOfTheOutlineBelongsToATexelAndNothingBeside)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(-0.5, 1.5);
    for (const FaceLayout& layout : layouts()) {
        for (int k = 0; k < 2000; ++k) {
            const glm::dvec2 p(any(random), any(random));
            const bool square = layout.texels() == FaceLayout::Texels::Pixels;
            const bool inside = square ? p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1
                                       : p.x >= 0 && p.y >= 0 && p.x + p.y <= 1;
            const auto texel = layout.texelAt(Level(6), layout.map().point(p));
            EXPECT_EQ(texel.has_value(), inside);
            EXPECT_TRUE(!texel || isValid(Level(6), *texel));
        }
        const double nan = std::numeric_limits<double>::quiet_NaN();
        EXPECT_FALSE(layout.texelAt(Level(6), {nan, nan}));
        EXPECT_FALSE(layout.texelAt(Level(6), {1e300, 1e300}));
    }
}

TEST(FaceLayout, packedPixelsAreSampledAtTheCentroid)
{
    const Level level(3);
    const FaceLayout packed = FaceLayout::packed();
    forEachTexel(level, [&](TexelCoord texel) {
        const PackedPixel pixel = packedPixel(level, texel);
        const glm::dvec2 middle = (glm::dvec2(pixel.x, pixel.y) + 0.5) / 8.0;
        EXPECT_LT(glm::distance(packed.centre(level, texel), middle), 1e-12);
        const glm::dvec2 corner = packed.triangleOf(level, texel)[0] * 8.0;
        // Begins 1/6 inside its pixel and ends 1/6 beyond it.
        EXPECT_NEAR(corner.x - std::floor(corner.x), 1.0 / 6, 1e-12);
        EXPECT_NEAR(corner.y - std::floor(corner.y), 1.0 / 6, 1e-12);
    });
}

TEST(FaceLayout, rowsOfTheRectilinearViewAreRows)
{
    const FaceLayout view = FaceLayout::rectilinear();
    EXPECT_EQ(view.corner(2), glm::dvec2(0.5, 1));
    const Level level(3);
    // Texels alternate every half unit of x.
    const glm::dvec2 lower = view.centre(level, {2, 3, TexelHalf::Lower}) * 8.0;
    const glm::dvec2 upper = view.centre(level, {2, 3, TexelHalf::Upper}) * 8.0;
    EXPECT_NEAR(upper.x - lower.x, 0.5, 1e-12);
    EXPECT_NEAR(lower.x, 2 + 3 / 2.0 + 0.5, 1e-12);
}

TEST(FaceLayoutDeathTest, refusesATriangleWithoutArea)
{
    EXPECT_DEATH((void)FaceLayout::triangle({0, 0}, {1, 1}, {2, 2}), "area");
}
