// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/stability/report_files.h"
#include "core/study/stability/scenes.h"
#include "core/study/stability/stability.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

namespace trixel {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr double kInf = std::numeric_limits<double>::infinity();

StabilitySweep sweepOf(std::vector<double> naive, std::vector<double> robust)
{
    StabilitySweep sweep{.name = "made-up",
                         .title = "Made up, <of two> & more",
                         .hazard = "Nothing.",
                         .property = "Something.",
                         .axisTitle = "x, in \"units\"",
                         .errorTitle = "error",
                         .bound = 1e-6};
    for (std::size_t k = 0; k < naive.size(); ++k) {
        sweep.values.push_back({static_cast<double>(k), std::to_string(k)});
    }
    sweep.curves = {{"textbook", true, std::move(naive)}, {"ours", false, std::move(robust)}};
    return sweep;
}

struct Watcher final : StabilityWatcher
{
    bool report(double fraction) override
    {
        monotone = monotone && fraction >= last;
        last = fraction;
        return static_cast<int>(names.size()) < stopAfter;
    }
    void swept(const StabilitySweep& sweep) override { names.push_back(sweep.name); }

    std::vector<std::string> names;
    double last = 0;
    bool monotone = true;
    int stopAfter = 1000;
};

FilterScene steppedScene()
{
    const TriangleMesh mesh = sweeps::fan(20);
    std::vector<Level> levels;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        levels.emplace_back(f % 2 == 0 ? 1 : 4);
    }
    return sweeps::sceneOf(mesh, levels, [](FaceId face, Level, TexelIndex texel) {
        return static_cast<float>((indexOf(face) * 7 + indexOf(texel) * 5) % 11) / 11.0F;
    });
}

TEST(StabilitySweep, holdsWhileOurFormsKeepTheBoundWhateverTheTextbooksDo)
{
    EXPECT_TRUE(sweepOf({kInf, 1}, {1e-7, 1e-6}).holds());
    EXPECT_FALSE(sweepOf({0, 0}, {1e-7, 2e-6}).holds());
    EXPECT_FALSE(sweepOf({0, 0}, {kInf, 0}).holds());
    const StabilitySweep sweep = sweepOf({1e-9, kInf, 1e-3}, {0, 0, 0});
    EXPECT_EQ(sweep.naiveFailures(), 2U);
    EXPECT_EQ(firstNaiveFailure(sweep)->label, "1");
    EXPECT_EQ(sweep.worst(true), kInf);
    EXPECT_FALSE(firstNaiveFailure(sweepOf({0}, {0})));
}

/// What the first of the tests that run all sweeps found, for the second to compare with.
std::vector<StabilitySweep>& sweepsOnce()
{
    static std::vector<StabilitySweep> sweeps;
    return sweeps;
}

TEST(Stability, everySweepIsWhole)
{
    std::set<std::string_view> names;
    for (const SweepEntry& entry : stabilitySweeps()) {
        const StabilitySweep sweep = entry.run();
        EXPECT_EQ(sweep.name, entry.name);
        EXPECT_TRUE(names.insert(entry.name).second);
        sweepsOnce().push_back(sweep);
        EXPECT_FALSE(sweep.title.empty() || sweep.hazard.empty() || sweep.property.empty());
        EXPECT_FALSE(sweep.axisTitle.empty() || sweep.errorTitle.empty());
        EXPECT_TRUE(std::ranges::any_of(sweep.curves, &StabilityCurve::naive));
        for (const StabilityCurve& curve : sweep.curves) {
            EXPECT_EQ(curve.errors.size(), sweep.values.size());
            // NaN is written as "no answer", which is infinite.
            EXPECT_FALSE(std::ranges::any_of(curve.errors, [](double e) { return e != e; }));
        }
    }
    EXPECT_GE(names.size(), 24U);
}

TEST(Stability, tellsOfEverySweepWhichComesOutTheSameAgainAndCanBeStopped)
{
    Watcher watcher;
    const auto report = runStability(nullptr, Threads{1}, watcher);
    ASSERT_TRUE(report);
    EXPECT_EQ(watcher.names.size(), stabilitySweeps().size());
    EXPECT_TRUE(watcher.monotone);
    EXPECT_TRUE(report->holds());
    if (!sweepsOnce().empty()) { // when run alone there is nothing to compare with
        EXPECT_EQ(report->sweeps.size(), sweepsOnce().size());
        for (std::size_t k = 0; k < report->sweeps.size(); ++k) {
            EXPECT_EQ(report->sweeps[k].curves, sweepsOnce()[k].curves);
        }
    }
    Watcher impatient;
    impatient.stopAfter = 3;
    const auto stopped = runStability(nullptr, Threads{1}, impatient);
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().kind, ErrorKind::Cancelled);
    EXPECT_EQ(impatient.names.size(), 3U);
}

