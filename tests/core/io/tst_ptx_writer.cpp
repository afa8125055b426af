// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/read_file.h"
#include "core/io/ptx_encode.h"
#include "core/io/ptx_file.h"
#include "core/io/ptx_metadata.h"
#include "core/io/ptx_verify.h"
#include "core/texture/mips.h"
#include "tests/core/io/ptx_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <unistd.h>

using namespace trixel;
namespace fs = std::filesystem;

namespace {

constexpr TexelType kTypes[] = {
    TexelType::UInt8, TexelType::UInt16, TexelType::Half, TexelType::Float};

class PtxWriter : public testing::Test
{
protected:
    PtxWriter() { fs::create_directories(m_folder); }
    ~PtxWriter() override { fs::remove_all(m_folder); }

    void write(const PtxContents& contents, const PtxWriteOptions& options = {})
    {
        const Status status = writePtx(m_path, contents, options, m_progress);
        ASSERT_TRUE(status.has_value()) << status.error().message;
    }
    PtxContents read()
    {
        auto contents = readPtx(m_path, m_progress);
        EXPECT_TRUE(contents.has_value()) << contents.error().message;
        return std::move(contents.value());
    }
    PtxFile open()
    {
        auto file = PtxFile::open(fileSource(m_path).value(), m_budget);
        EXPECT_TRUE(file.has_value()) << file.error().message;
        return std::move(file.value());
    }
    void expectRoundTrip(const PtxContents& contents, const PtxWriteOptions& options = {})
    {
        write(contents, options);
        const PtxContents back = read();
        EXPECT_EQ(back.texels.format(), contents.texels.format());
        EXPECT_EQ(back.adjacency, contents.adjacency);
        EXPECT_EQ(back.metadata, contents.metadata);
        ASSERT_EQ(back.texels.faceCount(), contents.texels.faceCount());
        for (std::uint32_t k = 0; k < back.texels.faceCount(); ++k) {
            ASSERT_EQ(back.texels.face(faceId(k)), contents.texels.face(faceId(k))) << k;
        }
    }

    fs::path m_folder = fs::temp_directory_path() / ("trixel-ptx-" + std::to_string(::getpid()));
    fs::path m_path = m_folder / "texture.ptx";
    NoProgress m_progress;
    MemoryBudget m_budget;
};

TexelFormat formatOf(TexelType type, int channels, int alpha = -1)
{
    TexelFormat format;
    format.type = type;
    format.channels = static_cast<std::uint16_t>(channels);
    if (alpha >= 0) {
        format.alpha = static_cast<std::uint16_t>(alpha);
    }
    return format;
}

std::vector<float> valuesOf(TexelType type, std::span<const std::byte> bytes)
{
    std::vector<float> values(bytes.size() / byteSize(type));
    decode(type, bytes, values);
    return values;
}

} // namespace

TEST_F(PtxWriter, everyTexelOfEveryTypeAndChannelCountRoundTrips)
{
    constexpr int kLevels[] = {0, 1, 2, 3, 4, 5, 6, 3, 3, 5, 0, 2, 6, 1};
    for (const TexelType type : kTypes) {
        for (const int channels : {1, 2, 3, 4, 7}) {
            SCOPED_TRACE(std::string(nameOf(type)) + " " + std::to_string(channels));
            expectRoundTrip(samples::mixed(formatOf(type, channels), kLevels));
            expectRoundTrip(samples::mixed(formatOf(type, channels, channels - 1), kLevels),
                            {.mips = false});
        }
    }
}

TEST_F(PtxWriter, levelsZeroToNineRoundTripThroughTiles)
{
    constexpr int kLevels[] = {9, 0, 8, 7, 1, 9, 2, 9, 3, 4, 5, 6};
    for (const TexelType type : kTypes) {
        SCOPED_TRACE(nameOf(type));
        expectRoundTrip(
            samples::mixed(formatOf(type, 3, type == TexelType::Half ? 0 : -1), kLevels));
    }
    const PtxFile file = open();
    EXPECT_EQ(file.levelCount(), 8);
    EXPECT_EQ(file.block(faceId(0), 0)->header.encoding(), PtxEncoding::Tiled);
}

