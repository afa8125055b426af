// SPDX-License-Identifier: GPL-3.0-or-later
//
// A .ptx whose faces are in another order, begun and wound otherwise, comes back to the bit.
#include "core/base/read_file.h"
#include "core/io/project_metadata.h"
#include "core/io/ptx_rematch.h"
#include "core/texture/rearranged_faces.h"
#include "tests/core/cancel_after.h"
#include "tests/core/io/ptx_samples.h"
#include "tests/core/mesh/cages.h"
#include "tests/core/mesh/shuffled_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <gmock/gmock.h>
#include <unistd.h>
#include <utility>

using namespace trixel;
using test::Shuffled;
using test::Winding;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace {

/// Bytes that tell where on the surface a texel lies, and nothing of how its face is numbered: of
/// each corner's vertex, wherever it comes in the face, and the steps towards it.
std::vector<std::byte>
texelsOf(const TriangleMesh& mesh, FaceId face, Level level, std::size_t bytes)
{
    std::vector<std::byte> texels(level.texelCount() * bytes);
    for (std::uint32_t k = 0; k < level.texelCount(); ++k) {
        const TexelCoord texel = texelAt(level, TexelIndex(k));
        const std::uint32_t sum = level.resolution() - (texel.half == TexelHalf::Lower ? 1 : 2);
        const std::array<std::uint32_t, 3> steps{sum - texel.i - texel.j, texel.i, texel.j};
        std::uint64_t hash = texel.half == TexelHalf::Lower ? 11 : 23;
        const auto corners = mesh.corners(face);
        for (std::size_t c = 0; c < 3; ++c) { // a sum: the order of corners does not count
            const glm::vec3 p = corners[c];
            const auto place =
                static_cast<std::uint64_t>(2e8F + p.x * 1e3F + p.y * 1e5F + p.z * 1e7F);
            hash += (place * 2654435761U + 7) * (steps[c] + 3) * (steps[c] + 31);
        }
        for (std::size_t b = 0; b < bytes; ++b) {
            // Half and float: never an exponent of all ones.
            texels[k * bytes + b] = static_cast<std::byte>(((hash >> (5 * b)) & 0x3FU) + 1);
        }
    }
    return texels;
}

/// Levels by what a face is, not by its number.
Level levelOf(const TriangleMesh& mesh, FaceId face)
{
    const auto corners = mesh.corners(face);
    const glm::vec3 middle = corners[0] + corners[1] + corners[2];
    return Level(static_cast<int>(900 + middle.x + 2 * middle.y + 30 * middle.z) % 7);
}

TexelStore painted(const TriangleMesh& mesh, const TexelFormat& format)
{
    const std::vector<std::byte> fill(format.texelBytes(), std::byte{5});
    TexelStore texels(static_cast<std::uint32_t>(mesh.faceCount()), format, Level(), fill);
    for (std::size_t k = 0; k < mesh.faceCount(); ++k) {
        const FaceId face = faceId(k);
        const Level level = levelOf(mesh, face);
        const auto bytes = texelsOf(mesh, face, level, format.texelBytes());
        texels.exchange(face, FaceTexels::full(level, format.texelBytes(), bytes).collapsed());
    }
    return texels;
}

class PtxRematch : public testing::Test
{
protected:
    PtxRematch() { fs::create_directories(m_folder); }
    ~PtxRematch() override { fs::remove_all(m_folder); }

    std::shared_ptr<const Surface> surfaceOf(const TriangleMesh& mesh)
    {
        return Surface::build(mesh, m_progress).value();
    }
    /// A .ptx of a mesh, with or without the mesh in it.
    void write(const TriangleMesh& mesh, const TexelFormat& format, bool carriesMesh)
    {
        PtxContents contents;
        contents.texels = painted(mesh, format);
        contents.adjacency = buildAdjacency(mesh.triangles);
        if (carriesMesh) {
            contents.metadata = metadataOf(mesh);
        }
        contents.metadata.push_back({"note", std::string("kept")});
        ASSERT_TRUE(writePtx(m_file, contents, {}, m_progress).has_value());
    }
    Result<MatchedPtx> open(const TriangleMesh& mesh)
    {
        return openPtxMatched(m_file, surfaceOf(mesh), m_progress, m_options);
    }
    static void expectSame(const TexelStore& texels, const TexelStore& wanted)
    {
        ASSERT_EQ(texels.faceCount(), wanted.faceCount());
        for (std::size_t k = 0; k < texels.faceCount(); ++k) {
            ASSERT_EQ(texels.face(faceId(k)), wanted.face(faceId(k))) << "face " << k;
        }
    }

    NoProgress m_progress;
    OpenOptions m_options;
    fs::path m_folder = fs::temp_directory_path() / ("trixel-match-" + std::to_string(::getpid()));
    fs::path m_file = m_folder / "other.ptx";
    TriangleMesh m_mesh = test::ragged();
};

TexelFormat formatOf(TexelType type, std::uint16_t channels)
{
    return {type, channels, {}};
}

} // namespace

