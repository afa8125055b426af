// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checking, comparing and converting .ptx files.
#include "core/base/read_file.h"
#include "core/io/ptx_check.h"
#include "core/io/ptx_convert.h"
#include "core/io/ptx_diff.h"
#include "tests/core/io/ptx_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <unistd.h>

using namespace trixel;
using testing::HasSubstr;
using testing::IsEmpty;
namespace fs = std::filesystem;

namespace {

const fs::path kGolden = fs::path(TRIXEL_TEST_DATA) / "ptx";
constexpr int kLevels[] = {4, 3, 5, 2, 0, 1, 6, 3, 9, 4};

class PtxTools : public testing::Test
{
protected:
    PtxTools() { fs::create_directories(m_folder); }
    ~PtxTools() override { fs::remove_all(m_folder); }

    void write(const fs::path& path, const PtxContents& contents, bool mips = true)
    {
        const Status status = writePtx(path, contents, {.mips = mips}, m_progress);
        ASSERT_TRUE(status.has_value()) << status.error().message;
    }
    std::vector<std::string> faults(const fs::path& path, const PtxCheckOptions& options = {})
    {
        const auto found = checkPtx(path, options, m_progress);
        EXPECT_TRUE(found.has_value()) << found.error().message;
        return found.value_or(std::vector<std::string>{});
    }
    PtxDiff diff()
    {
        const auto found = diffPtx(m_a, m_b, m_progress);
        EXPECT_TRUE(found.has_value()) << found.error().message;
        return found.value_or(PtxDiff{});
    }

    NoProgress m_progress;
    fs::path m_folder = fs::temp_directory_path() / ("trixel-tools-" + std::to_string(::getpid()));
    fs::path m_a = m_folder / "a.ptx";
    fs::path m_b = m_folder / "b.ptx";
};

TexelFormat formatOf(TexelType type, int channels, std::optional<std::uint16_t> alpha = {})
{
    return {.type = type, .channels = static_cast<std::uint16_t>(channels), .alpha = alpha};
}

} // namespace

TEST_F(PtxTools, filesOfOurOwnHaveNoFaults)
{
    for (const TexelType type :
         {TexelType::UInt8, TexelType::UInt16, TexelType::Half, TexelType::Float}) {
        for (const bool alpha : {false, true}) {
            const auto channel = alpha ? std::optional<std::uint16_t>(3) : std::nullopt;
            write(m_a, samples::mixed(formatOf(type, 4, channel), kLevels));
            EXPECT_THAT(faults(m_a), IsEmpty()) << nameOf(type) << alpha;
        }
    }
}

TEST_F(PtxTools, filesOfTheReferenceLibraryHaveNoFaultsButTheFaceNobodyWrote)
{
    for (const auto& entry : fs::directory_iterator(kGolden)) {
        if (entry.path().extension() == ".ptx") {
            SCOPED_TRACE(entry.path().filename().string());
            EXPECT_THAT(faults(entry.path()),
                        testing::ElementsAre(HasSubstr("face 8 names edge 2 of face 11"),
                                             HasSubstr("of face 11"),
                                             HasSubstr("of face 11")));
        }
    }
}

TEST_F(PtxTools, damagedBlocksAreNamed)
{
    write(m_a, samples::mixed(formatOf(TexelType::UInt8, 3), std::vector{5, 5, 5}));
    std::string bytes = readFile(m_a).value();
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 0x10);
    std::ofstream(m_a, std::ios::binary) << bytes;
    EXPECT_THAT(faults(m_a), testing::Contains(HasSubstr("does not unzip")));
}

TEST_F(PtxTools, ofManyFaultsTheFirstAreListedAndTheRestCounted)
{
    // Every link of the strip leads to a face that was overwritten by one without links.
    PtxContents contents = samples::mixed(formatOf(TexelType::UInt8, 1), std::vector<int>(40, 2));
    write(m_a, contents);
    TriangleMesh mesh;
    for (std::uint32_t k = 0; k < 40; ++k) {
        mesh.positions.insert(mesh.positions.end(), 3, {k, 0, 0});
        mesh.triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
    }
    const auto found = faults(m_a, {.mesh = &mesh, .maxFaultsOfAKind = 5});
    ASSERT_EQ(found.size(), 6U);
    EXPECT_THAT(found[0], HasSubstr("face 0 "));
    EXPECT_THAT(found[5], HasSubstr("35 more"));
}

TEST_F(PtxTools, whatCannotBeOpenedIsAnErrorNotAListOfFaults)
{
    std::ofstream(m_a) << "Ptex";
    EXPECT_EQ(checkPtx(m_a, {}, m_progress).error().kind, ErrorKind::Contents);
    EXPECT_EQ(checkPtx(m_folder / "none", {}, m_progress).error().kind, ErrorKind::Path);
}

