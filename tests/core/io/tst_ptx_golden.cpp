// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files written by the reference library read to exactly what is known of them.
#include "core/io/ptx_file.h"
#include "core/io/ptx_metadata.h"
#include "core/io/ptx_reader.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <zlib.h>

using namespace trixel;
using nlohmann::json;

namespace {

const std::filesystem::path kFolder = std::filesystem::path(TRIXEL_TEST_DATA) / "ptx";

std::string crcOf(std::span<const std::byte> bytes)
{
    const auto crc =
        crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size()));
    char text[9];
    std::snprintf(text, sizeof(text), "%08lx", crc);
    return text;
}

std::string hexOf(std::span<const std::byte> bytes)
{
    std::string text;
    for (std::byte b : bytes) {
        char digits[3];
        std::snprintf(digits, sizeof(digits), "%02x", static_cast<unsigned>(b));
        text += digits;
    }
    return text;
}

json wanted(const std::string& name)
{
    return json::parse(std::ifstream(kFolder / (name + ".json")));
}

PtxFile opened(const std::string& name, MemoryBudget& budget)
{
    auto file = PtxFile::open(fileSource(kFolder / (name + ".ptx")).value(), budget);
    EXPECT_TRUE(file.has_value()) << file.error().message;
    return std::move(file.value());
}

// A constant face stores one texel; the packed square is that texel everywhere.
std::string crcOf(FaceTexels texels)
{
    return crcOf(texels.writable());
}

// Face 11 of these files was never written and names no neighbours, while others name it.
bool holdsFromBothSides(const json& faces, std::uint32_t face, std::size_t edge)
{
    const int other = faces[face]["adjFaces"][edge].get<int>();
    if (other < 0) {
        return false;
    }
    const auto otherEdge = faces[face]["adjEdges"][edge].get<std::size_t>();
    const json& back = faces[static_cast<std::size_t>(other)];
    return back["adjFaces"][otherEdge].get<int>() == static_cast<int>(face) &&
           back["adjEdges"][otherEdge].get<std::size_t>() == edge;
}

class PtxGolden : public testing::TestWithParam<std::string>
{
protected:
    MemoryBudget m_budget;
    json m_wanted = wanted(GetParam());
    PtxFile m_file = opened(GetParam(), m_budget);
};

} // namespace

TEST_P(PtxGolden, headerReadsAsWritten)
{
    const TexelFormat format = m_file.format();
    EXPECT_EQ(nameOf(format.type), m_wanted["dataType"].get<std::string>());
    EXPECT_EQ(format.channels, m_wanted["channels"].get<int>());
    EXPECT_EQ(format.alpha ? *format.alpha : -1, m_wanted["alphaChannel"].get<int>());
    EXPECT_EQ(m_file.levelCount(), m_wanted["levels"].get<int>());
    EXPECT_EQ(m_file.levelCount() > 1, m_wanted["hasMipMaps"].get<bool>());
    EXPECT_EQ(m_file.faceCount(), m_wanted["faces"].size());
}

TEST_P(PtxGolden, faceInfosReadAsWritten)
{
    for (std::uint32_t k = 0; k < m_file.faceCount(); ++k) {
        SCOPED_TRACE("face " + std::to_string(k));
        const json& face = m_wanted["faces"][k];
        const PtxFaceInfo& info = m_file.info(faceId(k));
        EXPECT_EQ(info.level().log2(), face["log2"].get<int>());
        for (std::size_t e = 0; e < 3; ++e) {
            EXPECT_EQ(info.adjacentFaces[e], face["adjFaces"][e].get<int>());
            EXPECT_EQ(info.adjacentEdge(e), face["adjEdges"][e].get<int>());
        }
        EXPECT_EQ(info.isConstant(), face["constant"].get<bool>());
        EXPECT_EQ((info.flags & PtxFaceInfo::kConstantNeighbours) != 0,
                  face["neighbourhoodConstant"].get<bool>());
        EXPECT_EQ(info.isEdited(), face["edited"].get<bool>());
        EXPECT_EQ(hexOf(m_file.constantValue(faceId(k))), face["average"].get<std::string>());
    }
}

