// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/new_project.h"
#include "core/io/project.h"
#include "core/io/project_metadata.h"
#include "core/io/ptx_metadata.h"
#include "core/io/ptx_summary.h"
#include "tests/core/io/ptx_samples.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <gmock/gmock.h>
#include <limits>
#include <unistd.h>

using namespace trixel;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace {

const TexelFormat kFormat; // uint8 RGB

// A grid of squares, each cut into two triangles.
TriangleMesh grid(std::uint32_t side)
{
    TriangleMesh mesh;
    for (std::uint32_t y = 0; y <= side; ++y) {
        for (std::uint32_t x = 0; x <= side; ++x) {
            mesh.positions.push_back({x, y, x * y % 3});
        }
    }
    for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < side; ++x) {
            const std::uint32_t corner = y * (side + 1) + x;
            mesh.triangles.push_back({corner, corner + 1, corner + side + 1});
            mesh.triangles.push_back({corner + 1, corner + side + 2, corner + side + 1});
            mesh.sourceFaces.insert(mesh.sourceFaces.end(), 2, y * side + x);
        }
    }
    return mesh;
}

class ProjectFile : public testing::Test
{
protected:
    ProjectFile()
    {
        fs::create_directories(m_folder);
        m_project.surface = Surface::build(grid(4), m_progress).value();
        std::vector<int> levels;
        for (std::size_t k = 0; k < m_project.surface->mesh().faceCount(); ++k) {
            levels.push_back(static_cast<int>(k % 5));
        }
        m_project.texels = samples::mixed(kFormat, levels).texels;
        m_project.metadata = {{"TrixelFill", std::vector<float>{0.5F, 0.25F, 1.0F}},
                              {"note", std::string("kept")}};
    }
    ~ProjectFile() override { fs::remove_all(m_folder); }

    static void expectSameMesh(const TriangleMesh& a, const TriangleMesh& b)
    {
        EXPECT_EQ(a.positions, b.positions);
        EXPECT_EQ(a.triangles, b.triangles);
    }
    void expectSameTexels(const Project& project) const
    {
        ASSERT_EQ(project.texels.faceCount(), m_project.texels.faceCount());
        for (std::uint32_t k = 0; k < project.texels.faceCount(); ++k) {
            EXPECT_EQ(project.texels.face(faceId(k)), m_project.texels.face(faceId(k)));
        }
    }
    // The project's .ptx with other metadata than its own.
    void writeWith(const std::vector<PtxMetadata>& metadata)
    {
        const PtxContents contents{
            m_project.texels, m_project.surface->adjacency(), metadata, true};
        ASSERT_TRUE(writePtx(m_ptx, contents, {}, m_progress).has_value());
    }
    std::string refusal()
    {
        const auto opened = openPtx(m_ptx, m_progress);
        return opened ? std::string("was opened") : opened.error().message;
    }

    NoProgress m_progress;
    fs::path m_folder =
        fs::temp_directory_path() / ("trixel-project-" + std::to_string(::getpid()));
    fs::path m_path = m_folder / "work.trixel";
    fs::path m_ptx = m_folder / "texture.ptx";
    Project m_project;
};

} // namespace

TEST_F(ProjectFile, everythingOfAProjectRoundTrips)
{
    ASSERT_TRUE(saveProject(m_path, m_project, m_progress).has_value());
    const auto opened = openProject(m_path, m_progress);
    ASSERT_TRUE(opened.has_value()) << opened.error().message;
    expectSameTexels(*opened);
    expectSameMesh(opened->surface->mesh(), m_project.surface->mesh());
    EXPECT_EQ(opened->surface->mesh().sourceFaces, m_project.surface->mesh().sourceFaces);
    EXPECT_EQ(opened->surface->adjacency(), m_project.surface->adjacency());
    EXPECT_THAT(opened->metadata, testing::UnorderedElementsAreArray(m_project.metadata));
    EXPECT_EQ(fillOf(*opened), fillOf(m_project));
}

