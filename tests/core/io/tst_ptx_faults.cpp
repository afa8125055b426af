// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files whose checksums are right and whose contents are not: each is refused for its own reason.
#include "core/base/read_file.h"
#include "core/io/deflate.h"
#include "core/io/inflate.h"
#include "core/io/ptx_layout.h"
#include "tests/core/io/ptx_samples.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <functional>
#include <gmock/gmock.h>
#include <unistd.h>

using namespace trixel;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kHeadBytes = PtxHeader::kBytes + PtxHeader::kExtendedBytes;

std::string text(std::span<const std::byte> bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// A file of three uint8 RGB faces of level 3, taken apart so that its parts can be changed.
struct Parts
{
    Parts()
    {
        const fs::path path =
            fs::temp_directory_path() / ("trixel-faults-" + std::to_string(::getpid()) + ".ptx");
        NoProgress progress;
        EXPECT_TRUE(writePtx(path, samples::mixed({}, std::vector{3, 3, 3}), {}, progress));
        const std::string file = readFile(path).value();
        fs::remove(path);
        const auto bytes = std::as_bytes(std::span(file));
        header = parsePtxHeader(bytes.first(PtxHeader::kBytes)).value();
        parsePtxExtendedHeader(bytes.subspan(PtxHeader::kBytes, PtxHeader::kExtendedBytes), header);
        infos.resize(header.faces);
        EXPECT_TRUE(Inflater().unzip(bytes.subspan(kHeadBytes, header.faceInfoBytes),
                                     std::as_writable_bytes(std::span(infos))));
        const std::size_t constants = kHeadBytes + header.faceInfoBytes;
        constantStream = text(bytes.subspan(constants, header.constantBytes));
        const std::size_t levelTable = constants + header.constantBytes;
        std::memcpy(levels.data(), bytes.data() + levelTable, sizeof(levels));
        levelData = text(bytes.subspan(levelTable + sizeof(levels), header.levelDataBytes));
    }

    std::string file() const
    {
        PtxHeader changed = header;
        const std::string infoStream = text(Deflater().zip(std::as_bytes(std::span(infos))));
        changed.faceInfoBytes = static_cast<std::uint32_t>(infoStream.size());
        const std::string rest = infoStream + constantStream +
                                 text(std::as_bytes(std::span(levels))) + levelData +
                                 std::string(8, '\0');
        changed.editOffset = kHeadBytes + rest.size();
        changed.editBytes = edits.size();
        return text(bytesOf(changed)) + rest + edits;
    }

    PtxHeader header;
    std::vector<PtxFaceInfo> infos;
    std::string constantStream;
    std::array<PtxLevelInfo, 2> levels;
    std::string levelData;
    std::string edits;
};

std::string outcome(const Parts& parts)
{
    NoProgress progress;
    const auto read = parsePtx(parts.file(), progress);
    return read ? std::string("opened") : read.error().message;
}

std::string outcomeWith(const std::function<void(Parts&)>& change)
{
    Parts parts;
    change(parts);
    return outcome(parts);
}

std::string faceEdit(std::uint32_t face, const PtxFaceInfo& info, std::uint32_t blockBits)
{
    std::string payload(4 + sizeof(info) + 4 + 3, '\0');
    std::memcpy(payload.data(), &face, 4);
    std::memcpy(payload.data() + 4, &info, sizeof(info));
    std::memcpy(payload.data() + 4 + sizeof(info), &blockBits, 4);
    const auto size = static_cast<std::uint32_t>(payload.size());
    std::string edit(5, '\0');
    std::memcpy(edit.data() + 1, &size, 4);
    return edit + payload;
}

} // namespace

TEST(PtxFaults, thePartsAsTheyWereMakeAFile)
{
    EXPECT_EQ(outcome(Parts()), "opened");
}

TEST(PtxFaults, faceInfosThatNoTriangleHasAreRefused)
{
    EXPECT_THAT(outcomeWith([](Parts& p) { p.infos[1].vLog2 = 2; }),
                HasSubstr("face 1 is 2^3 by 2^2"));
    EXPECT_THAT(outcomeWith([](Parts& p) { p.infos[2].uLog2 = p.infos[2].vLog2 = 13; }),
                HasSubstr("face 2 has level 13, Trixel holds levels 0 to 12"));
    EXPECT_THAT(outcomeWith([](Parts& p) { p.infos[0].uLog2 = p.infos[0].vLog2 = -1; }),
                HasSubstr("level -1"));
    EXPECT_THAT(outcomeWith([](Parts& p) { p.infos[0].adjacentFaces[0] = 3; }),
                HasSubstr("names face 3"));
    EXPECT_THAT(outcomeWith([](Parts& p) { p.infos[0].adjacentFaces[2] = -2; }),
                HasSubstr("names face -2"));
    EXPECT_THAT(outcomeWith([](Parts& p) { p.infos[0].adjacentEdges = 3U << 2U; }),
                HasSubstr("edge 3"));
}