TEST_P(PtxGolden, texelsOfEveryStoredLevelReadAsWritten)
{
    PtxDecoder decoder;
    for (std::uint32_t k = 0; k < m_file.faceCount(); ++k) {
        const json& crcs = m_wanted["faces"][k]["crc32"];
        ASSERT_EQ(static_cast<int>(crcs.size()), m_file.levelCount());
        for (int reduction = 0; reduction < m_file.levelCount(); ++reduction) {
            SCOPED_TRACE("face " + std::to_string(k) + " reduction " + std::to_string(reduction));
            const auto texels = m_file.texels(faceId(k), reduction, decoder);
            ASSERT_TRUE(texels.has_value()) << texels.error().message;
            const json& crc = crcs[static_cast<std::size_t>(reduction)];
            ASSERT_EQ(texels->has_value(), !crc.is_null());
            if (texels->has_value()) {
                EXPECT_EQ(crcOf(**texels), crc.get<std::string>());
            }
        }
    }
}

TEST_P(PtxGolden, metadataReadAsWritten)
{
    const auto items = m_file.metadata(m_budget);
    ASSERT_TRUE(items.has_value()) << items.error().message;
    ASSERT_EQ(items->size(), m_wanted["metadata"].size());
    for (std::size_t k = 0; k < items->size(); ++k) {
        const json& item = m_wanted["metadata"][k];
        const PtxMetadata& read = (*items)[k];
        EXPECT_EQ(read.key, item["key"].get<std::string>());
        EXPECT_EQ(read.value.index(), item["type"].get<std::size_t>());
        EXPECT_EQ(valueBytes(read).size(), item["bytes"].get<std::size_t>());
        EXPECT_EQ(crcOf(std::span<const std::byte>(valueBytes(read))),
                  item["crc32"].get<std::string>());
    }
}

TEST_P(PtxGolden, contentsHoldFullResolutionAndLinksThatHoldFromBothSides)
{
    NoProgress progress;
    const auto contents = readPtx(kFolder / (GetParam() + ".ptx"), progress);
    ASSERT_TRUE(contents.has_value()) << contents.error().message;
    ASSERT_EQ(contents->texels.faceCount(), m_wanted["faces"].size());
    ASSERT_EQ(contents->adjacency.faceCount(), m_wanted["faces"].size());
    EXPECT_EQ(contents->hasMips, m_wanted["hasMipMaps"].get<bool>());
    for (std::uint32_t k = 0; k < contents->texels.faceCount(); ++k) {
        SCOPED_TRACE("face " + std::to_string(k));
        const json& face = m_wanted["faces"][k];
        EXPECT_EQ(crcOf(contents->texels.face(faceId(k))), face["crc32"][0].get<std::string>());
        EXPECT_EQ(contents->texels.face(faceId(k)).isConstant(), face["constant"].get<bool>());
        for (std::size_t e = 0; e < 3; ++e) {
            const auto found = contents->adjacency.neighbour(faceId(k), kLocalEdges[e]);
            const int expected = face["adjFaces"][e].get<int>();
            ASSERT_EQ(found.has_value(), holdsFromBothSides(m_wanted["faces"], k, e));
            if (found) {
                EXPECT_EQ(indexOf(found->face), static_cast<std::size_t>(expected));
                EXPECT_EQ(indexOf(found->edge), face["adjEdges"][e].get<std::size_t>());
            }
        }
    }
}

TEST_P(PtxGolden, memoryAndFileReadAlike)
{
    std::ifstream stream(kFolder / (GetParam() + ".ptx"), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    NoProgress progress;
    const auto fromFile = readPtx(kFolder / (GetParam() + ".ptx"), progress);
    const auto fromMemory = parsePtx(bytes, progress);
    ASSERT_TRUE(fromFile && fromMemory);
    EXPECT_EQ(fromFile->adjacency, fromMemory->adjacency);
    EXPECT_EQ(fromFile->metadata, fromMemory->metadata);
    for (std::uint32_t k = 0; k < fromFile->texels.faceCount(); ++k) {
        ASSERT_EQ(fromFile->texels.face(faceId(k)), fromMemory->texels.face(faceId(k)));
    }
}

INSTANTIATE_TEST_SUITE_P(Files,
                         PtxGolden,
                         testing::Values("fmt_0_0",
                                         "fmt_0_1",
                                         "fmt_0_2",
                                         "fmt_1_0",
                                         "fmt_1_3",
                                         "fmt_2_0",
                                         "fmt_2_1",
                                         "fmt_2_2",
                                         "fmt_3_0",
                                         "fmt_3_3"),
                         [](const auto& named) { return named.param; });
