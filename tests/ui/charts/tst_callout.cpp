// SPDX-License-Identifier: GPL-3.0-or-later
#include <QGuiApplication>

#include "tests/ui/charts/made_up_study.h"
#include "ui/charts/callout.h"
#include "ui/charts/study_plot.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace trixel::ui {
namespace {

const QStringList kLines = {
    "Gaussian probes", "135 ns · RMS 0.743 %", "3,000 samples", "Click to filter with it"};
constexpr QSizeF kSize(700, 300);

PlotFonts fonts()
{
    QFont font("DejaVu Sans");
    font.setPixelSize(13);
    return PlotFonts(font);
}

std::vector<QPointF> positions(const Plot& plot, const PlotLayout& layout)
{
    std::vector<QPointF> all;
    for (const PlotSeries& series : plot.series) {
        for (const PlotPoint& point : series.points) {
            all.push_back(layout.at(point));
        }
    }
    return all;
}

std::ptrdiff_t covered(const QRectF& card, const std::vector<QPointF>& points)
{
    return std::ranges::count_if(points, [&](const QPointF& p) { return card.contains(p); });
}

/// Points of equal looks where told, in the units of the axes.
Plot plotWith(const std::vector<QPointF>& places)
{
    Plot plot;
    plot.x.title = "x";
    plot.y.title = "y";
    PlotSeries series{"series", 0, false, {}};
    for (const QPointF& place : places) {
        series.points.push_back({place.x(), place.y(), series.points.size(), QString(), false});
    }
    plot.series.push_back(std::move(series));
    return plot;
}

TEST(CalloutTest, coversNeitherItsPointNorMoreOthersThanAnotherCornerWould)
{
    const Plot plot = plotOf(madeUpStudy(), {});
    const PlotLayout layout = layOut(plot, kSize, fonts(), {});
    const std::vector<QPointF> points = positions(plot, layout);
    const QRectF whole({0, 0}, kSize);
    for (const QPointF& at : points) {
        const QRectF card = calloutBox(kLines, fonts(), at, plot, layout);
        EXPECT_TRUE(whole.contains(card));
        EXPECT_FALSE(card.contains(at));
        constexpr double kAway = 14;
        for (const double x : {at.x() + kAway, at.x() - kAway - card.width()}) {
            for (const double y : {at.y() + kAway, at.y() - kAway - card.height()}) {
                const QRectF corner({x, y}, card.size());
                if (whole.contains(corner)) {
                    // Markers have a size: one that a card only touches may count there.
                    const double r = layout.markRadius;
                    EXPECT_LE(covered(card, points),
                              covered(corner.adjusted(-r, -r, r, r), points));
                }
            }
        }
    }
}

TEST(CalloutTest, turnsAwayFromTheCrowd)
{
    // A crowd at the upper right of the point in the middle, where a card stands else.
    std::vector<QPointF> places = {{1, 1}, {0.01, 0.01}, {100, 100}};
    Plot plot = plotWith(places);
    PlotLayout layout = layOut(plot, kSize, fonts(), {});
    const QPointF alone = layout.at(plot.series[0].points[0]);
    const QRectF first = calloutBox(kLines, fonts(), alone, plot, layout);
    EXPECT_GT(first.left(), alone.x());
    EXPECT_LT(first.bottom(), alone.y());

    for (double k = 1.5; k < 80; k *= 1.2) {
        places.emplace_back(k, 10);
        places.emplace_back(k, k);
    }
    plot = plotWith(places);
    layout = layOut(plot, kSize, fonts(), {});
    const std::vector<QPointF> points = positions(plot, layout);
    const QRectF card = calloutBox(kLines, fonts(), points[0], plot, layout);
    EXPECT_EQ(covered(card, points), 0);
    EXPECT_GT(covered(first, points), 3);
}

TEST(CalloutTest, staysInsideAPlotThatIsHardlyLarger)
{
    const Plot plot = plotWith({{1, 1}, {2, 2}});
    const QSizeF card =
        calloutBox(kLines, fonts(), {}, plot, layOut(plot, kSize, fonts(), {})).size();
    const QSizeF tight = card + QSizeF(4, 4);
    const PlotLayout layout = layOut(plot, tight, fonts(), {});
    for (const QPointF& at :
         {QPointF(0, 0), QPointF(60, 30), QPointF(tight.width(), tight.height())}) {
        EXPECT_TRUE(QRectF({0, 0}, tight).contains(calloutBox(kLines, fonts(), at, plot, layout)));
    }
}

} // namespace
} // namespace trixel::ui

int main(int argc, char** argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen"); // fonts need an application, not a display
    QGuiApplication application(argc, argv);
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
