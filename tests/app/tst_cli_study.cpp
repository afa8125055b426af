// SPDX-License-Identifier: GPL-3.0-or-later
//
// trixel study: tables, charts and the choice of methods.
#include "tests/app/cli_test.h"

#include <cstdlib>

namespace trixel::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

class CliStudy : public CommandLine
{
protected:
    std::string painted() const
    {
        const std::string to = path("painted.trixel");
        EXPECT_THAT(runTrixel({"paint", project(), "--strokes", strokes(), "-o", to}), EndsWith(0));
        return to;
    }

    /// What the study wrote into the folder "out".
    std::vector<std::string> written() const
    {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(path("out"))) {
            names.push_back(entry.path().filename().string());
        }
        std::sort(names.begin(), names.end());
        return names;
    }

    static std::vector<std::string> filesOf(const std::string& name)
    {
        std::vector<std::string> names = {name + ".csv", name + ".json"};
        if (TRIXEL_HAS_TOUR) { // built with the window, which draws
            names.push_back(name + ".png");
            names.push_back(name + ".svg");
        }
        return names;
    }
};

TEST_F(CliStudy, speedAccuracyMeasuresEveryMethodOnTheUsersAsset)
{
    const ProgramRun run = runTrixel({"study",
                                      "speed-accuracy",
                                      painted(),
                                      "-o",
                                      path("out"),
                                      "--samples",
                                      "40",
                                      "--rounds",
                                      "1"});
    EXPECT_THAT(run, EndsWith(0));
    EXPECT_EQ(written(), filesOf("speed-accuracy"));
    const auto study = jsonOf(contentsOf(path("out/speed-accuracy.json")));
    EXPECT_EQ(study["study"], "speed-accuracy");
    EXPECT_THAT(study["subject"].get<std::string>(), HasSubstr("painted.trixel"));
    std::map<std::string, int> series;
    for (const auto& point : study["points"]) {
        ++series[point["series"].get<std::string>()];
        EXPECT_GT(point["cost"].get<double>(), 0);
        EXPECT_GE(point["worst"].get<double>(), point["rms"].get<double>());
    }
    for (const char* name : {"point",
                             "trilinear",
                             "probes-1",
                             "probes-2",
                             "ewa",
                             "reference-loop",
                             "exact",
                             "OpenImageIO",
                             "auto"}) {
        EXPECT_GT(series[name], 0) << name;
    }
    // As many lines as points, and the header.
    const std::string csv = contentsOf(path("out/speed-accuracy.csv"));
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'),
              static_cast<std::ptrdiff_t>(study["points"].size()) + 1);
}

TEST_F(CliStudy, theSameSeedGivesTheSameErrors)
{
    const std::string project = painted();
    const auto errorsOf = [&](const char* seed) {
        EXPECT_THAT(runTrixel({"study",
                               "speed-accuracy",
                               project,
                               "-o",
                               path("out"),
                               "--samples",
                               "10",
                               "--rounds",
                               "1",
                               "--seed",
                               seed}),
                    EndsWith(0));
        std::vector<double> errors;
        const auto study = jsonOf(contentsOf(path("out/speed-accuracy.json")));
        for (const auto& point : study["points"]) {
            if (point["series"] == "trilinear") {
                errors.push_back(point["rms"].get<double>());
            }
        }
        return errors;
    };
    const auto first = errorsOf("7");
    EXPECT_FALSE(first.empty());
    EXPECT_EQ(errorsOf("7"), first);
    EXPECT_NE(errorsOf("8"), first);
}

TEST_F(CliStudy, theOtherStudiesNeedNoFile)
{
    for (const std::string name : {"paint-projection", "reduction", "storage", "subdivision"}) {
        std::filesystem::remove_all(path("out"));
        const ProgramRun run = runTrixel({"study", name, "-o", path("out")});
        EXPECT_THAT(run, EndsWith(0)) << name;
        EXPECT_EQ(written(), filesOf(name));
        EXPECT_EQ(jsonOf(contentsOf(path("out/" + name + ".json")))["study"], name);
    }
}

TEST_F(CliStudy, subdivisionTakesTheUsersCage)
{
    const ProgramRun run = runTrixel({"study", "subdivision", mesh(), "-o", path("out")});
    EXPECT_THAT(run, EndsWith(0));
    EXPECT_THAT(run.out, HasSubstr("4 faces"));
    EXPECT_THAT(runTrixel({"study", "subdivision", path("none.obj"), "-o", path("out")}),
                FailsWith(3, "none.obj"));
}

TEST_F(CliStudy, autoMeasuresOnceAndThenRemembers)
{
    setenv("XDG_CACHE_HOME", path("cache").c_str(), 1);
    const ProgramRun first = runTrixel({"study", "auto", "--tolerance", "0.02"});
    EXPECT_THAT(first, EndsWith(0));
    EXPECT_THAT(first.out, HasSubstr("measured now: there was none"));
    const ProgramRun second = runTrixel({"study", "auto", "--tolerance", "0.02", "--json"});
    EXPECT_THAT(second, EndsWith(0));
    const auto choices = jsonOf(second.out);
    EXPECT_EQ(choices["classes"].size(), 9U);
    for (const auto& entry : choices["classes"]) {
        EXPECT_LE(entry["rms"].get<double>(), 0.02);
        EXPECT_THAT(first.out, HasSubstr(entry["method"].get<std::string>()));
    }
    EXPECT_THAT(runTrixel({"study", "auto", "--tolerance", "1e-12"}),
                FailsWith(2, "No method has an RMS error within 1e-12"));
    EXPECT_THAT(runTrixel({"study", "auto", "--tolerance", "-1"}), FailsWith(2, "--tolerance"));
    unsetenv("XDG_CACHE_HOME");
}

TEST_F(CliStudy, saysWhatIsMissingOrCannotBe)
{
    EXPECT_THAT(runTrixel({"study"}), FailsWith(2, "trixel study"));
    EXPECT_THAT(runTrixel({"study", "everything"}), FailsWith(2, "study"));
    EXPECT_THAT(runTrixel({"study", "reduction"}), FailsWith(2, "--output"));
    EXPECT_THAT(runTrixel({"study", "speed-accuracy", "-o", path("out"), "--samples", "none"}),
                FailsWith(2, "--samples"));
    EXPECT_THAT(runTrixel({"study", "speed-accuracy", "-o", path("out"), "--faces", "huge"}),
                FailsWith(2, "--faces: expected small or large, found 'huge'"));
    EXPECT_THAT(runTrixel({"study", "speed-accuracy", path("none.trixel"), "-o", path("out")}),
                FailsWith(3, "none.trixel"));
    EXPECT_THAT(runTrixel({"study", "speed-accuracy", mesh(), "--mesh", mesh(), "-o", path("out")}),
                FailsWith(2, "--mesh"));
    const std::string file = write("file", "in the way");
    const ProgramRun run = runTrixel({"study", "reduction", "-o", file});
    EXPECT_EQ(run.status, 3);
    EXPECT_THAT(run.err, IsOneLine());
}

} // namespace
} // namespace trixel::test
