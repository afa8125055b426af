// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

using namespace trixel;

TEST(ParallelFor, everyItemIsDoneExactlyOnceWhateverTheThreads)
{
    for (unsigned threads : {0U, 1U, 2U, 8U}) {
        for (std::size_t count : {0UL, 1UL, 7UL, 64UL, 1000UL}) {
            std::vector<std::atomic<int>> done(count);
            parallelFor(count, 7, Threads{threads}, [&](std::size_t begin, std::size_t end) {
                for (std::size_t k = begin; k < end; ++k) {
                    ++done[k];
                }
            });
            for (const auto& times : done) {
                EXPECT_EQ(times, 1);
            }
        }
    }
}

TEST(ParallelFor, rangesStartAtMultiplesOfTheGrainWhenSeveralThreadsWork)
{
    parallelFor(100, 16, Threads{2}, [](std::size_t begin, std::size_t end) {
        EXPECT_EQ(begin % 16, 0U);
        EXPECT_LE(end, 100U);
        EXPECT_LT(begin, end);
    });
}