TEST_F(ProjectFile, creasesAndTheirAngleComeBack)
{
    TriangleMesh mesh = grid(4);
    mesh.sharpness = {{{0, 1, 2.5F}, {6, 7, kSharp}}, {{12, 0.125F}}};
    m_project.surface = Surface::build(mesh, m_progress).value();
    m_project.creaseAngle = 33.5F;
    ASSERT_TRUE(saveProject(m_path, m_project, m_progress).has_value());
    ASSERT_TRUE(exportPtx(m_ptx, m_project, {}, m_progress).has_value());
    for (const auto& opened : {openProject(m_path, m_progress), openPtx(m_ptx, m_progress)}) {
        ASSERT_TRUE(opened.has_value()) << opened.error().message;
        EXPECT_EQ(opened->surface->mesh().sharpness, mesh.sharpness);
        EXPECT_EQ(opened->creaseAngle, m_project.creaseAngle);
        EXPECT_THAT(opened->metadata, testing::UnorderedElementsAreArray(m_project.metadata));
    }
}

TEST_F(ProjectFile, projectsOfBeforeHaveNoCreases)
{
    ASSERT_TRUE(saveProject(m_path, m_project, m_progress).has_value());
    const auto opened = openProject(m_path, m_progress);
    ASSERT_TRUE(opened.has_value());
    EXPECT_TRUE(opened->surface->mesh().sharpness.isEmpty());
    EXPECT_FALSE(opened->creaseAngle);
    const auto summary = summarisePtx(m_path);
    ASSERT_TRUE(summary.has_value());
    for (const PtxMetadata& item : metadataOf(m_project.surface->mesh())) {
        EXPECT_THAT(item.key, testing::Not(HasSubstr("Crease")));
    }
}

TEST_F(ProjectFile, damagedCreasesAreRefusedByName)
{
    const auto refusalWith = [&](std::vector<PtxMetadata> more) {
        std::vector<PtxMetadata> items = metadataOf(m_project.surface->mesh());
        items.insert(items.end(), more.begin(), more.end());
        writeWith(items);
        return refusal();
    };
    using Ints = std::vector<std::int32_t>;
    using Floats = std::vector<float>;
    const PtxMetadata edge{kCreasesKey, Ints{0, 1}};
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(refusalWith({edge, {kCreaseSharpnessKey, Floats{1}}}), "was opened");
    EXPECT_THAT(refusalWith({edge}), HasSubstr("TrixelCreaseSharpness has 0 values, expected 1"));
    EXPECT_THAT(refusalWith({{kCreasesKey, Ints{0, 1, 2}}, {kCreaseSharpnessKey, Floats{1}}}),
                HasSubstr("TrixelCreases has 3 values, not two a crease"));
    EXPECT_THAT(refusalWith({{kCreasesKey, Ints{0, 25}}, {kCreaseSharpnessKey, Floats{1}}}),
                HasSubstr("TrixelCreases names vertex 25, but there are 25"));
    EXPECT_THAT(refusalWith({{kCreasesKey, Ints{-1, 2}}, {kCreaseSharpnessKey, Floats{1}}}),
                HasSubstr("names vertex -1"));
    EXPECT_THAT(refusalWith({{kCreasesKey, Ints{0, 2}}, {kCreaseSharpnessKey, Floats{1}}}),
                HasSubstr("TrixelCreases has crease 0 between vertices 0 and 2, which share no"));
    for (const float bad : {0.0F, -1.0F, 11.0F, nan}) {
        EXPECT_THAT(refusalWith({edge, {kCreaseSharpnessKey, Floats{bad}}}),
                    HasSubstr("TrixelCreaseSharpness has"));
    }
    EXPECT_THAT(refusalWith({{kCreasesKey, std::string("0 1")}}),
                HasSubstr("TrixelCreases is not"));
    EXPECT_THAT(refusalWith({{kSharpVerticesKey, Ints{3, 4}}, {kVertexSharpnessKey, Floats{1}}}),
                HasSubstr("TrixelVertexSharpness has 1 values, expected 2"));
    EXPECT_THAT(refusalWith({{kSharpVerticesKey, Ints{99}}, {kVertexSharpnessKey, Floats{1}}}),
                HasSubstr("TrixelSharpVertices names vertex 99"));
    for (const float bad : {-0.5F, 181.0F, nan}) {
        EXPECT_THAT(refusalWith({{kCreaseAngleKey, Floats{bad}}}),
                    HasSubstr("TrixelCreaseAngle is"));
    }
    EXPECT_THAT(refusalWith({{kCreaseAngleKey, Floats{1, 2}}}),
                HasSubstr("TrixelCreaseAngle has 2 values, expected one"));
}

