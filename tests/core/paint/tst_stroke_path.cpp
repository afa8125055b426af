// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/paint/stroke_path.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <vector>

using namespace trixel;

namespace {

using Points = std::vector<StrokePath::Point>;

Brush brushOf(float radius, float spacing)
{
    Brush brush;
    brush.radius = radius;
    brush.spacing = spacing;
    return brush;
}

Points follow(const Brush& brush, std::span<const std::pair<glm::vec3, float>> samples)
{
    StrokePath path(brush);
    Points points;
    for (const auto& [position, pressure] : samples) {
        path.moveTo(position, pressure, [&](const auto& point) { points.push_back(point); });
    }
    return points;
}

} // namespace

TEST(StrokePath, theFirstDabIsAtTheFirstSampleAndTheOthersAtEqualDistances)
{
    const std::array<std::pair<glm::vec3, float>, 3> samples{
        {{{0, 0, 0}, 1}, {{1, 0, 0}, 1}, {{1, 1, 0}, 1}}};
    const Points points = follow(brushOf(0.5F, 0.3F), samples); // every 0.3
    ASSERT_EQ(points.size(), 7U);
    EXPECT_TRUE(points[0].isSample);
    EXPECT_EQ(points[0].position, glm::vec3(0));
    for (std::size_t k = 1; k < points.size(); ++k) {
        EXPECT_FALSE(points[k].isSample);
        const float along = 0.3F * static_cast<float>(k);
        const glm::vec3 expected = along < 1 ? glm::vec3(along, 0, 0) : glm::vec3(1, along - 1, 0);
        EXPECT_NEAR(glm::length(points[k].position - expected), 0, 1e-6F);
    }
}

TEST(StrokePath, samplesInBetweenChangeNothing)
{
    Brush brush = brushOf(0.05F, 0.2F);
    brush.pressureToSize = true;
    const std::pair<glm::vec3, float> from{{0, 0, 0}, 0.2F};
    const std::pair<glm::vec3, float> to{{2, 1, 3}, 1.0F};
    std::vector<std::pair<glm::vec3, float>> few{from, to};
    std::vector<std::pair<glm::vec3, float>> many;
    for (int k = 0; k <= 1000; ++k) {
        const float part = static_cast<float>(k) / 1000;
        many.emplace_back(part * to.first, 0.2F + part * 0.8F);
    }
    const Points a = follow(brush, few);
    const Points b = follow(brush, many);
    ASSERT_EQ(a.size(), b.size());
    ASSERT_GT(a.size(), 100U);
    for (std::size_t k = 0; k < a.size(); ++k) {
        EXPECT_NEAR(glm::length(a[k].position - b[k].position), 0, 2e-5F);
        EXPECT_NEAR(a[k].pressure, b[k].pressure, 1e-5F);
    }
}

TEST(StrokePath, pressureThatSetsTheSizeSetsTheDistanceToo)
{
    Brush brush = brushOf(0.5F, 0.1F);
    brush.pressureToSize = true;
    const std::array<std::pair<glm::vec3, float>, 2> samples{
        {{{0, 0, 0}, 0.5F}, {{1, 0, 0}, 0.5F}}};
    const Points points = follow(brush, samples);
    ASSERT_GE(points.size(), 19U);
    EXPECT_NEAR(points[1].position.x, 0.05F, 1e-6F);
}

TEST(StrokePath, restingPlacesNoMoreDabs)
{
    const std::vector<std::pair<glm::vec3, float>> samples(50, {glm::vec3(1, 2, 3), 1.0F});
    EXPECT_EQ(follow(brushOf(0.5F, 0.1F), samples).size(), 1U);
}

TEST(StrokePath, aTinyRadiusOnALongWayPlacesABoundedNumberOfDabs)
{
    Brush brush = brushOf(1e-30F, 0.1F);
    const std::array<std::pair<glm::vec3, float>, 3> samples{
        {{{0, 0, 0}, 0}, {{1e10F, 0, 0}, 0}, {{1e10F, 3e38F, 0}, 0}}};
    EXPECT_LE(follow(brush, samples).size(), 2U * StrokePath::kMaxDabs + 3);
    brush.pressureToSize = true;
    EXPECT_LE(follow(brush, samples).size(), 2U * StrokePath::kMaxDabs + 3);
}