TEST_F(PtxTools, equalFilesDoNotDiffer)
{
    const PtxContents contents = samples::mixed(formatOf(TexelType::Half, 3), kLevels);
    write(m_a, contents);
    write(m_b, contents);
    EXPECT_TRUE(diff().isEqual());
}

TEST_F(PtxTools, differencesAreMeasuredFaceByFace)
{
    PtxContents contents = samples::mixed(formatOf(TexelType::UInt8, 2), std::vector{2, 2, 3});
    write(m_a, contents);
    const std::span<std::byte> texels = contents.texels.writable(faceId(1));
    texels[6] ^= std::byte{255}; // one channel of one of 16 texels
    contents.texels.exchange(faceId(2), FaceTexels::constant(Level(1), texels.first(2)));
    write(m_b, contents);
    const PtxDiff found = diff();
    EXPECT_FALSE(found.isEqual());
    ASSERT_EQ(found.faces.size(), 2U);
    EXPECT_EQ(found.faces[0].face, faceId(1));
    EXPECT_EQ(found.faces[0].texels, 1U);
    EXPECT_NEAR(found.faces[0].rms, found.faces[0].maxAbs / std::sqrt(32.0), 1e-12);
    EXPECT_EQ(found.faces[1].levelOfA, Level(3));
    EXPECT_EQ(found.faces[1].levelOfB, Level(1));
    EXPECT_EQ(found.levelDifferences, 1U);
    EXPECT_NEAR(found.rms, found.maxAbs / std::sqrt(64.0), 1e-12);
}

TEST_F(PtxTools, notesNameWhatIsNotTexels)
{
    PtxContents contents = samples::mixed(formatOf(TexelType::UInt8, 3), std::vector{3, 3});
    contents.metadata = {{"both", std::string("a")}, {"first", std::string("a")}};
    write(m_a, contents);
    contents.metadata = {{"both", std::string("b")}, {"second", std::string("a")}};
    contents.adjacency = Adjacency(2);
    write(m_b, contents, false);
    EXPECT_THAT(diff().notes,
                testing::ElementsAre(HasSubstr("levels"),
                                     HasSubstr("2 faces have other neighbours"),
                                     HasSubstr("\"both\" differ"),
                                     HasSubstr("only the first has the metadata \"first\""),
                                     HasSubstr("only the second has the metadata \"second\"")));
    EXPECT_THAT(diff().faces, IsEmpty());
}

TEST_F(PtxTools, texturesOfOtherShapeAreNotCompared)
{
    write(m_a, samples::mixed(formatOf(TexelType::UInt8, 3), std::vector{3, 3}));
    write(m_b, samples::mixed(formatOf(TexelType::UInt8, 3), std::vector{3}));
    EXPECT_THAT(diff().incomparable, HasSubstr("2 faces"));
    write(m_b, samples::mixed(formatOf(TexelType::UInt8, 2), std::vector{3, 3}));
    EXPECT_THAT(diff().incomparable, HasSubstr("3 channels"));
}

TEST_F(PtxTools, convertingWidensWithoutLossAndComesBack)
{
    const PtxContents contents = samples::mixed(formatOf(TexelType::UInt8, 3), kLevels);
    write(m_a, contents);
    ASSERT_TRUE(convertPtx(m_a, m_b, {.type = TexelType::Float}, m_progress).has_value());
    PtxDiff found = diff();
    EXPECT_THAT(found.notes, testing::ElementsAre(HasSubstr("uint8")));
    EXPECT_THAT(found.faces, IsEmpty());
    ASSERT_TRUE(convertPtx(m_b, m_b, {.type = TexelType::UInt8}, m_progress).has_value());
    EXPECT_TRUE(diff().isEqual());
    EXPECT_EQ(readFile(m_a).value(), readFile(m_b).value());
}

TEST_F(PtxTools, convertingFoldsInEditsAndCanDropReductions)
{
    ASSERT_TRUE(convertPtx(kGolden / "fmt_1_3.ptx", m_b, {.type = {}, .mips = false}, m_progress)
                    .has_value());
    fs::copy_file(kGolden / "fmt_1_3.ptx", m_a);
    const PtxDiff found = diff();
    EXPECT_THAT(found.faces, IsEmpty());
    const auto contents = readPtx(m_b, m_progress);
    ASSERT_TRUE(contents.has_value());
    EXPECT_FALSE(contents->hasMips);
    EXPECT_EQ(contents->metadata.size(), 4U);
}
