// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/charts/made_up_study.h"
#include "ui/charts/plot_theme.h"
#include "ui/charts/study_plot.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <set>

namespace trixel::ui {
namespace {

const PlotSeries* seriesNamed(const Plot& plot, const QString& name)
{
    const auto found = std::ranges::find(plot.series, name, &PlotSeries::name);
    return found != plot.series.end() ? &*found : nullptr;
}

std::size_t pointCount(const Plot& plot)
{
    std::size_t count = 0;
    for (const PlotSeries& series : plot.series) {
        count += series.points.size();
    }
    return count;
}

TEST(StudyPlotTest, curvesKeepTheOrderOfTheirParameter)
{
    const Plot plot = plotOf(madeUpStudy(), {});
    const PlotSeries* probes = seriesNamed(plot, "probes-2");
    ASSERT_NE(probes, nullptr);
    ASSERT_EQ(probes->points.size(), 8U);
    EXPECT_EQ(probes->points.front().tag, "1");
    EXPECT_EQ(probes->points.back().tag, "128");
    EXPECT_TRUE(std::ranges::is_sorted(probes->points, {}, &PlotPoint::x));
}

TEST(StudyPlotTest, onlyTheChosenClassIsShown)
{
    const Study study = madeUpStudy();
    std::size_t shown = 0;
    for (const auto& c : classesOf(study)) {
        const Plot plot = plotOf(study, {.footprintClass = c});
        EXPECT_GT(pointCount(plot), 20U);
        shown += pointCount(plot);
        for (const PlotSeries& series : plot.series) {
            for (const PlotPoint& point : series.points) {
                EXPECT_EQ(study.points[point.source].footprintClass, c);
            }
        }
    }
    EXPECT_EQ(shown, study.points.size());
    EXPECT_EQ(classesOf(study).size(), 4U);
    EXPECT_FALSE(classesOf(study).front().has_value());
    EXPECT_TRUE(plotOf(study, {.footprintClass = FootprintClass::SmallGrazing}).isEmpty());
}

TEST(StudyPlotTest, theMeasureDecidesTheHeight)
{
    const Study study = madeUpStudy();
    const Plot rms = plotOf(study, {});
    const Plot p99 = plotOf(study, {.measure = ErrorMeasure::P99});
    const PlotPoint& a = seriesNamed(rms, "trilinear")->points.front();
    const PlotPoint& b = seriesNamed(p99, "trilinear")->points.front();
    EXPECT_EQ(a.y, study.points[a.source].rms);
    EXPECT_EQ(b.y, study.points[b.source].p99);
    EXPECT_NE(rms.y.title, p99.y.title);
}

TEST(StudyPlotTest, theDrawnFrontIsTheMarkedOne)
{
    Study study = madeUpStudy();
    std::mt19937 random(3);
    std::uniform_int_distribution<int> small(0, 12); // many ties
    for (int k = 0; k < 200; ++k) {
        study.points.push_back(
            madeUpPoint("ewa", k + 1, 10 + 50.0 * small(random), 0.002 + 0.01 * small(random)));
    }
    markFront(study.points);
    const Plot plot = plotOf(study, {});
    std::size_t onFront = 0;
    for (const PlotSeries& series : plot.series) {
        for (const PlotPoint& point : series.points) {
            EXPECT_EQ(point.onFront, study.points[point.source].onFront);
            onFront += point.onFront ? 1 : 0;
        }
    }
    EXPECT_EQ(frontOf(plot).size(), onFront);
    EXPECT_GT(onFront, 2U);
}

TEST(StudyPlotTest, seriesWithoutAMethodArePeersUnlessAllAre)
{
    const Plot plot = plotOf(madeUpStudy(), {});
    EXPECT_TRUE(seriesNamed(plot, "OpenImageIO")->isPeer);
    EXPECT_FALSE(seriesNamed(plot, "probes-1")->isPeer);

    Study storage;
    storage.points = {madeUpPeer("uint8", 3, 0.004), madeUpPeer("half", 6, 0.0002)};
    for (const PlotSeries& series : plotOf(storage, {}).series) {
        EXPECT_FALSE(series.isPeer);
    }
}

TEST(StudyPlotTest, whatIsNoNumberIsLeftOut)
{
    Study study = madeUpStudy();
    const std::size_t before = pointCount(plotOf(study, {}));
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity(),
                             -1.0}) {
        study.points.push_back(madeUpPoint("ewa", 5, bad, 0.1));
        study.points.push_back(madeUpPoint("ewa", 5, 10, bad));
    }
    EXPECT_EQ(pointCount(plotOf(study, {})), before);
}

TEST(StudyPlotTest, aMethodWithoutItsParameterIsItsStandardPoint)
{
    Study study;
    study.points = {madeUpPoint("point", 0, 5, 0.3)};
    const Plot plot = plotOf(study, {});
    EXPECT_EQ(markOf(study, plot, {"point", std::nullopt}), (PlotMark{0, 0}));
    EXPECT_FALSE(markOf(study, plot, {"exact", std::nullopt}).has_value());
}

TEST(StudyPlotTest, descriptionNamesAllThatWasMeasured)
{
    const Study study = madeUpStudy();
    const auto found = std::ranges::find_if(
        study.points, [](const StudyPoint& p) { return p.variant == "probes 16"; });
    const auto index = static_cast<std::size_t>(found - study.points.begin());
    const QString all = describe(study, index).join('\n').replace(QChar(0x00A0), ' ');
    for (const char* part : {"Equal probes",
                             "probes 16",
                             "520 ns",
                             "2.78 %",
                             "12.8 %",
                             "58.3 %",
                             "3,000 samples",
                             "all footprints"}) {
        EXPECT_TRUE(all.contains(part)) << part << " in " << all.toStdString();
    }
}

TEST(PlotThemeTest, noTwoLooksAreEqualAndAllCanBeSeen)
{
    for (const PlotTheme& theme : {lightPlotTheme(), darkPlotTheme()}) {
        std::set<std::pair<QRgb, std::vector<double>>> looks;
        for (int look = 0; look < 63; ++look) {
            std::vector<double> outline;
            const QPainterPath shape = shapeOf(look);
            for (int k = 0; k < shape.elementCount(); ++k) {
                outline.push_back(shape.elementAt(k).x);
                outline.push_back(shape.elementAt(k).y);
            }
            looks.insert({colorOf(look, theme).rgb(), outline});
        }
        EXPECT_EQ(looks.size(), 63U);
    }
}

} // namespace
} // namespace trixel::ui