TEST_F(PtxRematch, everyTexelOfEveryLevelFindsItsPlaceByPositions)
{
    unsigned seed = 0;
    for (const TexelType type :
         {TexelType::UInt8, TexelType::UInt16, TexelType::Half, TexelType::Float}) {
        for (const Winding winding : {Winding::Kept, Winding::AllTurnedOver, Winding::Random}) {
            const TexelFormat format = formatOf(type, 3);
            write(test::shuffled(m_mesh, ++seed, winding).mesh, format, true);
            const auto matched = open(m_mesh);
            ASSERT_TRUE(matched.has_value()) << matched.error().message;
            EXPECT_EQ(matched->match.by, MatchedBy::Positions);
            EXPECT_TRUE(matched->hasMips);
            expectSame(matched->project.texels, painted(m_mesh, format));
        }
    }
}

TEST_F(PtxRematch, withoutAMeshInTheFileByItsLinks)
{
    for (const Winding winding : {Winding::Kept, Winding::AllTurnedOver}) {
        const TexelFormat format = formatOf(TexelType::UInt16, 2);
        write(test::shuffled(m_mesh, 4, winding).mesh, format, false);
        const auto matched = open(m_mesh);
        ASSERT_TRUE(matched.has_value()) << matched.error().message;
        EXPECT_EQ(matched->match.by, MatchedBy::Neighbours);
        expectSame(matched->project.texels, painted(m_mesh, format));
    }
}

TEST_F(PtxRematch, facesReadOneByOneComeToTheSame)
{
    m_options.wholeBytes = 0;
    m_options.cacheBytes = 4096;
    const TexelFormat format = formatOf(TexelType::UInt8, 4);
    write(test::shuffled(m_mesh, 6, Winding::Random).mesh, format, true);
    const auto matched = open(m_mesh);
    ASSERT_TRUE(matched.has_value()) << matched.error().message;
    expectSame(matched->project.texels, painted(m_mesh, format));
}

TEST_F(PtxRematch, whatIsWrittenForTheMeshIsTheFileThatWasThere)
{
    const TexelFormat format = formatOf(TexelType::UInt8, 3);
    const fs::path original = m_folder / "original.ptx";
    Project project{surfaceOf(m_mesh), painted(m_mesh, format), {}, {}, {}};
    ASSERT_TRUE(exportPtx(original, project, {}, m_progress).has_value());
    const Shuffled other = test::shuffled(m_mesh, 8, Winding::Random);
    Project elsewhere{surfaceOf(other.mesh), painted(other.mesh, format), {}, {}, {}};
    ASSERT_TRUE(exportPtx(m_file, elsewhere, {}, m_progress).has_value());
    const auto matched = open(m_mesh);
    ASSERT_TRUE(matched.has_value()) << matched.error().message;
    const fs::path back = m_folder / "back.ptx";
    ASSERT_TRUE(exportPtx(back, matched->project, {}, m_progress).has_value());
    EXPECT_EQ(readFile(back).value(), readFile(original).value());
    EXPECT_NE(readFile(m_file).value(), readFile(original).value());
}

