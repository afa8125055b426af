// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_reader.h"
#include "tests/core/filter/golden_queries.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace trixel;
using namespace trixel::test;

TEST(Exact, agreesWithTheGoldenColumns)
{
    const FilterScene scene = goldenScene();
    const GoldenQueries golden = goldenQueries();
    ASSERT_EQ(golden.queries.size(), 600U);
    const auto answers = ask(*makeMethod({"exact", std::nullopt}), scene, golden.queries);
    double worst = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double error = std::abs(answers[i].value[c] - golden.exact[i][c]);
            EXPECT_LE(error, 1e-5) << "query " << i << " channel " << c;
            worst = std::max(worst, error);
        }
    }
    RecordProperty("worst", std::to_string(worst));
}
