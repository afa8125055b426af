// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/new_project.h"

#include <gmock/gmock.h>

namespace trixel {
namespace {

using testing::ElementsAre;

/// Two triangles of different size.
TriangleMesh twoFaces()
{
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 0}};
    mesh.triangles = {{0, 1, 2}, {2, 1, 3}};
    return mesh;
}

LevelPlan planOf(std::initializer_list<int> levels)
{
    LevelPlan plan;
    plan.levels = FaceMap<Level>(levels.size());
    std::size_t face = 0;
    for (const int log2 : levels) {
        plan.levels[faceId(face++)] = Level(log2);
    }
    return plan;
}

Result<Project> makeProject(const TexelFormat& format, const std::vector<float>& fill)
{
    NoProgress progress;
    return newProject(twoFaces(), planOf({2, 5}), format, fill, progress);
}

TEST(NewProject, givesEveryFaceItsLevelAndOneColour)
{
    const auto project = makeProject({TexelType::UInt8, 3, std::nullopt}, {0.0F, 0.5F, 1.0F});
    ASSERT_TRUE(project);
    const FaceTexels& small = project->texels.face(faceId(0));
    const FaceTexels& large = project->texels.face(faceId(1));
    EXPECT_EQ(small.level(), Level(2));
    EXPECT_EQ(large.level(), Level(5));
    EXPECT_TRUE(small.isConstant() && large.isConstant());
    EXPECT_THAT(large.bytes(), ElementsAre(std::byte{0}, std::byte{128}, std::byte{255}));
    EXPECT_EQ(project->surface->mesh().faceCount(), 2U);
}

TEST(NewProject, remembersItsFillWhenEveryFaceIsPaintedOver)
{
    auto project = makeProject({TexelType::UInt16, 2, std::nullopt}, {0.25F, 0.75F});
    ASSERT_TRUE(project);
    const std::vector<std::byte> fill = fillOf(*project);
    for (std::size_t face = 0; face < 2; ++face) {
        std::ranges::fill(project->texels.writable(faceId(face)), std::byte{7});
    }
    EXPECT_EQ(fillOf(*project), fill);
}

TEST(FillOf, isTheFirstConstantFaceWhereNothingIsRecorded)
{
    auto project = makeProject({TexelType::UInt8, 1, std::nullopt}, {0.2F});
    ASSERT_TRUE(project);
    project->metadata.clear();
    std::ranges::fill(project->texels.writable(faceId(0)), std::byte{7});
    EXPECT_THAT(fillOf(*project), ElementsAre(std::byte{51}));
    std::ranges::fill(project->texels.writable(faceId(1)), std::byte{7});
    EXPECT_THAT(fillOf(*project), ElementsAre(std::byte{255})) << "nothing left to tell";
}

TEST(FillOf, ignoresARecordThatDoesNotFitTheChannels)
{
    auto project = makeProject({TexelType::UInt8, 1, std::nullopt}, {0.2F});
    ASSERT_TRUE(project);
    project->metadata.front().value = std::vector<float>{1, 1, 1};
    EXPECT_THAT(fillOf(*project), ElementsAre(std::byte{51}));
    project->metadata.front().value = std::string("red");
    EXPECT_THAT(fillOf(*project), ElementsAre(std::byte{51}));
}

} // namespace
} // namespace trixel
