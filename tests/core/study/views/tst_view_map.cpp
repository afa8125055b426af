// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/views/view_map.h"
#include "tests/core/filter/filter_scenes.h"
#include "tests/core/test_meshes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace trixel {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

float difference(std::array<float, 2> values, std::array<float, 2> reference, double range = 1)
{
    return differenceOf(values, reference, range);
}

TEST(ViewMap, theDifferenceIsTheLargestOfAChannelInPartsOfTheRange)
{
    EXPECT_EQ(difference({1, 5}, {2, 2}, 4), 0.75F);
    EXPECT_EQ(difference({5, 1}, {2, 2}, 4), 0.75F);
    EXPECT_EQ(difference({1, 5}, {2, 2}, 0), 0); // of texels that are all the same
}

TEST(ViewMap, oneAnswerThatIsNoNumberIsInfinitelyWrongTwoAreRight)
{
    EXPECT_EQ(difference({0, kNaN}, {0, 0}), kInfinity);
    EXPECT_EQ(difference({0, 0}, {kNaN, 0}), kInfinity);
    EXPECT_EQ(difference({kNaN, 1}, {kNaN, 1}), 0);
    EXPECT_EQ(difference({kInfinity, 1}, {kInfinity, 1}), 0);
    EXPECT_EQ(difference({kInfinity, 1}, {-kInfinity, 1}), kInfinity);
    EXPECT_EQ(difference({kNaN, 3}, {kNaN, 1}), 2); // the other channels still count
}

/// Answers 1 everywhere, and refuses every third query.
class Refusing final : public FilterMethod
{
public:
    void filter(const FilterScene& scene,
                const FilterQueries& queries,
                const FilterResults& results) const override
    {
        for (std::size_t i = 0; i < queries.size(); ++i) {
            const bool refuses = static_cast<int>(std::lround(queries.u[i] * 100)) % 3 == 0;
            for (int c = 0; c < scene.channels(); ++c) {
                results.values[static_cast<std::size_t>(c) * results.stride + i] = 1;
            }
            results.taps[i] = refuses ? kRefusedTaps : 1;
        }
    }
};

TEST(ViewMap, whatAMethodRefusesHasNoError)
{
    const TriangleMesh mesh = test::gridMesh(2);
    const FaceMap<Level> levels(mesh.faceCount(), Level(1));
    const FilterScene scene = test::sceneOf(
        test::surfaceOf(mesh), test::storeOf(levels, [](FaceId, glm::dvec2, int) { return 0.F; }));
    QueryArrays queries;
    for (int k = 1; k < 90; ++k) {
        queries.add(faceId(0), {static_cast<float>(k) / 100, 0}, {0.1F, 0}, {0, 0.1F});
    }
    const auto point = makeMethod({"point", std::nullopt});
    for (const bool own : {true, false}) {
        std::vector<float> errors(queries.size());
        const Refusing refusing;
        filterDifferences(scene,
                          own ? static_cast<const FilterMethod&>(refusing) : *point,
                          own ? *point : static_cast<const FilterMethod&>(refusing),
                          2,
                          queries.queries(),
                          Threads{2},
                          errors);
        for (int k = 1; k < 90; ++k) {
            const float error = errors[static_cast<std::size_t>(k) - 1];
            if (k % 3 == 0) {
                EXPECT_TRUE(std::isnan(error)) << k;
            } else {
                EXPECT_EQ(error, 0.5F) << k;
            }
        }
    }
}

TEST(ViewMap, conditionIsOneForARoundFootprintAndInfiniteForALine)
{
    NoProgress progress;
    TriangleMesh mesh;
    const float height = std::sqrt(3.0F) / 2;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0.5F, height, 0}};
    mesh.triangles = {{0, 1, 2}};
    const auto surface = Surface::build(mesh, progress);
    ASSERT_TRUE(surface);
    // Across and along in the plane: v grows by 2/√3 for each unit of height, u falls by half.
    const glm::dvec2 across(-1 / std::sqrt(3.0), 2 / std::sqrt(3.0));
    QueryArrays queries;
    queries.add(faceId(0), {0.3F, 0.3F}, {0.01F, 0}, 0.01 * across);
    queries.add(faceId(0), {0.3F, 0.3F}, {0.01F, 0}, 0.08 * across);
    queries.add(faceId(0), {0.3F, 0.3F}, {0.01F, 0}, {0, 0});
    queries.add(faceId(0), {0.3F, 0.3F}, {0, 0}, {0, 0});
    std::vector<float> conditions(queries.size());
    footprintConditions(**surface, queries.queries(), Threads{1}, conditions);
    EXPECT_NEAR(conditions[0], 1, 1e-5);
    EXPECT_NEAR(conditions[1], 8, 1e-4);
    EXPECT_EQ(conditions[2], kInfinity);
    EXPECT_EQ(conditions[3], 1);
}

} // namespace
} // namespace trixel
