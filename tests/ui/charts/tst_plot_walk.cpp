// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/charts/made_up_study.h"
#include "ui/charts/plot_walk.h"
#include "ui/charts/study_plot.h"

#include <gtest/gtest.h>

#include <set>

namespace trixel::ui {
namespace {

std::size_t seriesNamed(const Plot& plot, const QString& name)
{
    const auto found = std::ranges::find(plot.series, name, &PlotSeries::name);
    return static_cast<std::size_t>(found - plot.series.begin());
}

TEST(PlotWalkTest, fromNowhereEveryStepLeadsToTheFrontsStart)
{
    const Plot plot = plotOf(madeUpStudy(), {});
    for (const PlotStep one : {PlotStep::NextOnCurve, PlotStep::LastCurve, PlotStep::FrontStart}) {
        const auto mark = step(plot, std::nullopt, one);
        ASSERT_TRUE(mark.has_value());
        EXPECT_EQ(plot.series[mark->series].name, "point");
    }
}

TEST(PlotWalkTest, alongACurveFromEndToEndAndNoFurther)
{
    const Plot plot = plotOf(madeUpStudy(), {});
    const std::size_t s = seriesNamed(plot, "probes-2");
    std::optional<PlotMark> at = PlotMark{s, 0};
    for (std::size_t p = 1; p < 12; ++p) {
        at = step(plot, at, PlotStep::NextOnCurve);
        EXPECT_EQ(at, (PlotMark{s, std::min<std::size_t>(p, 7)}));
    }
    for (int k = 0; k < 12; ++k) {
        at = step(plot, at, PlotStep::LastOnCurve);
    }
    EXPECT_EQ(at, (PlotMark{s, 0}));
}

TEST(PlotWalkTest, curvesGoRoundAndBack)
{
    const Plot plot = plotOf(madeUpStudy(), {});
    std::optional<PlotMark> at = PlotMark{0, 0};
    std::set<std::size_t> visited;
    for (std::size_t k = 0; k < plot.series.size(); ++k) {
        const auto next = step(plot, at, PlotStep::NextCurve);
        EXPECT_EQ(step(plot, next, PlotStep::LastCurve)->series, at->series);
        at = next;
        visited.insert(at->series);
    }
    EXPECT_EQ(visited.size(), plot.series.size());
    EXPECT_EQ(at->series, 0U);
}

TEST(PlotWalkTest, alongTheFrontThroughAllOfIt)
{
    const Plot plot = plotOf(madeUpStudy(), {});
    const std::vector<PlotMark> front = frontOf(plot);
    std::optional<PlotMark> at = step(plot, std::nullopt, PlotStep::FrontStart);
    for (std::size_t k = 1; k < front.size(); ++k) {
        at = step(plot, at, PlotStep::NextOnFront);
        EXPECT_EQ(at, front[k]);
    }
    EXPECT_EQ(step(plot, at, PlotStep::NextOnFront), front.back());
    EXPECT_EQ(step(plot, front[0], PlotStep::FrontEnd), front.back());
    const PlotMark aside{seriesNamed(plot, "stochastic"), 0};
    EXPECT_TRUE(pointOf(plot, *step(plot, aside, PlotStep::LastOnFront)).onFront);
}

TEST(PlotWalkTest, anEmptyPlotLeadsNowhere)
{
    EXPECT_FALSE(step(Plot(), std::nullopt, PlotStep::NextCurve).has_value());
    EXPECT_FALSE(step(Plot(), std::nullopt, PlotStep::FrontEnd).has_value());
}

} // namespace
} // namespace trixel::ui
