// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces that are read from a .ptx when they are asked for: the same texels as those read at once,
// and damage that is met late is told, shown, and never written out.
#include "core/base/read_file.h"
#include "core/io/deflate.h"
#include "core/io/project.h"
#include "core/io/ptx_reader.h"
#include "core/texture/convert.h"
#include "core/texture/face_figures.h"
#include "core/texture/float_mips.h"
#include "core/texture/level_change.h"
#include "core/texture/texel_patch.h"
#include "core/texture/texel_search.h"
#include "core/texture/value_histogram.h"
#include "tests/core/io/ptx_samples.h"

#include <gtest/gtest.h>

#include <atomic>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

using namespace trixel;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace {

constexpr OpenOptions kOnDemand{.wholeBytes = 0};
constexpr OpenOptions kAtOnce{.wholeBytes = ~std::uint64_t{0}};

std::string bytesOfFile(const fs::path& path)
{
    return readFile(path).value();
}

std::vector<fs::path> goldenFiles()
{
    std::vector<fs::path> files;
    for (const char* folder : {"ptx", "ptx-small"}) {
        for (const auto& entry : fs::directory_iterator(fs::path(TRIXEL_TEST_DATA) / folder)) {
            if (entry.path().extension() == ".ptx") {
                files.push_back(entry.path());
            }
        }
    }
    return files;
}

void write(const fs::path& path, std::uint64_t offset, std::string_view bytes)
{
    std::fstream out(path, std::ios::in | std::ios::out | std::ios::binary);
    out.seekp(static_cast<std::streamoff>(offset));
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    ASSERT_TRUE(out.good());
}

class PtxStoredFaces : public testing::Test
{
protected:
    PtxStoredFaces() { fs::create_directories(m_folder); }
    ~PtxStoredFaces() override { fs::remove_all(m_folder); }

    OpenedTexels onDemand(const fs::path& path, const OpenOptions& options = kOnDemand)
    {
        return openPtxTexels(path, m_progress, options).value();
    }

    // A strip of triangles of level 5, every fourth constant.
    Project stripProject(std::uint32_t faces)
    {
        TriangleMesh mesh;
        for (std::uint32_t k = 0; k < faces + 2; ++k) {
            mesh.positions.push_back({static_cast<float>(k / 2), static_cast<float>(k % 2), 0});
        }
        for (std::uint32_t k = 0; k < faces; ++k) {
            if (k % 2 == 0) {
                mesh.triangles.push_back({k, k + 2, k + 1});
            } else {
                mesh.triangles.push_back({k, k + 1, k + 2});
            }
        }
        mesh.sourceFaces.resize(faces);
        Project project;
        project.surface = Surface::build(std::move(mesh), m_progress).value();
        project.texels = samples::mixed({}, std::vector<int>(faces, 5)).texels;
        return project;
    }

    static void expectSame(const TexelStore& stored, const TexelStore& eager)
    {
        ASSERT_EQ(stored.faceCount(), eager.faceCount());
        ASSERT_EQ(stored.format(), eager.format());
        for (std::uint32_t k = 0; k < eager.faceCount(); ++k) {
            EXPECT_EQ(stored.face(faceId(k)).level(), eager.face(faceId(k)).level()) << k;
            EXPECT_EQ(stored.face(faceId(k)), eager.face(faceId(k))) << k;
        }
    }

    // Mean and coarser levels against what reading single levels gives.
    static void expectStoredLevels(const fs::path& path, const TexelStore& stored)
    {
        MemoryBudget budget;
        const PtxFile file = openPtxFile(path, budget).value();
        PtxDecoder decoder;
        for (std::uint32_t k = 0; k < file.faceCount(); ++k) {
            const FaceTexels& face = stored.face(faceId(k));
            const auto mean = face.mean();
            ASSERT_TRUE(mean);
            EXPECT_TRUE(std::ranges::equal(*mean, file.constantValue(faceId(k))));
            for (int reduction = 1; reduction <= face.level().log2(); ++reduction) {
                const Level level = face.level().coarser(reduction);
                const auto expected = file.texels(faceId(k), reduction, decoder).value();
                EXPECT_EQ(face.hasStoredLevel(level), expected.has_value());
                EXPECT_EQ(face.storedLevel(level), expected);
            }
            EXPECT_EQ(face.isLoaded(), !face.isStored());
        }
    }

    static PtxBlock blockOf(const fs::path& path, FaceId face, int reduction)
    {
        MemoryBudget budget;
        return openPtxFile(path, budget)->block(face, reduction).value();
    }

    NoProgress m_progress;
    fs::path m_folder = fs::temp_directory_path() / ("trixel-stored-" + std::to_string(::getpid()));
    fs::path m_ptx = m_folder / "texture.ptx";
    fs::path m_target = m_folder / "target.ptx";
};

} // namespace