TEST_F(ProjectFile, uvsOfTheMeshRoundTrip)
{
    TriangleMesh mesh = grid(4);
    for (std::size_t k = 0; k < 3 * mesh.faceCount(); ++k) {
        mesh.cornerUvs.emplace_back(static_cast<float>(k) / 7, 1 - static_cast<float>(k));
    }
    m_project.surface = Surface::build(mesh, m_progress).value();
    ASSERT_TRUE(saveProject(m_path, m_project, m_progress).has_value());
    auto opened = openProject(m_path, m_progress);
    ASSERT_TRUE(opened.has_value()) << opened.error().message;
    EXPECT_EQ(opened->surface->mesh().cornerUvs, mesh.cornerUvs);
    ASSERT_TRUE(exportPtx(m_ptx, *opened, {}, m_progress).has_value());
    opened = openPtx(m_ptx, m_progress);
    ASSERT_TRUE(opened.has_value()) << opened.error().message;
    EXPECT_EQ(opened->surface->mesh().cornerUvs, mesh.cornerUvs);
}

TEST_F(ProjectFile, savingTwiceGivesTheSameFile)
{
    ASSERT_TRUE(saveProject(m_path, m_project, m_progress).has_value());
    const auto opened = openProject(m_path, m_progress);
    ASSERT_TRUE(opened.has_value());
    ASSERT_TRUE(saveProject(m_path, *opened, m_progress).has_value());
    const auto again = openProject(m_path, m_progress);
    ASSERT_TRUE(again.has_value());
    expectSameTexels(*again);
    EXPECT_EQ(again->metadata, opened->metadata);
}

TEST_F(ProjectFile, aNewerVersionIsRefused)
{
    std::vector<PtxMetadata> items = metadataOf(m_project.surface->mesh());
    items.push_back({kProjectVersionKey, std::vector<std::int32_t>{kProjectVersion + 1}});
    writeWith(items);
    const auto opened = openProject(m_ptx, m_progress);
    ASSERT_FALSE(opened.has_value());
    EXPECT_EQ(opened.error().kind, ErrorKind::Contents);
    EXPECT_THAT(opened.error().message, HasSubstr("version 3"));
}

TEST_F(ProjectFile, aTextureIsNoProject)
{
    ASSERT_TRUE(exportPtx(m_ptx, m_project, {}, m_progress).has_value());
    const auto opened = openProject(m_ptx, m_progress);
    ASSERT_FALSE(opened.has_value());
    EXPECT_THAT(opened.error().message, HasSubstr("not a Trixel project"));
}

TEST_F(ProjectFile, anExportedTextureOpensWithItsMesh)
{
    ASSERT_TRUE(exportPtx(m_ptx, m_project, {}, m_progress).has_value());
    const auto opened = openPtx(m_ptx, m_progress);
    ASSERT_TRUE(opened.has_value()) << opened.error().message;
    expectSameTexels(*opened);
    expectSameMesh(opened->surface->mesh(), m_project.surface->mesh());
    const auto summary = summarisePtx(m_ptx);
    ASSERT_TRUE(summary.has_value());
    EXPECT_TRUE(summary->carriesMesh);
    EXPECT_FALSE(summary->isProject);
    EXPECT_EQ(summary->faceCount, 32U);
    EXPECT_EQ(summary->levelCount, 3);
    EXPECT_EQ(summary->facesOfLevel[4], 6U);
    EXPECT_EQ(summary->texelCount, m_project.texels.texelCount());
}

TEST_F(ProjectFile, aTextureWithoutMeshAsksForIt)
{
    writeWith({});
    const auto opened = openPtx(m_ptx, m_progress);
    ASSERT_FALSE(opened.has_value());
    EXPECT_EQ(opened.error().kind, ErrorKind::Contents);
    EXPECT_THAT(opened.error().message, HasSubstr("together with the mesh"));
}

