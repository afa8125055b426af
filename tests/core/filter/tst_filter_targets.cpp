// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loops that are compiled for each kind of processor give the same answers on all of them.
#include "tests/core/filter/golden_queries.h"

#include <gtest/gtest.h>

#include <hwy/targets.h>

using namespace trixel;
using namespace trixel::test;

namespace {

class Targets : public ::testing::TestWithParam<std::string>
{
protected:
    static void only(std::int64_t targets)
    {
        hwy::SetSupportedTargetsForTest(targets);
        hwy::GetChosenTarget().DeInit(); // chosen anew at the next call
    }
    void TearDown() override { only(0); }
};

} // namespace

TEST_P(Targets, agree)
{
    const FilterScene scene = goldenScene();
    const GoldenQueries golden = goldenQueries();
    const auto method = makeMethod(*parseMethod(GetParam()));
    const auto best = ask(*method, scene, golden.queries);
    const std::int64_t all = hwy::SupportedTargets();
    int targets = 0;
    for (std::int64_t left = all; left != 0; left &= left - 1) {
        only(left & -left);
        const auto answers = ask(*method, scene, golden.queries);
        for (std::size_t i = 0; i < answers.size(); ++i) {
            EXPECT_LE(difference(answers[i], best[i]), 1e-6) << hwy::TargetName(left & -left);
        }
        ++targets;
    }
    EXPECT_GE(targets, 2) << "the plainest and what this processor adds";
}

INSTANTIATE_TEST_SUITE_P(Methods, Targets, ::testing::Values("exact", "ewa", "ewa-blended"));