TEST_F(PtxRematch, aFileThatFitsIsTakenAsItStands)
{
    write(m_mesh, formatOf(TexelType::UInt8, 1), false);
    const auto matched = open(m_mesh);
    ASSERT_TRUE(matched.has_value()) << matched.error().message;
    EXPECT_EQ(matched->match.by, MatchedBy::Order);
    EXPECT_EQ(matched->match.moved(), 0U);
    EXPECT_THAT(matched->match.describe(), HasSubstr("as they stand"));
    EXPECT_THAT(matched->project.metadata, testing::SizeIs(1)); // the note
}

TEST_F(PtxRematch, aMeshMovedSinceIsMatchedByNeighbours)
{
    const Shuffled other = test::shuffled(m_mesh, 9, Winding::Kept);
    write(other.mesh, formatOf(TexelType::UInt8, 3), true);
    TriangleMesh bent = m_mesh;
    for (glm::vec3& position : bent.positions) {
        position = {position.x + position.y, position.y, position.z + 0.3F * position.x};
    }
    const auto matched = open(bent);
    ASSERT_TRUE(matched.has_value()) << matched.error().message;
    EXPECT_EQ(matched->match.by, MatchedBy::Neighbours);
    EXPECT_EQ(matched->match.faces, other.match);
    expectSame(matched->project.texels, painted(m_mesh, formatOf(TexelType::UInt8, 3)));
}

TEST_F(PtxRematch, itSaysWhatWasChanged)
{
    TriangleMesh other = m_mesh;
    std::swap(other.triangles[0], other.triangles[1]);
    std::ranges::rotate(other.triangles[5], other.triangles[5].begin() + 1);
    std::swap(other.triangles[7][0], other.triangles[7][1]);
    write(other, formatOf(TexelType::UInt8, 1), true);
    const auto matched = open(m_mesh);
    ASSERT_TRUE(matched.has_value()) << matched.error().message;
    EXPECT_EQ(matched->match.moved(), 2U);
    EXPECT_EQ(matched->match.turned(), 1U);
    EXPECT_EQ(matched->match.turnedOver(), 1U);
    EXPECT_EQ(matched->match.describe(),
              "by their positions: 2 of 68 faces have another number, 1 begin at another corner, "
              "1 are wound the other way round");
}

TEST_F(PtxRematch, whatFitsNowhereIsOneSentenceThatNamesTheFile)
{
    const auto sentence = [&](const TriangleMesh& mesh) {
        const auto matched = open(mesh);
        EXPECT_FALSE(matched.has_value());
        return matched ? std::string() : matched.error().message;
    };
    // Another mesh of as many faces.
    TriangleMesh other = test::gridMesh(6);
    other.triangles.resize(m_mesh.faceCount());
    write(other, formatOf(TexelType::UInt8, 1), false);
    EXPECT_THAT(sentence(m_mesh),
                testing::AllOf(testing::StartsWith(m_file.string() + ": "),
                               HasSubstr("does not fit the mesh in any order")));
    write(other, formatOf(TexelType::UInt8, 1), true);
    EXPECT_THAT(sentence(m_mesh), HasSubstr("no counterpart"));
    EXPECT_THAT(sentence(test::cube()), HasSubstr("is a texture of 68 faces, the mesh has 12"));
    // One that looks the same from many sides, its faces in another order.
    const TriangleMesh cube = test::cube();
    write(test::shuffled(cube, 2, Winding::Kept).mesh, formatOf(TexelType::UInt8, 1), false);
    EXPECT_THAT(sentence(cube), HasSubstr("several counterparts"));
    fs::resize_file(m_file, 40);
    EXPECT_THAT(sentence(cube), testing::StartsWith(m_file.string()));
    fs::remove(m_file);
    EXPECT_THAT(sentence(cube), testing::StartsWith(m_file.string()));
}

TEST_F(PtxRematch, matchingCanBeCancelled)
{
    write(test::shuffled(m_mesh, 1, Winding::Kept).mesh, formatOf(TexelType::UInt8, 1), true);
    for (int reports = 0; reports < 3; ++reports) {
        CancelAfter progress(reports);
        const auto matched = openPtxMatched(m_file, surfaceOf(m_mesh), progress, {});
        ASSERT_FALSE(matched.has_value());
        EXPECT_EQ(matched.error().kind, ErrorKind::Cancelled);
    }
}
