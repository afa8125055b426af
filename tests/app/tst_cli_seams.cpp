// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli_test.h"

#include <algorithm>

namespace trixel::test {
namespace {

using CliSeams = CommandLine;

TEST_F(CliSeams, comparesAllMethods)
{
    ASSERT_THAT(runTrixel({"study", "seams", mesh(), "-o", path("out")}), EndsWith(0));
    const auto report = jsonOf(contentsOf(path("out/seams.json")));
    ASSERT_TRUE(report.is_object());
    EXPECT_GE(report["methods"].size(), 10U);
    for (const auto& row : report["methods"]) {
        EXPECT_EQ(row["edges"], 6);
        if (row["method"] == "point") {
            EXPECT_GT(row["worst"], 0.05);
        }
        if (row["method"] == "lattice-linear") {
            EXPECT_LE(row["worst"], 1e-5);
            EXPECT_EQ(row["broken"], 0);
        }
    }
}

TEST_F(CliSeams, oneMethodGetsATableOfEveryEdge)
{
    ASSERT_THAT(runTrixel({"study", "seams", mesh(), "-o", path("out"), "--method", "probes-1:4"}),
                EndsWith(0));
    const std::string table = contentsOf(path("out/seams-probes-1-4.csv"));
    EXPECT_EQ(std::ranges::count(table, '\n'), 7);
    EXPECT_TRUE(table.starts_with("face,edge,neighbour,neighbour_edge,level,"));
}

TEST_F(CliSeams, refusesWhatIsNoMethod)
{
    EXPECT_THAT(runTrixel({"study", "seams", mesh(), "-o", path("out"), "--method", "best"}),
                FailsWith(2, "no filter method 'best'"));
    EXPECT_FALSE(std::filesystem::exists(path("out")));
}

} // namespace
} // namespace trixel::test