TEST_F(ProjectFile, damagedMeshMetadataAreRefusedByName)
{
    const std::vector<PtxMetadata> good = metadataOf(m_project.surface->mesh());
    const auto changed = [&](const char* key, auto change) {
        std::vector<PtxMetadata> items = good;
        for (PtxMetadata& item : items) {
            if (item.key == key) {
                change(item);
            }
        }
        writeWith(items);
        return refusal();
    };
    using Ints = std::vector<std::int32_t>;
    using Floats = std::vector<float>;
    EXPECT_THAT(changed(kVertexCountsKey, [](auto& i) { std::get<Ints>(i.value)[5] = 4; }),
                HasSubstr("face 5 4 corners"));
    EXPECT_THAT(changed(kVertexCountsKey, [](auto& i) { std::get<Ints>(i.value).pop_back(); }),
                HasSubstr("31 faces"));
    EXPECT_THAT(changed(kVertexIndicesKey, [](auto& i) { std::get<Ints>(i.value)[7] = 25; }),
                HasSubstr("vertex 25"));
    EXPECT_THAT(changed(kVertexIndicesKey, [](auto& i) { std::get<Ints>(i.value)[7] = -1; }),
                HasSubstr("vertex -1"));
    EXPECT_THAT(changed(kVertexIndicesKey, [](auto& i) { std::get<Ints>(i.value).push_back(0); }),
                HasSubstr("97 values"));
    EXPECT_THAT(changed(kVertexPositionsKey,
                        [](auto& i) {
                            std::get<Floats>(i.value)[4] = std::numeric_limits<float>::quiet_NaN();
                        }),
                HasSubstr("vertex 1"));
    EXPECT_THAT(changed(kVertexPositionsKey, [](auto& i) { i.value = std::string("x"); }),
                HasSubstr("does not carry its mesh"));
}

TEST_F(ProjectFile, aTextureOpensOnTheMeshItWasMadeFor)
{
    writeWith({});
    const auto opened = openPtxOnMesh(m_ptx, grid(4), m_progress);
    ASSERT_TRUE(opened.has_value()) << opened.error().message;
    expectSameTexels(*opened);
}

TEST_F(ProjectFile, aMeshOfAnotherFaceCountIsRefused)
{
    writeWith({});
    const auto opened = openPtxOnMesh(m_ptx, grid(5), m_progress);
    ASSERT_FALSE(opened.has_value());
    EXPECT_THAT(opened.error().message, HasSubstr("32 faces, the mesh has 50"));
}

TEST_F(ProjectFile, aMeshOfFlippedWindingIsRefused)
{
    writeWith({});
    TriangleMesh flipped = grid(4);
    for (Triangle& triangle : flipped.triangles) {
        std::swap(triangle[1], triangle[2]);
    }
    const auto opened = openPtxOnMesh(m_ptx, flipped, m_progress);
    ASSERT_FALSE(opened.has_value());
    EXPECT_THAT(opened.error().message, HasSubstr("does not fit the mesh"));
    EXPECT_THAT(opened.error().message, HasSubstr("wind"));
}

TEST_F(ProjectFile, aMeshInAnotherOrderIsRefusedNamingTheFirstFace)
{
    writeWith({});
    TriangleMesh other = grid(4);
    std::swap(other.triangles[9], other.triangles[20]);
    const auto opened = openPtxOnMesh(m_ptx, other, m_progress);
    ASSERT_FALSE(opened.has_value());
    EXPECT_THAT(opened.error().message, HasSubstr("order"));
    EXPECT_THAT(opened.error().message, HasSubstr("face "));
}

TEST_F(ProjectFile, aFaceThatStartsAtAnotherCornerIsRefused)
{
    writeWith({});
    TriangleMesh other = grid(4);
    std::ranges::rotate(other.triangles[11], other.triangles[11].begin() + 1);
    const auto opened = openPtxOnMesh(m_ptx, other, m_progress);
    ASSERT_FALSE(opened.has_value());
    EXPECT_THAT(opened.error().message, HasSubstr("corner"));
}