TEST_F(PtxWriter, tilesFollowTheReferenceLibrarysRule)
{
    // Two texels a byte boundary: 128 KiB is cut once, one byte less is not.
    EXPECT_EQ(ptxTileSize(Level(8), 1), (PtxTileSize{8, 8}));  // 64 KiB
    EXPECT_EQ(ptxTileSize(Level(8), 2), (PtxTileSize{8, 7}));  // 128 KiB
    EXPECT_EQ(ptxTileSize(Level(9), 1), (PtxTileSize{8, 8}));  // 256 KiB
    EXPECT_EQ(ptxTileSize(Level(9), 3), (PtxTileSize{8, 7}));  // 768 KiB
    EXPECT_EQ(ptxTileSize(Level(12), 1), (PtxTileSize{8, 8})); // 16 MiB
    EXPECT_EQ(ptxTileSize(Level(0), 4096), (PtxTileSize{0, 0}));
}

TEST_F(PtxWriter, aTileOfOneColourIsStoredAsOneTexel)
{
    const TexelFormat format = formatOf(TexelType::UInt8, 3);
    PtxContents contents = samples::mixed(format, std::vector{9});
    const std::span<std::byte> texels = contents.texels.writable(faceId(0));
    std::ranges::fill(texels.first(texels.size() / 2), std::byte{7});
    expectRoundTrip(contents);
    const std::uintmax_t half = fs::file_size(m_path);
    EXPECT_LT(half, texels.size() * 3 / 4);
}

TEST_F(PtxWriter, aFaceOfOneColourIsStoredAsConstantHoweverItWasHeld)
{
    const TexelFormat format = formatOf(TexelType::UInt16, 2);
    PtxContents contents = samples::mixed(format, std::vector{3, 3, 3, 3});
    (void)contents.texels.writable(faceId(3)); // spread out, still of one value
    expectRoundTrip(contents);
    EXPECT_TRUE(open().info(faceId(3)).isConstant());
    EXPECT_FALSE(open().info(faceId(0)).isConstant());
}

TEST_F(PtxWriter, reductionsFollowTheRuleAndEndAtFourByFour)
{
    for (const TexelType type : kTypes) {
        SCOPED_TRACE(nameOf(type));
        const TexelFormat format = formatOf(type, 3);
        const PtxContents contents = samples::mixed(format, std::vector{6, 2, 5, 4, 3, 3});
        write(contents);
        const PtxFile file = open();
        ASSERT_EQ(file.levelCount(), 5);
        PtxDecoder decoder;
        for (std::uint32_t k = 0; k < file.faceCount(); ++k) {
            const FaceTexels& full = contents.texels.face(faceId(k));
            for (int reduction = 1; reduction < file.levelCount(); ++reduction) {
                const auto stored = file.texels(faceId(k), reduction, decoder).value();
                const bool wanted = full.isConstant() || full.level().log2() - reduction >= 2;
                ASSERT_EQ(stored.has_value(), wanted) << k << " " << reduction;
                if (stored) {
                    EXPECT_EQ(*stored, reduced(format, full, reduction)) << k << " " << reduction;
                }
            }
        }
    }
}

TEST_F(PtxWriter, reductionsAreMadeFromPremultipliedTexels)
{
    // Two opaque white texels' worth beside transparent black ones: white at half opacity,
    // premultiplied grey; the average keeps the colour.
    const TexelFormat format = formatOf(TexelType::Float, 2, 1);
    PtxContents contents = samples::mixed(format, std::vector{3});
    const Level level(3);
    std::vector<float> values(level.texelCount() * 2);
    for (std::size_t t = 0; t < level.texelCount(); ++t) {
        values[2 * t] = t % 2 == 0 ? 1.0F : 0.25F;
        values[2 * t + 1] = t % 2 == 0 ? 1.0F : 0.0F;
    }
    std::ranges::copy(std::as_bytes(std::span(values)),
                      contents.texels.writable(faceId(0)).begin());
    write(contents);
    const PtxFile file = open();
    PtxDecoder decoder;
    const auto reduction =
        valuesOf(format.type, file.texels(faceId(0), 1, decoder)->value().bytes());
    for (std::size_t k = 0; k < reduction.size(); k += 2) {
        EXPECT_FLOAT_EQ(reduction[k], reduction[k + 1]); // colour 1 times opacity
    }
    const auto average = valuesOf(format.type, file.constantValue(faceId(0)));
    EXPECT_FLOAT_EQ(average[0], 1.0F);
    EXPECT_FLOAT_EQ(average[1], 0.5F);
}

