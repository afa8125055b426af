// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/level_plan.h"
#include "core/texture/texel_store.h"
#include "tests/core/test_meshes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

using namespace trixel;

namespace {

/// Equilateral triangles of the given edge lengths, apart from each other.
TriangleMesh equilaterals(std::span<const float> lengths)
{
    TriangleMesh mesh;
    for (const float length : lengths) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.emplace_back(0, 0, 0);
        mesh.positions.emplace_back(length, 0, 0);
        mesh.positions.emplace_back(length / 2, length * std::sqrt(0.75F), 0);
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

} // namespace

TEST(LevelPlan, densityGivesTheNearestPowerOfTwoAlongTheEdge)
{
    const std::array lengths{1.0F, 2.0F, 0.25F, 1.3F, 1.5F, 1e-9F, 1e9F};
    const auto plan = planByDensity(equilaterals(lengths), 64);
    ASSERT_TRUE(plan);
    const std::array expected{6, 7, 4, 6, 7, 0, 12}; // 1.3 · 64 = 83, 1.5 · 64 = 96
    std::uint64_t texels = 0;
    for (std::size_t k = 0; k < lengths.size(); ++k) {
        EXPECT_EQ(plan->levels[faceId(k)].log2(), expected[k]) << lengths[k];
        texels += std::uint64_t{1} << (2 * expected[k]);
    }
    EXPECT_EQ(plan->texels, texels);
    EXPECT_EQ(plan->bytes(TexelFormat{TexelType::Half, 3, std::nullopt}), texels * 6);
}

TEST(LevelPlan, densityIsUniformWithinAFactorOfRootTwo)
{
    const TriangleMesh mesh = test::sphereMesh(2);
    const auto plan = planByDensity(mesh, 300);
    for (std::size_t k = 0; k < mesh.faceCount(); ++k) {
        const auto [a, b, c] = mesh.corners(faceId(k));
        const float length = std::sqrt(
            (glm::dot(b - a, b - a) + glm::dot(c - b, c - b) + glm::dot(a - c, a - c)) / 3);
        const float density = static_cast<float>(plan->levels[faceId(k)].resolution()) / length;
        EXPECT_LE(std::abs(std::log2(density / 300)), 0.501F);
    }
}

TEST(LevelPlan, totalGivesTheLargestDensityThatFits)
{
    const TriangleMesh mesh = test::soupMesh(500, 9);
    for (const std::uint64_t total : {500ULL, 503ULL, 30'000ULL, 1'234'567ULL, 40'000'000ULL}) {
        const auto plan = planByTotal(mesh, total);
        ASSERT_TRUE(plan);
        EXPECT_LE(plan->texels, total);
        std::uint64_t texels = 0;
        for (const Level level : plan->levels.values()) {
            texels += level.texelCount();
        }
        EXPECT_EQ(plan->texels, texels);
        // No density fits that gives more: walk up in small steps from far below.
        std::uint64_t best = 0;
        for (double logDensity = -20; logDensity < 40; logDensity += 0.01) {
            const std::uint64_t t = planByDensity(mesh, std::exp2(logDensity))->texels;
            if (t > total) {
                break;
            }
            best = t;
        }
        EXPECT_GE(plan->texels, best);
        EXPECT_GE(static_cast<double>(plan->texels), 0.9 * static_cast<double>(best));
    }
}

TEST(LevelPlan, totalBeyondEverythingGivesTheHighestLevel)
{
    const auto plan = planByTotal(test::gridMesh(2), std::numeric_limits<std::uint64_t>::max());
    ASSERT_TRUE(plan);
    EXPECT_EQ(plan->texels, 8ULL << 24U);
}

TEST(LevelPlan, refusesWhatMakesNoSense)
{
    const TriangleMesh mesh = test::gridMesh(2);
    for (const double density :
         {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        const auto plan = planByDensity(mesh, density);
        ASSERT_FALSE(plan);
        EXPECT_NE(plan.error().message.find("density"), std::string::npos);
    }
    EXPECT_FALSE(planByTotal(mesh, 7));
    EXPECT_TRUE(planByTotal(mesh, 8));
}

TEST(LevelPlan, aStoreOfPlannedLevelsSharesItsFill)
{
    const std::array<std::byte, 3> grey{};
    const LevelPlan plan = planUniform(100'000, Level(4));
    EXPECT_EQ(plan.texels, 100'000ULL * 256);
    const TexelStore uniform(TexelFormat{}, plan.levels, grey);
    EXPECT_EQ(uniform.texelCount(), plan.texels);
    EXPECT_TRUE(uniform.face(faceId(0)).sharesBytesWith(uniform.face(faceId(99'999))));

    LevelPlan mixed = plan;
    mixed.levels[faceId(300)] = Level(7);
    const TexelStore store(TexelFormat{}, mixed.levels, grey);
    EXPECT_EQ(store.face(faceId(300)).level(), Level(7));
    EXPECT_EQ(store.face(faceId(299)).level(), Level(4));
    EXPECT_TRUE(store.face(faceId(300)).sharesBytesWith(store.face(faceId(99'999))));
    EXPECT_EQ(store.storedBytes(), uniform.storedBytes());
}
