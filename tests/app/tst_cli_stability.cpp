// SPDX-License-Identifier: GPL-3.0-or-later
//
// trixel study stability.
#include "tests/app/cli_test.h"

namespace trixel::test {
namespace {

using testing::HasSubstr;

using Stability = CommandLine;

TEST_F(Stability, writesTableReportAndSheetAndPrintsALineAHazard)
{
    const ProgramRun run = runTrixel({"study", "stability", "-o", path("out")});
    EXPECT_THAT(run, EndsWith(0));
    EXPECT_THAT(run.out, HasSubstr("parallel-vectors  holds"));
    EXPECT_THAT(run.out, HasSubstr("level-step"));
    EXPECT_THAT(contentsOf(path("out/stability.csv")), HasSubstr("sweep,axis,value"));
    EXPECT_THAT(contentsOf(path("out/stability.svg")), HasSubstr("</svg>"));
    const auto json = jsonOf(contentsOf(path("out/stability.json")));
    EXPECT_EQ(json["holds"], true);
    EXPECT_GE(json["sweeps"].size(), 24U);
    EXPECT_TRUE(json["findings"].empty());
}

TEST_F(Stability, looksAtTheFacesOfAnAsset)
{
    const std::string needle = write("needle.obj",
                                     "v 0 0 0\nv 1 0 0\nv 0.5 1e-4 0\nv 0.5 -1 0\nv 0.5 1 0\n"
                                     "f 1 2 3\nf 1 4 2\nf 3 2 5\nf 1 3 5\nf 1 1 4\n");
    const ProgramRun run = runTrixel({"study", "stability", needle, "-o", path("out")});
    EXPECT_THAT(run, EndsWith(0));
    EXPECT_THAT(run.out, HasSubstr("On the faces of needle.obj"));
    const auto findings = jsonOf(contentsOf(path("out/stability.json")))["findings"];
    ASSERT_EQ(findings.size(), 4U);
    EXPECT_EQ(findings[0]["count"], 1);
    EXPECT_EQ(findings[0]["face"], 4);
    EXPECT_EQ(findings[1]["count"], 1);
    EXPECT_EQ(findings[1]["face"], 0);
}

TEST_F(Stability, refusesWhatItCannotReadOrWriteInOneSentence)
{
    EXPECT_THAT(runTrixel({"study", "stability"}), FailsWith(2, "--output"));
    EXPECT_THAT(runTrixel({"study", "stability", path("none.obj"), "-o", path("out")}),
                FailsWith(3, "none.obj"));
    EXPECT_THAT(runTrixel({"study", "stability", "-o", "/proc/nowhere/out"}),
                FailsWith(3, "/proc/nowhere/out"));
}

} // namespace
} // namespace trixel::test
