// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/face_pieces.h"
#include "tests/core/cancel_after.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <new>
#include <set>
#include <vector>

using namespace trixel;

namespace {

/// Empty faces, small ones and some of many runs.
std::vector<std::uint64_t> counts()
{
    std::vector<std::uint64_t> counts = {0, 1, 3 * kItemsAtOnce, 0, 0, kItemsAtOnce, 20'000, 0};
    for (std::uint64_t k = 0; k < 9000; ++k) {
        counts.push_back(k % 5);
    }
    return counts;
}

TEST(FacePieces, coverEveryItemOnceAndStayWithinARun)
{
    const std::vector<std::uint64_t> wanted = counts();
    for (const unsigned threads : {1U, 3U}) {
        std::mutex mutex;
        std::vector<std::set<std::uint64_t>> seen(wanted.size());
        NoProgress progress;
        const Status done = forFacePieces(
            wanted.size(),
            [&](FaceId face) { return wanted[indexOf(face)]; },
            Threads{threads},
            progress,
            [&](const FacePiece& piece) {
                const std::lock_guard lock(mutex);
                EXPECT_LE(piece.count, kItemsAtOnce);
                EXPECT_GE(piece.count, 1U);
                for (std::uint64_t k = 0; k < piece.count; ++k) {
                    EXPECT_TRUE(seen[indexOf(piece.face)].insert(piece.first + k).second);
                }
            });
        ASSERT_TRUE(done);
        for (std::size_t f = 0; f < wanted.size(); ++f) {
            ASSERT_EQ(seen[f].size(), wanted[f]);
            ASSERT_TRUE(seen[f].empty() || *seen[f].rbegin() + 1 == wanted[f]);
        }
    }
}

TEST(FacePieces, wholeFacesAreTakenOnceThoseWithoutItemsToo)
{
    const std::vector<std::uint64_t> wanted = counts();
    std::vector<std::atomic<int>> taken(wanted.size());
    NoProgress progress;
    ASSERT_TRUE(forWholeFaces(
        wanted.size(),
        [&](FaceId face) { return wanted[indexOf(face)]; },
        Threads{3},
        progress,
        [&](FaceId face) { ++taken[indexOf(face)]; }));
    for (const auto& times : taken) {
        ASSERT_EQ(times, 1);
    }
    EXPECT_TRUE(forWholeFaces(0, {}, Threads{2}, progress, {}));
}

TEST(FacePieces, oneLargeFaceIsLeftSoonAfterItWasCancelled)
{
    std::uint64_t items = 0;
    CancelAfter progress(3); // the first tells of the beginning
    const Status done = forFacePieces(
        1,
        [](FaceId) { return 100 * kItemsAtOnce; },
        Threads{1},
        progress,
        [&](const FacePiece& piece) { items += piece.count; });
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().kind, ErrorKind::Cancelled);
    EXPECT_EQ(items, 3 * kItemsAtOnce);
}

TEST(FacePieces, memoryThatRunsOutIsAnErrorInASentence)
{
    NoProgress progress;
    const Status done = forFacePieces(
        2,
        [](FaceId) { return 10 * kItemsAtOnce; },
        Threads{2},
        progress,
        [](const FacePiece& piece) {
            if (piece.face == faceId(1)) {
                throw std::bad_alloc();
            }
        });
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().kind, ErrorKind::Contents);
    EXPECT_EQ(done.error().message, "what is made of the faces does not fit into memory");
}

} // namespace