TEST_F(PtxWriter, averagesAreRoundedToNearestEven)
{
    const TexelFormat format = formatOf(TexelType::UInt8, 1);
    PtxContents contents = samples::mixed(format, std::vector{1, 1, 1});
    const auto put = [&](std::uint32_t face, std::array<std::uint8_t, 4> texels) {
        std::ranges::copy(std::as_bytes(std::span(texels)),
                          contents.texels.writable(faceId(face)).begin());
    };
    put(0, {1, 1, 1, 2});         // 1.25
    put(1, {1, 1, 2, 2});         // 1.5
    put(2, {254, 255, 255, 255}); // 254.75
    write(contents);
    const PtxFile file = open();
    EXPECT_EQ(file.constantValue(faceId(0))[0], std::byte{1});
    EXPECT_EQ(file.constantValue(faceId(1))[0], std::byte{2});
    EXPECT_EQ(file.constantValue(faceId(2))[0], std::byte{255});
}

TEST_F(PtxWriter, metadataOfEveryTypeAndSizeRoundTrip)
{
    PtxContents contents = samples::mixed(formatOf(TexelType::UInt8, 3), std::vector{2, 3});
    contents.metadata = {
        {"text", std::string("a text")},
        {"empty", std::string()},
        {"no values", std::vector<float>()},
        {"ключ – 鍵", std::string("значение – 値")},
        {"int8", std::vector<std::int8_t>{-128, 127}},
        {"int16", std::vector<std::int16_t>{-32768, 32767}},
        {"int32", std::vector<std::int32_t>(5000, -7)},
        {"float", std::vector<float>{0.5F, -0.0F}},
        {"double", std::vector<double>(4000, 0.1)},
        {"long text", std::string(100000, 'x')},
        {std::string(254, 'k'), std::string("the longest key")},
    };
    write(contents);
    EXPECT_THAT(read().metadata, testing::UnorderedElementsAreArray(contents.metadata));
    contents.metadata = {{"not a number", std::vector<double>{NAN}}};
    write(contents);
}

TEST_F(PtxWriter, metadataThatNoFileCanHoldAreRefused)
{
    PtxContents contents = samples::mixed(formatOf(TexelType::UInt8, 3), std::vector{2});
    for (const std::string& key : {std::string(), std::string(255, 'k'), std::string("a\0b", 3)}) {
        contents.metadata = {{key, std::string("value")}};
        const Status status = writePtx(m_path, contents, {}, m_progress);
        ASSERT_FALSE(status.has_value());
        EXPECT_EQ(status.error().kind, ErrorKind::Contents);
    }
    contents.metadata = {{"twice", std::string("a")}, {"twice", std::string("b")}};
    EXPECT_FALSE(writePtx(m_path, contents, {}, m_progress).has_value());
    EXPECT_FALSE(fs::exists(m_path));
}

TEST_F(PtxWriter, bytesDoNotDependOnTheNumberOfThreads)
{
    const PtxContents contents =
        samples::mixed(formatOf(TexelType::UInt8, 3), std::vector<int>(3000, 3));
    write(contents, {.threads = Threads{1}});
    const std::string one = readFile(m_path).value();
    write(contents, {.threads = Threads{5}});
    EXPECT_EQ(readFile(m_path).value(), one);
}

TEST_F(PtxWriter, editsBelongRightAfterTheBarrier)
{
    for (const bool withMetadata : {false, true}) {
        PtxContents contents = samples::mixed(formatOf(TexelType::UInt8, 3), std::vector{2, 3});
        if (withMetadata) {
            contents.metadata = {{"large", std::vector<double>(1000, 1.5)}};
        }
        write(contents);
        const PtxFile file = open();
        const std::string bytes = readFile(m_path).value();
        EXPECT_EQ(file.header().editOffset, bytes.size());
        EXPECT_EQ(file.header().editBytes, 0U);
        if (!withMetadata) {
            EXPECT_EQ(bytes.substr(bytes.size() - 8), std::string(8, '\0'));
        }
    }
}

