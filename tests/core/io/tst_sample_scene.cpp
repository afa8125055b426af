// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/new_project.h"
#include "core/io/sample_scene.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <iterator>
#include <set>

namespace trixel {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string fileText(const std::string& name)
{
    std::ifstream in(std::string(TRIXEL_SAMPLE) + "/" + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

const std::string& cage()
{
    static const std::string text = fileText("chameleon.obj");
    return text;
}
const std::string& strokes()
{
    static const std::string text = fileText("chameleon.strokes.json");
    return text;
}

Result<Project> built(Threads threads)
{
    NoProgress progress;
    return buildSampleScene(cage(), strokes(), progress, threads);
}

const Project& scene()
{
    static const Project project = built(Threads::all()).value();
    return project;
}

TEST(SampleScene, meshIsCleanAndClosed)
{
    const MeshReport& report = scene().surface->report();
    EXPECT_THAT(report.describe(), testing::IsEmpty());
    EXPECT_EQ(report.borderEdges, 0U);
}

TEST(SampleScene, hasThousandsOfFacesAndAboutAMillionTexels)
{
    EXPECT_GE(scene().surface->mesh().faceCount(), 5'000U);
    EXPECT_LE(scene().surface->mesh().faceCount(), 20'000U);
    EXPECT_GE(scene().texels.texelCount(), 500'000U);
    EXPECT_LE(scene().texels.texelCount(), 2'000'000U);
}

TEST(SampleScene, levelsDifferAndAreFinestAboutTheEyes)
{
    std::set<Level> levels;
    for (std::uint32_t f = 0; f < scene().texels.faceCount(); ++f) {
        levels.insert(scene().texels.face(faceId(f)).level());
    }
    EXPECT_GE(levels.size(), 4U);

    // Texels along an edge for a unit of length.
    const auto densityNear = [](glm::vec3 position) {
        const FaceId face = scene().surface->bvh().closestPoint(position, 1)->face;
        const auto c = scene().surface->mesh().corners(face);
        const float around =
            glm::distance(c[0], c[1]) + glm::distance(c[1], c[2]) + glm::distance(c[2], c[0]);
        return 3 * static_cast<float>(scene().texels.face(face).level().resolution()) / around;
    };
    const glm::vec3 flank(0.6F, 0.5F, -0.4F);
    for (const float side : {1.0F, -1.0F}) {
        EXPECT_GT(densityNear({side * 0.75F, 0.95F, 1.3F}), 1.8F * densityNear(flank));
    }
}

TEST(SampleScene, nearlyEveryTexelIsPainted)
{
    const std::vector<std::byte> fill = fillOf(scene());
    std::uint64_t painted = 0;
    for (std::uint32_t f = 0; f < scene().texels.faceCount(); ++f) {
        const FaceTexels& face = scene().texels.face(faceId(f));
        for (std::uint32_t i = 0; i < face.level().texelCount(); ++i) {
            painted += std::ranges::equal(face.texel(i), fill) ? 0U : 1U;
        }
    }
    EXPECT_GT(static_cast<double>(painted) / static_cast<double>(scene().texels.texelCount()), 0.9);
}

/// Colour of the chameleon at the surface point nearest to a position.
std::array<int, 3> colourNear(glm::vec3 position)
{
    const auto point = scene().surface->bvh().closestPoint(position, 1);
    const FaceTexels& face = scene().texels.face(point->face);
    const double r = face.level().resolution();
    const auto i = static_cast<std::size_t>(std::min(r - 1, std::floor(point->uv.x * r)));
    const auto j = static_cast<std::size_t>(std::min(r - 1, std::floor(point->uv.y * r)));
    const auto texel = face.texel(i + j * static_cast<std::size_t>(r));
    return {std::to_integer<int>(texel[0]),
            std::to_integer<int>(texel[1]),
            std::to_integer<int>(texel[2])};
}

TEST(SampleScene, bothEyesLookTheSame)
{
    const auto darkPupil = [](float side) {
        int dark = 0;
        for (float y = 0.8F; y < 1.1F; y += 0.01F) {
            for (float z = 1.1F; z < 1.5F; z += 0.01F) {
                const std::array<int, 3> c = colourNear({side * 0.8F, y, z});
                dark += c[0] + c[1] + c[2] < 120 ? 1 : 0;
            }
        }
        return dark;
    };
    const int left = darkPupil(1);
    const int right = darkPupil(-1);
    EXPECT_GT(left, 20);
    EXPECT_NEAR(left, right, 0.15 * left);
}

TEST(SampleScene, texelsDoNotDependOnTheNumberOfThreads)
{
    const Result<Project> alone = built(Threads{1});
    const Result<Project> three = built(Threads{3});
    ASSERT_TRUE(alone && three);
    for (std::uint32_t f = 0; f < alone->texels.faceCount(); ++f) {
        ASSERT_EQ(alone->texels.face(faceId(f)), three->texels.face(faceId(f))) << "face " << f;
        ASSERT_EQ(alone->texels.face(faceId(f)), scene().texels.face(faceId(f))) << "face " << f;
    }
}

TEST(SampleScene, damagedFilesAreRefusedByName)
{
    NoProgress progress;
    const auto noCage = buildSampleScene("v 0 0\n", strokes(), progress);
    ASSERT_FALSE(noCage);
    EXPECT_THAT(noCage.error().message, StartsWith("the sample scene's cage: "));

    const auto noStrokes = buildSampleScene(cage(), strokes().substr(0, 1000), progress);
    ASSERT_FALSE(noStrokes);
    EXPECT_THAT(noStrokes.error().message, StartsWith("the sample scene's strokes: "));
}

class StopAt final : public Progress
{
public:
    explicit StopAt(double fraction)
        : m_fraction(fraction)
    {
    }
    bool report(double fraction) override { return fraction < m_fraction; }

private:
    double m_fraction;
};

TEST(SampleScene, canBeCancelledWhilePainting)
{
    StopAt progress(0.5);
    const auto project = buildSampleScene(cage(), strokes(), progress);
    ASSERT_FALSE(project);
    EXPECT_EQ(project.error().kind, ErrorKind::Cancelled);
}

} // namespace
} // namespace trixel