TEST_F(PtxStoredFaces, areThoseThatReadingAllAtOnceGives)
{
    const std::vector<fs::path> files = goldenFiles();
    ASSERT_EQ(files.size(), 14U);
    for (const fs::path& path : files) {
        SCOPED_TRACE(path.filename());
        const auto opened = onDemand(path);
        ASSERT_TRUE(opened.faces);
        if (!opened.texels.format().alpha) {
            expectStoredLevels(path, opened.texels);
        }
        expectSame(opened.texels, readPtx(path, m_progress)->texels);
        EXPECT_EQ(opened.faces->faultCount(), 0U);
    }
}

TEST_F(PtxStoredFaces, areThoseOfAnyTypeAndLevel)
{
    const std::vector levels{0, 1, 2, 0, 3, 4, 5, 2, 6, 7, 1};
    for (const TexelType type :
         {TexelType::UInt8, TexelType::UInt16, TexelType::Half, TexelType::Float}) {
        for (const bool mips : {true, false}) {
            for (const std::uint16_t channels : std::initializer_list<std::uint16_t>{1, 3, 4}) {
                TexelFormat format{type, channels, {}};
                if (channels == 4 && mips) {
                    format.alpha = std::uint16_t{3};
                }
                const PtxContents contents = samples::mixed(format, levels);
                ASSERT_TRUE(writePtx(m_ptx, contents, {.mips = mips}, m_progress));
                expectSame(onDemand(m_ptx).texels, contents.texels);
                if (!format.alpha) {
                    expectStoredLevels(m_ptx, onDemand(m_ptx).texels);
                }
            }
        }
    }
}

TEST_F(PtxStoredFaces, giveReductionsWithoutTheirPremultiplication)
{
    const TexelFormat format{TexelType::Float, 2, std::uint16_t{1}};
    PtxContents contents = samples::mixed(format, std::vector{4});
    std::vector<float> values(2 * std::size_t{Level(4).texelCount()});
    for (std::size_t k = 0; k < values.size(); k += 2) {
        values[k] = 0.75F;
        values[k + 1] = k % 3 == 0 ? 0.5F : 0.25F;
    }
    contents.texels.exchange(
        faceId(0),
        FaceTexels::full(Level(4), format.texelBytes(), std::as_bytes(std::span(values))));
    ASSERT_TRUE(writePtx(m_ptx, contents, {}, m_progress));
    const auto level = onDemand(m_ptx).texels.face(faceId(0)).storedLevel(Level(2));
    ASSERT_TRUE(level);
    std::vector<float> coarse(2 * std::size_t{Level(2).texelCount()});
    decode(format.type, level->bytes(), coarse);
    for (std::size_t k = 0; k < coarse.size(); k += 2) {
        EXPECT_NEAR(coarse[k], 0.75F, 1e-5);
        EXPECT_LT(coarse[k + 1], 0.5F);
    }
}

TEST_F(PtxStoredFaces, ofSmallFilesAreReadAtOnce)
{
    ASSERT_TRUE(writePtx(m_ptx, samples::mixed({}, std::vector{5, 5}), {}, m_progress));
    const auto opened = onDemand(m_ptx, {});
    EXPECT_EQ(opened.faces, nullptr);
    EXPECT_FALSE(opened.texels.face(faceId(0)).isStored());
}