TEST_F(PtxWriter, onlyFacesInAConstantNeighbourhoodAreFlagged)
{
    // A closed fan of six faces around one vertex: E2 of each meets E0 of the next.
    const TexelFormat format = formatOf(TexelType::UInt8, 1);
    PtxContents contents;
    contents.texels = TexelStore(6, format, Level(3), std::vector{std::byte{9}});
    contents.adjacency = Adjacency(6);
    for (std::uint32_t k = 0; k < 6; ++k) {
        contents.adjacency.connect(faceId(k), LocalEdge::E2, faceId((k + 1) % 6), LocalEdge::E0);
    }
    const auto flagged = [&] {
        write(contents);
        const PtxFile file = open();
        std::vector<bool> flags;
        for (std::uint32_t k = 0; k < 6; ++k) {
            flags.push_back((file.info(faceId(k)).flags & PtxFaceInfo::kConstantNeighbours) != 0);
        }
        return flags;
    };
    EXPECT_THAT(flagged(), testing::Each(true));
    contents.texels.exchange(faceId(2), FaceTexels::constant(Level(3), std::vector{std::byte{8}}));
    EXPECT_THAT(flagged(), testing::Each(false));
}

TEST_F(PtxWriter, floatsKeepTheirBitsWhateverTheyAre)
{
    const TexelFormat format = formatOf(TexelType::Float, 1);
    PtxContents contents = samples::mixed(format, std::vector{3});
    const std::vector<float> odd{NAN, -0.0F, 0.0F, INFINITY, -INFINITY, 1e-45F, 3.4e38F, -NAN};
    const auto bytes = std::as_bytes(std::span(odd));
    std::ranges::copy(bytes, contents.texels.writable(faceId(0)).begin() + 32);
    expectRoundTrip(contents);
}

TEST_F(PtxWriter, verificationNamesWhatDiffers)
{
    PtxContents contents = samples::mixed(formatOf(TexelType::UInt8, 3), std::vector{4, 3, 5, 2});
    contents.metadata = {{"key", std::string("value")}};
    write(contents);
    PtxFaces packed =
        packPtxFaces(contents.texels, contents.adjacency, true, Threads{2}, m_progress).value();
    const auto outcome = [&] {
        const Status status = verifyPtx(m_path, contents, packed, Threads{2}, m_progress);
        return status ? std::string("verified") : status.error().message;
    };
    const PtxContents meant = contents;
    const PtxFaces meantPacked = packed;
    EXPECT_EQ(outcome(), "verified");
    contents.texels.writable(faceId(2))[700] ^= std::byte{1};
    EXPECT_THAT(outcome(), testing::HasSubstr("face 2"));
    contents = meant;
    contents.texels.exchange(
        faceId(3), FaceTexels::constant(Level(2), std::vector<std::byte>(3, std::byte{1})));
    EXPECT_THAT(outcome(), testing::HasSubstr("face 3"));
    contents = meant;
    contents.metadata[0].value = std::string("other");
    EXPECT_THAT(outcome(), testing::HasSubstr("metadata"));
    contents = meant;
    packed.infos[1].adjacentFaces[0] = -1;
    EXPECT_THAT(outcome(), testing::HasSubstr("info of face 1"));
    packed = meantPacked;
    packed.constants[4] ^= std::byte{1};
    EXPECT_THAT(outcome(), testing::HasSubstr("average of face 1"));
    packed = meantPacked;
    packed.chunks[0].reductions[5][1].bytes.back() ^= std::byte{1};
    EXPECT_THAT(outcome(), testing::HasSubstr("reduced 2 times"));
}

TEST_F(PtxWriter, cancellingLeavesTheOldFile)
{
    std::ofstream(m_path) << "old";
    struct Stop final : Progress
    {
        explicit Stop(double at)
            : m_at(at)
        {
        }
        bool report(double fraction) override { return fraction < m_at; }
        double m_at;
    };
    const PtxContents contents =
        samples::mixed(formatOf(TexelType::UInt8, 3), std::vector<int>(4000, 3));
    for (const double at : {0.0, 0.3, 0.55, 0.8, 1.0}) {
        Stop stop(at);
        const Status status = writePtx(m_path, contents, {}, stop);
        ASSERT_FALSE(status.has_value()) << at;
        EXPECT_EQ(status.error().kind, ErrorKind::Cancelled);
        EXPECT_EQ(readFile(m_path).value(), "old");
        EXPECT_EQ(std::distance(fs::directory_iterator(m_folder), fs::directory_iterator()), 1);
    }
}
