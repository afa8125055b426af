// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/new_project.h"
#include "core/io/project_metadata.h"
#include "core/io/ptx_metadata.h"
#include "core/study/views/project_views.h"

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <iterator>
#include <unistd.h>

namespace trixel {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

Project square()
{
    NoProgress progress;
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {3, 2, 1}};
    const LevelPlan plan = planUniform(2, Level(2));
    const std::vector<float> fill{0.5F, 0.5F, 0.5F};
    return newProject(std::move(mesh), plan, {}, fill, progress).value();
}

SceneViews threeViews()
{
    SceneViews views;
    views.cameras.push_back({"héros \"1\"", {1.0 / 3, -2e-17, 4e17}, {0, 1, 0}, {0, 1, 0}, 20.1});
    views.cameras.push_back({"side", {3, 0, 0}, {0, 0, 0}, {0, 1, 0}, 35, 640, 480});
    views.distant.push_back({"far", 12.5, 50, 320, 200});
    return views;
}

void putText(Project& project, PtxMetadata::Value value)
{
    putMetadata(project.metadata, {kViewsKey, std::move(value)});
}

std::string refusal(const Project& project)
{
    const auto views = viewsOf(project);
    return views ? std::string("was read") : views.error().message;
}

class ProjectViewsFile : public testing::Test
{
protected:
    ProjectViewsFile() { fs::create_directories(m_folder); }
    ~ProjectViewsFile() override { fs::remove_all(m_folder); }

    NoProgress m_progress;
    fs::path m_folder =
        fs::temp_directory_path() / ("trixel-project-views-" + std::to_string(::getpid()));
};

TEST(ProjectViews, aProjectWithoutAnyHasNone)
{
    const auto views = viewsOf(square());
    ASSERT_TRUE(views);
    EXPECT_TRUE(views->isEmpty());
}

TEST(ProjectViews, keptViewsComeBackToTheLastBit)
{
    Project project = square();
    keepViews(project, threeViews());
    EXPECT_EQ(viewsOf(project).value(), threeViews());
}

TEST(ProjectViews, noViewsLeaveNothingBehind)
{
    Project project = square();
    const std::vector<PtxMetadata> before = project.metadata;
    keepViews(project, threeViews());
    keepViews(project, {});
    EXPECT_EQ(project.metadata, before);
}

TEST(ProjectViews, asManyAsMayBeKeptAreReadBack)
{
    Project project = square();
    SceneViews views;
    // Names as long as the window allows, of characters that take the most bytes to write.
    views.cameras.resize(kMostProjectViews, {std::string(100, '\x01'), {1.0 / 3, 1e-300, 1}});
    keepViews(project, views);
    EXPECT_EQ(viewsOf(project).value(), views);
}

TEST(ProjectViews, whatCannotBeReadIsRefusedInOneSentence)
{
    Project project = square();
    putText(project, std::vector<std::int32_t>{1, 2});
    EXPECT_THAT(refusal(project), HasSubstr("TrixelViews: expected a text"));
    putText(project, std::string("{"));
    EXPECT_THAT(refusal(project), HasSubstr("TrixelViews: not JSON"));
    putText(project, std::string(R"({"version":2,"cameras":[]})"));
    EXPECT_THAT(refusal(project), HasSubstr("version"));
    putText(project,
            std::string(R"({"version":1,"cameras":[{"position":[0,0,0],"target":[0,0,0]}]})"));
    EXPECT_THAT(refusal(project), HasSubstr("target"));
    putText(project, std::string(std::size_t{3} << 20U, '['));
    EXPECT_THAT(refusal(project), HasSubstr("bytes"));
    putText(project, std::string(std::size_t{1} << 20U, '['));
    EXPECT_THAT(refusal(project), HasSubstr("not JSON"));
}

TEST(ProjectViews, moreThanMayBeKeptAreRefused)
{
    Project project = square();
    SceneViews views;
    views.distant.resize(kMostProjectViews + 1);
    putText(project, writeCameras(views));
    EXPECT_THAT(refusal(project), HasSubstr("at most 1000 views, found 1001"));
}

TEST_F(ProjectViewsFile, aSavedProjectBringsThemBack)
{
    Project project = square();
    keepViews(project, threeViews());
    const fs::path path = m_folder / "work.trixel";
    ASSERT_TRUE(saveProject(path, project, m_progress));
    const auto opened = openProject(path, m_progress);
    ASSERT_TRUE(opened) << opened.error().message;
    EXPECT_EQ(viewsOf(*opened).value(), threeViews());
}

TEST_F(ProjectViewsFile, anExportedTextureIsTheSameWithAndWithoutThem)
{
    Project project = square();
    const fs::path without = m_folder / "without.ptx";
    const fs::path with = m_folder / "with.ptx";
    ASSERT_TRUE(exportPtx(without, project, {}, m_progress));
    keepViews(project, threeViews());
    ASSERT_TRUE(exportPtx(with, project, {}, m_progress));
    const auto bytesOf = [](const fs::path& path) {
        std::ifstream file(path, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(file), {});
    };
    EXPECT_FALSE(bytesOf(without).empty());
    EXPECT_EQ(bytesOf(with), bytesOf(without));
}

} // namespace
} // namespace trixel