TEST_F(PtxStoredFaces, askedForByManyThreadsAreRightAndWithinTheBudget)
{
    const PtxContents contents =
        samples::mixed({TexelType::UInt16, 3, {}}, std::vector<int>(60, 5));
    ASSERT_TRUE(writePtx(m_ptx, contents, {}, m_progress));
    const std::uint64_t budget = std::uint64_t{20} * 1024 * 6;
    const auto opened = onDemand(m_ptx, {.wholeBytes = 0, .cacheBytes = budget});
    std::atomic<int> wrong = 0;
    {
        std::vector<std::jthread> threads;
        for (std::uint32_t t = 0; t < 6; ++t) {
            threads.emplace_back([&, t] {
                for (std::uint32_t k = 0; k < 60; ++k) {
                    const FaceId face = faceId((k * (t + 1)) % 60);
                    wrong +=
                        opened.texels.face(face).pinned() == contents.texels.face(face) ? 0 : 1;
                    wrong += opened.faces->cachedBytes() <= budget ? 0 : 1;
                }
            });
        }
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(opened.faces->heldBytes(), 0U);
}

TEST_F(PtxStoredFaces, areSavedAsThoseReadAtOnce)
{
    ASSERT_TRUE(exportPtx(m_ptx, stripProject(30), {}, m_progress));
    Project eager = openPtx(m_ptx, m_progress, kAtOnce).value();
    Project stored = openPtx(m_ptx, m_progress, kOnDemand).value();
    ASSERT_EQ(eager.storedFaces, nullptr);
    ASSERT_NE(stored.storedFaces, nullptr);
    EXPECT_FALSE(stored.texels.face(faceId(4)).bytes().empty()); // some are read before
    for (Project* project : {&eager, &stored}) {
        project->texels.writable(faceId(2))[100] ^= std::byte{0x55};
        project->texels.exchange(faceId(9),
                                 FaceTexels::constant(Level(3), std::array<std::byte, 3>{}));
    }
    const fs::path other = m_folder / "other.ptx";
    ASSERT_TRUE(exportPtx(m_target, eager, {}, m_progress));
    ASSERT_TRUE(exportPtx(other, stored, {}, m_progress));
    EXPECT_EQ(bytesOfFile(m_target), bytesOfFile(other));
    ASSERT_TRUE(saveProject(m_target, eager, m_progress));
    ASSERT_TRUE(saveProject(other, stored, m_progress));
    EXPECT_EQ(bytesOfFile(m_target), bytesOfFile(other));
    EXPECT_FALSE(stored.texels.face(faceId(5)).isLoaded()); // saving held none of them
}

TEST_F(PtxStoredFaces, canBeSavedOverTheFileTheyLieIn)
{
    const Project made = stripProject(12);
    ASSERT_TRUE(exportPtx(m_ptx, made, {}, m_progress));
    Project stored = openPtx(m_ptx, m_progress, kOnDemand).value();
    stored.texels.writable(faceId(0))[3] ^= std::byte{0x0F};
    ASSERT_TRUE(exportPtx(m_ptx, stored, {}, m_progress));
    ASSERT_TRUE(exportPtx(m_ptx, stored, {}, m_progress)); // the old file is still read
    const Project again = openPtx(m_ptx, m_progress, kOnDemand).value();
    for (std::uint32_t k = 1; k < 12; ++k) {
        EXPECT_EQ(again.texels.face(faceId(k)), made.texels.face(faceId(k)));
        EXPECT_EQ(stored.texels.face(faceId(k)), made.texels.face(faceId(k)));
    }
    EXPECT_EQ(again.texels.face(faceId(0)), stored.texels.face(faceId(0)));
}

TEST_F(PtxStoredFaces, surviveTheRemovalOfTheirFile)
{
    const Project made = stripProject(12);
    ASSERT_TRUE(exportPtx(m_ptx, made, {}, m_progress));
    const Project stored = openPtx(m_ptx, m_progress, kOnDemand).value();
    fs::remove(m_ptx);
    expectSame(stored.texels, made.texels);
}

TEST_F(PtxStoredFaces, thatAreDamagedAreToldShownAndNeverWritten)
{
    // Blocks that are no stream, unzip to fewer bytes, or end in another sum.
    Deflater deflater;
    const auto few = deflater.zip(std::vector<std::byte>(40));
    const std::string shorter(reinterpret_cast<const char*>(few.data()), few.size());
    const std::vector<std::pair<std::size_t, std::string>> cases{
        {0, "not a stream"}, {0, shorter}, {500, std::string(20, '\xA5')}};
    for (const auto& [offset, bytes] : cases) {
        const Project made = stripProject(12);
        ASSERT_TRUE(exportPtx(m_ptx, made, {}, m_progress));
        write(m_ptx, blockOf(m_ptx, faceId(5), 0).offset + offset, bytes);
        fs::remove(m_target);
        Project stored = openPtx(m_ptx, m_progress, kOnDemand).value();
        const StoredFaces& faces = *stored.storedFaces;
        EXPECT_EQ(faces.faultCount(), 0U);

        // Refused though nobody looked at the face before.
        const Status refused = exportPtx(m_target, stored, {}, m_progress);
        ASSERT_FALSE(refused);
        EXPECT_THAT(refused.error().message, HasSubstr("face 5 could not be read"));
        EXPECT_FALSE(fs::exists(m_target));
        EXPECT_FALSE(saveProject(m_target, stored, m_progress));
        EXPECT_FALSE(converted(stored.texels, TexelType::Float, Threads{2}, m_progress));

        ASSERT_EQ(faces.faultCount(), 1U);
        EXPECT_EQ(faces.faults().front().face, faceId(5));
        EXPECT_THAT(faces.faults().front().sentence, HasSubstr(m_ptx.string()));
        EXPECT_THAT(faces.faults().front().sentence, HasSubstr("face 5 "));
        const FaceTexels shown = stored.texels.face(faceId(5)).pinned();
        EXPECT_EQ(shown.byteCount(), Level(5).texelCount() * std::size_t{3});
        EXPECT_TRUE(shown.isDamaged());
        EXPECT_FALSE(shown.collapsed().isConstant());
        for (const std::uint32_t whole : {0U, 4U, 6U}) {
            EXPECT_EQ(stored.texels.face(faceId(whole)), made.texels.face(faceId(whole)));
        }

        // Painted over in part it is still refused, filled it is whole; undone it is refused again.
        stored.texels.writable(faceId(5))[0] = std::byte{1};
        EXPECT_FALSE(exportPtx(m_target, stored, {}, m_progress));
        TexelPatch fill;
        fill.addFace(faceId(5), FaceTexels::constant(Level(5), std::array<std::byte, 3>{}));
        fill.swap(stored.texels);
        EXPECT_TRUE(exportPtx(m_target, stored, {}, m_progress));
        fill.swap(stored.texels);
        EXPECT_FALSE(exportPtx(m_target, stored, {}, m_progress));
    }
}

TEST_F(PtxStoredFaces, ofAFileCutShortOrChangedAreFaults)
{
    const Project made = stripProject(12);
    for (const bool isCut : {true, false}) {
        ASSERT_TRUE(exportPtx(m_ptx, made, {}, m_progress));
        const Project stored = openPtx(m_ptx, m_progress, kOnDemand).value();
        EXPECT_EQ(stored.texels.face(faceId(1)), made.texels.face(faceId(1)));
        if (isCut) {
            fs::resize_file(m_ptx, fs::file_size(m_ptx) / 2);
        } else { // the same bytes, written by somebody else
            const std::array<timespec, 2> times{timespec{1'000'000'000, 0},
                                                timespec{1'000'000'000, 0}};
            ASSERT_EQ(::utimensat(AT_FDCWD, m_ptx.c_str(), times.data(), 0), 0);
        }
        EXPECT_EQ(stored.texels.face(faceId(1)).pinned(), made.texels.face(faceId(1)));
        EXPECT_TRUE(stored.texels.face(faceId(10)).pinned().isDamaged());
        ASSERT_EQ(stored.storedFaces->faultCount(), 1U);
        EXPECT_THAT(stored.storedFaces->faults().front().sentence,
                    HasSubstr("was changed by another program"));
        EXPECT_FALSE(exportPtx(m_target, stored, {}, m_progress));
    }
}

TEST_F(PtxStoredFaces, whoseReductionIsDamagedAreStillWhole)
{
    const Project made = stripProject(3);
    ASSERT_TRUE(exportPtx(m_ptx, made, {}, m_progress));
    write(m_ptx, blockOf(m_ptx, faceId(1), 1).offset, "nothing");
    const Project stored = openPtx(m_ptx, m_progress, kOnDemand).value();
    EXPECT_TRUE(stored.texels.face(faceId(1)).hasStoredLevel(Level(4)));
    EXPECT_FALSE(stored.texels.face(faceId(1)).storedLevel(Level(4)));
    EXPECT_TRUE(stored.texels.face(faceId(0)).storedLevel(Level(4)));
    expectSame(stored.texels, made.texels);
    EXPECT_TRUE(exportPtx(m_target, stored, {}, m_progress));
}

// What walks over all faces may not leave their texels behind in memory.
TEST_F(PtxStoredFaces, areWalkedOverWithoutBeingHeld)
{
    ASSERT_TRUE(exportPtx(m_ptx, stripProject(40), {}, m_progress));
    const Project eager = openPtx(m_ptx, m_progress, kAtOnce).value();
    Project stored = openPtx(m_ptx, m_progress, kOnDemand).value();
    const TriangleMesh& mesh = eager.surface->mesh();
    const Adjacency& adjacency = eager.surface->adjacency();
    const std::vector<TexelNumber> numbers(1);
    const auto histograms = [&](const Project& project) {
        return countValues(project.texels, numbers, Threads{2}, m_progress)->front().summary();
    };
    EXPECT_EQ(histograms(stored).total, histograms(eager).total);
    EXPECT_EQ(histograms(stored).greatest, histograms(eager).greatest);
    const auto figures = [&](const Project& project) {
        return FaceFigures::measure(mesh, project.texels, {}, Threads{2}, m_progress).value();
    };
    EXPECT_EQ(figures(stored).mean(faceId(6)), figures(eager).mean(faceId(6)));
    const TexelTest never = [](std::span<const float>) { return std::nullopt; };
    EXPECT_FALSE(nextTexel(stored.texels, std::nullopt, never, m_progress).value());
    EXPECT_TRUE(FloatMips::build(stored.texels, Threads{2}, m_progress));
    EXPECT_TRUE(converted(stored.texels, TexelType::Half, Threads{2}, m_progress));
    EXPECT_EQ(stored.texels.storedBytes(), eager.texels.storedBytes());

    std::vector<FaceId> faces;
    for (std::uint32_t k = 0; k < 40; k += 3) {
        faces.push_back(faceId(k));
    }
    for (const LevelChange::Kind kind : {LevelChange::Kind::Halve, LevelChange::Kind::Double}) {
        Project otherEager = eager;
        Project otherStored = stored;
        for (Project* project : {&otherEager, &otherStored}) {
            const auto levels = changedLevels(project->texels, faces, {kind, {}});
            ASSERT_TRUE(changeLevels(project->texels, adjacency, levels, Threads{2}, m_progress));
        }
        EXPECT_EQ(stored.storedFaces->heldBytes(), 0U);
        expectSame(otherStored.texels, otherEager.texels);
        otherStored = stored;
    }
}

TEST_F(PtxStoredFaces, thatAreDamagedDoNotChangeTheirLevel)
{
    ASSERT_TRUE(exportPtx(m_ptx, stripProject(12), {}, m_progress));
    write(m_ptx, blockOf(m_ptx, faceId(5), 0).offset, "not a stream");
    Project stored = openPtx(m_ptx, m_progress, kOnDemand).value();
    const auto change = [&](std::uint32_t face, LevelChange::Kind kind) {
        const std::array faces{faceId(face)};
        const auto levels = changedLevels(stored.texels, faces, {kind, {}});
        return changeLevels(
            stored.texels, stored.surface->adjacency(), levels, Threads{2}, m_progress);
    };
    EXPECT_FALSE(change(5, LevelChange::Kind::Halve));
    EXPECT_FALSE(change(5, LevelChange::Kind::Double));
    EXPECT_FALSE(change(6, LevelChange::Kind::Double)); // it would take from its neighbour
    EXPECT_EQ(stored.texels.face(faceId(6)).level(), Level(5));
    EXPECT_TRUE(change(9, LevelChange::Kind::Halve));
}