TEST(PtxFaults, aLinkThatHoldsFromOneSideOnlyBecomesABorder)
{
    Parts parts;
    parts.infos[0].adjacentFaces[2] = 2;
    NoProgress progress;
    const auto read = parsePtx(parts.file(), progress);
    ASSERT_TRUE(read.has_value()) << read.error().message;
    EXPECT_FALSE(read->adjacency.neighbour(faceId(0), LocalEdge::E2).has_value());
    EXPECT_TRUE(read->adjacency.neighbour(faceId(0), LocalEdge::E1).has_value());
}

TEST(PtxFaults, levelsThatDoNotFitTheirTablesAreRefused)
{
    EXPECT_THAT(outcomeWith([](Parts& p) { p.levels[0].faces = 2; }), HasSubstr("lists 2 faces"));
    EXPECT_THAT(outcomeWith([](Parts& p) { p.levels[1].faces = 4; }), HasSubstr("lists 4 faces"));
    EXPECT_THAT(outcomeWith([](Parts& p) { p.levels[0].dataBytes += 1U << 20U; }),
                HasSubstr("should end inside the level data"));
    EXPECT_THAT(outcomeWith([](Parts& p) { p.levels[0].dataBytes = ~std::uint64_t{0}; }),
                HasSubstr("should end inside the level data"));
    EXPECT_THAT(outcomeWith([](Parts& p) { p.levels[1].headerBytes = ~0U; }), HasSubstr("table"));
    EXPECT_THAT(outcomeWith([](Parts& p) { p.levels[0].dataBytes -= 10; }),
                HasSubstr("ends beyond its level"));
}

TEST(PtxFaults, aFaceOfAnotherLevelThanItsBlockIsRefused)
{
    EXPECT_THAT(outcomeWith([](Parts& p) { p.infos[1].uLog2 = p.infos[1].vLog2 = 4; }),
                HasSubstr("block of face 1"));
    EXPECT_THAT(outcomeWith([](Parts& p) { p.infos[1].uLog2 = p.infos[1].vLog2 = 12; }),
                HasSubstr("block of face 1"));
}

TEST(PtxFaults, sizesThatOverflowSumsAreRefused)
{
    EXPECT_THAT(outcomeWith([](Parts& p) { p.header.levelDataBytes = ~std::uint64_t{0} - 100; }),
                HasSubstr("should lie inside the file"));
    EXPECT_THAT(outcomeWith([](Parts& p) { p.header.metadataZippedBytes = ~0U; }),
                HasSubstr("the metadata"));
    EXPECT_THAT(outcomeWith([](Parts& p) {
                    p.header.largeHeaderZippedBytes = 4;
                    p.header.largeDataBytes = ~std::uint64_t{0};
                }),
                HasSubstr("should lie inside the file"));
    EXPECT_THAT(outcomeWith([](Parts& p) { p.header.faces = 100'000'000; }),
                HasSubstr("zipped bytes cannot hold"));
}

TEST(PtxFaults, editsOutsideTheTextureAreRefused)
{
    const PtxFaceInfo constant{.uLog2 = 1, .vLog2 = 1, .flags = PtxFaceInfo::kConstant};
    const PtxFaceInfo full{.uLog2 = 1, .vLog2 = 1};
    EXPECT_EQ(outcomeWith([&](Parts& p) { p.edits = faceEdit(2, constant, 0); }), "opened");
    EXPECT_THAT(outcomeWith([&](Parts& p) { p.edits = faceEdit(3, constant, 0); }),
                HasSubstr("is of face 3"));
    EXPECT_THAT(outcomeWith([&](Parts& p) { p.edits = faceEdit(0, full, 500); }),
                HasSubstr("ends beyond it"));
    EXPECT_THAT(outcomeWith([&](Parts& p) {
                    PtxFaceInfo tall = full;
                    tall.vLog2 = 2;
                    p.edits = faceEdit(0, tall, 0);
                }),
                HasSubstr("must be alike"));
    EXPECT_THAT(outcomeWith([&](Parts& p) { p.edits = faceEdit(0, constant, 0).substr(0, 20); }),
                HasSubstr("ends beyond the edits"));
    EXPECT_THAT(outcomeWith([&](Parts& p) { p.edits = std::string("\1\4\0\0\0abcd", 9); }),
                HasSubstr("ends inside its head"));
}
