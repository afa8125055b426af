// SPDX-License-Identifier: GPL-3.0-or-later
#include <QGuiApplication>

#include "tests/ui/charts/made_up_study.h"
#include "ui/charts/plot_layout.h"
#include "ui/charts/study_plot.h"

#include <gtest/gtest.h>

#include <random>

namespace trixel::ui {
namespace {

PlotFonts fonts()
{
    QFont font("DejaVu Sans");
    font.setPixelSize(13);
    return PlotFonts(font);
}

const QSizeF kSizes[] = {{310, 300}, {310, 600}, {480, 320}, {620, 260}, {960, 640}, {1800, 1000}};

std::vector<QRectF> markerBoxes(const Plot& plot, const PlotLayout& layout)
{
    std::vector<QRectF> boxes;
    for (const PlotSeries& series : plot.series) {
        for (const PlotPoint& point : series.points) {
            const QPointF at = layout.at(point);
            // A little smaller than drawn: the grid that the places come from is coarse.
            const double r = layout.markRadius - 0.5;
            boxes.emplace_back(at.x() - r, at.y() - r, 2 * r, 2 * r);
        }
    }
    return boxes;
}

TEST(PlotLayoutTest, namesCoverNeitherPointsNorEachOther)
{
    for (const auto& c : classesOf(madeUpStudy())) {
        const Plot plot = plotOf(madeUpStudy(), {.footprintClass = c, .tolerance = 0.01});
        for (const QSizeF& size : kSizes) {
            const PlotLayout layout = layOut(plot, size, fonts(), {});
            std::vector<QRectF> taken = markerBoxes(plot, layout);
            for (const PlacedLabel& label : layout.labels) {
                EXPECT_TRUE(layout.frame.contains(label.box));
                for (const QRectF& box : taken) {
                    EXPECT_FALSE(label.box.intersects(box)) << label.text.toStdString();
                }
                taken.push_back(label.box);
            }
        }
    }
}

TEST(PlotLayoutTest, mostCurvesAreNamedWhereThereIsRoom)
{
    const Plot plot = plotOf(madeUpStudy(), {});
    const PlotLayout layout = layOut(plot, {960, 640}, fonts(), {});
    const auto names = std::ranges::count(layout.labels, false, &PlacedLabel::isTag);
    EXPECT_GE(names, static_cast<std::ptrdiff_t>(plot.series.size()) - 1);
    EXPECT_GE(std::ranges::count(layout.labels, true, &PlacedLabel::isTag), 4);
}

TEST(PlotLayoutTest, everyPartLiesInsideAndApart)
{
    const Plot plot = plotOf(madeUpStudy(), {});
    for (const QSizeF& size : kSizes) {
        const PlotLayout layout = layOut(plot, size, fonts(), {});
        const QRectF whole(QPointF(), size);
        EXPECT_TRUE(whole.contains(layout.frame));
        EXPECT_GT(layout.frame.width(), size.width() * 0.4);
        EXPECT_GT(layout.frame.height(), 60);
        EXPECT_FALSE(layout.frame.intersects(layout.heading));
        EXPECT_FALSE(layout.frame.intersects(layout.note));
        for (std::size_t k = 0; k < layout.legend.size(); ++k) {
            const QRectF& box = layout.legend[k].box;
            EXPECT_TRUE(whole.contains(box)) << size.width() << " " << k;
            EXPECT_FALSE(layout.frame.intersects(box));
            for (std::size_t other = 0; other < k; ++other) {
                EXPECT_FALSE(box.intersects(layout.legend[other].box));
            }
        }
        for (const QRectF& box : markerBoxes(plot, layout)) {
            EXPECT_TRUE(layout.frame.contains(box));
        }
    }
}

TEST(PlotLayoutTest, legendNamesEverySeriesAndTheFront)
{
    const Plot plot = plotOf(madeUpStudy(), {});
    const PlotLayout layout = layOut(plot, {960, 640}, fonts(), {});
    EXPECT_EQ(layout.legend.size(), plot.series.size() + 1);
    EXPECT_EQ(legendSeriesAt(layout, layout.legend[3].box.center()), 3U);
    EXPECT_FALSE(legendSeriesAt(layout, layout.frame.center()).has_value());
}

TEST(PlotLayoutTest, thePointUnderThePointerIsTheNearest)
{
    const Plot plot = plotOf(madeUpStudy(), {});
    const PlotLayout layout = layOut(plot, {960, 640}, fonts(), {});
    for (std::size_t s = 0; s < plot.series.size(); ++s) {
        for (std::size_t p = 0; p < plot.series[s].points.size(); ++p) {
            const QPointF at = layout.at(plot.series[s].points[p]);
            const auto found = markAt(plot, layout, at, 8);
            ASSERT_TRUE(found.has_value());
            EXPECT_EQ(layout.at(pointOf(plot, *found)), at);
        }
    }
    EXPECT_FALSE(markAt(plot, layout, layout.frame.bottomLeft() + QPointF(20, -20), 8));
}

TEST(PlotLayoutTest, nothingLiesBelowTheFrontLine)
{
    const Plot plot = plotOf(madeUpStudy(), {});
    const PlotLayout layout = layOut(plot, {960, 640}, fonts(), {});
    QPolygonF below = frontLine(plot, layout);
    ASSERT_GT(below.size(), 8);
    below += layout.frame.bottomRight();
    below += layout.frame.bottomLeft();
    below += layout.frame.topLeft();
    for (const PlotSeries& series : plot.series) {
        for (const PlotPoint& point : series.points) {
            if (!point.onFront) {
                EXPECT_FALSE(below.containsPoint(layout.at(point), Qt::WindingFill));
            }
        }
    }
}

TEST(PlotLayoutTest, emptyAndTinyPlotsAreLaidOut)
{
    for (const QSizeF& size : {QSizeF(0, 0), QSizeF(1, 1), QSizeF(40, 40), QSizeF(400, 300)}) {
        const PlotLayout empty = layOut(Plot(), size, fonts(), {});
        EXPECT_TRUE(empty.legend.empty());
        layOut(plotOf(madeUpStudy(), {.tolerance = 0.01}), size, fonts(), {});
    }
}

} // namespace
} // namespace trixel::ui

int main(int argc, char** argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QGuiApplication application(argc, argv); // fonts need one
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