TEST(FindHazards, countsWhatTheAssetHasAndNamesTheWorst)
{
    TriangleMesh mesh = sweeps::fan(20);
    mesh.positions[5] = mesh.positions[6] * 0.999F + mesh.positions[5] * 0.001F;
    const FilterScene scene = steppedScene();
    NoProgress progress;
    const StabilityAsset asset{"fan", scene, &mesh};
    const auto findings = findHazards(asset, Threads{1}, progress);
    ASSERT_TRUE(findings);
    ASSERT_EQ(findings->size(), 4U);
    const AssetFinding& needles = (*findings)[1];
    EXPECT_EQ(needles.count, 1U);
    EXPECT_EQ(needles.face, faceId(4));
    EXPECT_GT(needles.worst, 1000);
    const AssetFinding& valence = (*findings)[2];
    EXPECT_EQ(valence.count, 1U);
    EXPECT_EQ(valence.worst, 20);
    const AssetFinding& steps = (*findings)[3];
    EXPECT_EQ(steps.count, 20U);
    EXPECT_EQ(steps.worst, 3);
    for (const AssetFinding& finding : *findings) {
        EXPECT_TRUE(finding.holds()) << finding.name << ' ' << finding.error.value_or(0);
    }
    EXPECT_EQ((*findings)[0].count, 0U);
    EXPECT_FALSE((*findings)[0].error);
}

TEST(FindHazards, buildsTheSceneOfASurfaceItself)
{
    NoProgress progress;
    const auto surface = Surface::build(sweeps::fan(20), progress);
    ASSERT_TRUE(surface);
    const float grey = 0.5F;
    const TexelStore texels(20,
                            TexelFormat{TexelType::Float, 1, std::nullopt},
                            Level(2),
                            std::as_bytes(std::span(&grey, 1)));
    const StabilityAsset asset{"fan", **surface, &texels};
    const auto findings = findHazards(asset, Threads{1}, progress);
    ASSERT_TRUE(findings);
    ASSERT_EQ(findings->size(), 4U);
    EXPECT_EQ((*findings)[2].worst, 20);
    EXPECT_EQ((*findings)[2].error, 0);
    EXPECT_EQ((*findings)[3].count, 0U);
}

TEST(StabilityFiles, csvHasALineAForm)
{
    const StabilityReport report{"none", "", {sweepOf({1, kInf}, {0, 1e-7})}, {}};
    const std::string csv = toCsv(report);
    EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 2 * 2);
    EXPECT_THAT(csv, HasSubstr("made-up,\"x, in \"\"units\"\"\",1,1,textbook,naive,inf,1e-06,0"));
    EXPECT_THAT(csv, HasSubstr(",ours,robust,1e-07,1e-06,1"));
}

TEST(StabilityFiles, jsonReadsBackWithNullForNoAnswer)
{
    StabilityReport report{"none", "", {sweepOf({1, kInf}, {0, 1e-7})}, {}};
    report.findings.push_back({"asset-valence", "Vertices", 2, 17, faceId(3), 0.5, 1e-5});
    const auto json = nlohmann::json::parse(toJson(report));
    EXPECT_EQ(json["holds"], false);
    EXPECT_TRUE(json["sweeps"][0]["curves"][0]["errors"][1].is_null());
    EXPECT_EQ(json["sweeps"][0]["naiveFailures"], 2);
    EXPECT_EQ(json["findings"][0]["face"], 3);
    EXPECT_EQ(json["findings"][0]["holds"], false);
}

TEST(StabilityFiles, textNamesWhatBrokeAndWhereTheTextbookLeaves)
{
    const StabilityReport report{
        "none", "", {sweepOf({0, kInf}, {0, 1e-7}), sweepOf({0, 0}, {0, 1})}, {}};
    const std::string text = toText(report);
    EXPECT_THAT(text, HasSubstr("holds"));
    EXPECT_THAT(text, HasSubstr("BROKEN"));
    EXPECT_THAT(text, HasSubstr("beyond it at 1 of 2 values, first 1"));
}

TEST(StabilityFiles, svgEscapesAndHoldsNoNumberThatIsNone)
{
    const StabilityReport report{"a & b", "", {sweepOf({1, kInf}, {0, 1e-7})}, {}};
    const std::string svg = toSvg(report);
    EXPECT_TRUE(svg.starts_with("<svg "));
    EXPECT_TRUE(svg.ends_with("</svg>\n"));
    EXPECT_THAT(svg, HasSubstr("Made up, &lt;of two&gt; &amp; more"));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(svg, Not(HasSubstr("inf")));
    EXPECT_EQ(toSvg({}).find("inf"), std::string::npos);
}

} // namespace
} // namespace trixel
