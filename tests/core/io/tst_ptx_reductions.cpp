// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ptx_faces.h"
#include "core/io/ptx_reductions.h"
#include "tests/core/cancel_after.h"
#include "tests/core/io/ptx_samples.h"

#include <gtest/gtest.h>

#include <map>
#include <vector>

using namespace trixel;

namespace {

using Bytes = std::map<Level, std::uint64_t>;

Bytes measured(const TexelFormat& format, const FaceTexels& face)
{
    Bytes bytes;
    NoProgress progress;
    const Status status = measurePtxLevels(
        format,
        face,
        [&](Level level, std::uint64_t size) { EXPECT_TRUE(bytes.emplace(level, size).second); },
        progress);
    EXPECT_TRUE(status);
    return bytes;
}

/// What the writer packs of a store of this one face.
Bytes written(const TexelFormat& format, const FaceTexels& face)
{
    TexelStore store(1, format, Level(), face.bytes().first(format.texelBytes()));
    store.exchange(FaceId{0}, face);
    NoProgress progress;
    const PtxFaces faces = packPtxFaces(store, Adjacency(1), true, {1}, progress).value();
    Bytes bytes;
    for (int reduction = 0; reduction < faces.levelCount; ++reduction) {
        faces.forEachBlocks(reduction, [&](const PtxBlocks& blocks) {
            for (const PtxBlockHeader header : blocks.headers) {
                EXPECT_EQ(blocks.bytes.size(), header.size());
                if (header.size() > 0) {
                    bytes[face.level().coarser(reduction)] = header.size();
                }
            }
        });
    }
    return bytes;
}

} // namespace

TEST(PtxReductions, bytesAreThoseThatTheWriterWrites)
{
    for (const TexelType type :
         {TexelType::UInt8, TexelType::UInt16, TexelType::Half, TexelType::Float}) {
        for (const auto alpha : {std::optional<std::uint16_t>(), std::optional<std::uint16_t>(3)}) {
            const TexelFormat format{type, 4, alpha};
            for (const int n : {0, 1, 2, 3, 5, 8}) {
                const Level level(n);
                const FaceTexels face = FaceTexels::full(
                    level, format.texelBytes(), samples::randomTexels(format, level, 5));
                const Bytes found = measured(format, face);
                EXPECT_EQ(found, written(format, face)) << nameOf(type) << " level " << n;
                for (int k = 0; k <= n; ++k) {
                    const bool constant = n == 0; // one texel
                    EXPECT_EQ(found.contains(Level(k)),
                              ptxKeeping(level, constant, Level(k)) == PtxKeeping::Block);
                }
            }
        }
    }
}

TEST(PtxReductions, aFaceOfOneColourTakesNoBlocksWhetherItIsSpreadOutOrNot)
{
    const TexelFormat format;
    const auto grey = samples::randomTexels(format, Level(), 1);
    FaceTexels face = FaceTexels::constant(Level(5), grey);
    EXPECT_TRUE(measured(format, face).empty());
    (void)face.writable();
    ASSERT_FALSE(face.isConstant());
    EXPECT_TRUE(measured(format, face).empty());
    EXPECT_TRUE(written(format, face).empty());
    EXPECT_EQ(ptxKeeping(Level(5), true, Level(3)), PtxKeeping::Constant);
}

TEST(PtxReductions, theTwoSmallestLevelsAreNotBlocks)
{
    EXPECT_EQ(ptxKeeping(Level(5), false, Level(5)), PtxKeeping::Block);
    EXPECT_EQ(ptxKeeping(Level(5), false, Level(2)), PtxKeeping::Block);
    EXPECT_EQ(ptxKeeping(Level(5), false, Level(1)), PtxKeeping::Computed);
    EXPECT_EQ(ptxKeeping(Level(5), false, Level(0)), PtxKeeping::Average);
    EXPECT_EQ(ptxKeeping(Level(1), false, Level(1)), PtxKeeping::Block);
}

TEST(PtxReductions, theCoarsestIsToldOfFirstAndCancellingStops)
{
    const TexelFormat format;
    const FaceTexels face =
        FaceTexels::full(Level(5), 3, samples::randomTexels(format, Level(5), 5));
    std::vector<int> told;
    const auto tell = [&](Level level, std::uint64_t /*bytes*/) { told.push_back(level.log2()); };
    CancelAfter never(100);
    EXPECT_TRUE(measurePtxLevels(format, face, tell, never));
    EXPECT_EQ(told, (std::vector{2, 3, 4, 5}));
    told.clear();
    CancelAfter soon(2);
    const Status status = measurePtxLevels(format, face, tell, soon);
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().kind, ErrorKind::Cancelled);
    EXPECT_EQ(told, (std::vector{2, 3}));
}
