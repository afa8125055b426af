// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs without a display and without an application, as the command line does.
#include <QCoreApplication>
#include <QImage>
#include <QPainter>
#include <QSvgRenderer>
#include <QTemporaryDir>
#include <QXmlStreamReader>

#include "core/base/read_file.h"
#include "tests/ui/charts/made_up_study.h"
#include "ui/charts/write_chart.h"

#include <gtest/gtest.h>

#include <set>

namespace trixel::ui {
namespace {

class WriteChartTest : public testing::Test
{
protected:
    std::filesystem::path path(const std::string& name) const
    {
        return std::filesystem::path(m_folder.path().toStdString()) / name;
    }
    QString text(const std::string& name) const
    {
        return QString::fromStdString(readFile(path(name)).value());
    }

    QTemporaryDir m_folder;
};

/// Share of pixels that differ visibly.
double difference(const QImage& a, const QImage& b)
{
    int differing = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            differing += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))) > 60 ? 1 : 0;
        }
    }
    return static_cast<double>(differing) / (a.width() * a.height());
}

int colorsIn(const QImage& image)
{
    std::set<QRgb> colors;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            colors.insert(image.pixel(x, y));
        }
    }
    return static_cast<int>(colors.size());
}

TEST_F(WriteChartTest, pngIsAsLargeAndAsSharpAsAsked)
{
    ASSERT_EQ(QCoreApplication::instance(), nullptr);
    ASSERT_TRUE(writeChart(madeUpStudy(), path("chart.png")).has_value());
    const QImage picture(QString::fromStdString(path("chart.png").string()));
    EXPECT_EQ(picture.size(), QSize(1920, 1280));
    EXPECT_EQ(picture.pixelColor(2, 2), QColor(Qt::white));
    EXPECT_GT(colorsIn(picture), 100);

    ASSERT_TRUE(writeChart(madeUpStudy(),
                           path("dark.PNG"),
                           {.size = {500, 400}, .pixelsPerUnit = 1, .dark = true})
                    .has_value());
    const QImage dark(QString::fromStdString(path("dark.PNG").string()));
    EXPECT_EQ(dark.size(), QSize(500, 400));
    EXPECT_LT(dark.pixelColor(2, 2).lightness(), 60);
}

TEST_F(WriteChartTest, svgShowsTheSamePictureWithoutNeedingFonts)
{
    ASSERT_TRUE(writeChart(madeUpStudy(), path("chart.svg")).has_value());
    ASSERT_TRUE(writeChart(madeUpStudy(), path("chart.png"), {.pixelsPerUnit = 1}).has_value());
    const QString svg = text("chart.svg");
    EXPECT_FALSE(svg.contains("<text"));
    EXPECT_TRUE(svg.contains("<title>Cost of a filtered sample against its error</title>"));
    EXPECT_TRUE(svg.contains("a machine that does not exist"));
    QXmlStreamReader xml(svg);
    while (!xml.atEnd()) {
        xml.readNext();
    }
    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();

    QSvgRenderer renderer(QString::fromStdString(path("chart.svg").string()));
    ASSERT_TRUE(renderer.isValid());
    EXPECT_TRUE(svg.contains("width=\"254mm\"")); // 10 inches
    EXPECT_EQ(renderer.viewBox(), QRect(0, 0, 960, 640));
    QImage drawn(960, 640, QImage::Format_RGB32);
    drawn.fill(Qt::white);
    QPainter painter(&drawn);
    renderer.render(&painter);
    painter.end();
    const QImage picture(QString::fromStdString(path("chart.png").string()));
    EXPECT_LT(difference(drawn, picture), 0.01);
    EXPECT_GT(colorsIn(drawn), 100);
}

TEST_F(WriteChartTest, csvAndJsonHoldThePoints)
{
    const Study study = madeUpStudy();
    ASSERT_TRUE(writeChart(study, path("points.csv")).has_value());
    ASSERT_TRUE(writeChart(study, path("points.json")).has_value());
    EXPECT_EQ(text("points.csv").toStdString(), toCsv(study));
    EXPECT_EQ(text("points.json").toStdString(), toJson(study));
}

TEST_F(WriteChartTest, theClassShownIsTheOneAsked)
{
    const Study study = madeUpStudy();
    ChartOptions options;
    options.view.footprintClass = FootprintClass::LargeGrazing;
    ASSERT_TRUE(writeChart(study, path("all.svg")).has_value());
    ASSERT_TRUE(writeChart(study, path("grazing.svg"), options).has_value());
    EXPECT_NE(text("all.svg"), text("grazing.svg"));
    EXPECT_TRUE(text("grazing.svg").contains("Large grazing"));

    options.view.footprintClass = FootprintClass::SmallGrazing;
    const Status refused = writeChart(study, path("none.svg"), options);
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().kind, ErrorKind::Contents);
    EXPECT_NE(refused.error().message.find("small grazing"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(path("none.svg")));
}

TEST_F(WriteChartTest, refusalsNameTheFileAndTheCause)
{
    const Status ending = writeChart(madeUpStudy(), path("chart.jpg"));
    ASSERT_FALSE(ending.has_value());
    EXPECT_NE(ending.error().message.find("chart.jpg"), std::string::npos);
    EXPECT_NE(ending.error().message.find(".svg"), std::string::npos);

    const Status folder = writeChart(madeUpStudy(), path("no/such/folder.png"));
    ASSERT_FALSE(folder.has_value());
    EXPECT_EQ(folder.error().kind, ErrorKind::Path);

    for (const double scale : {0.0, -1.0, 1e9, std::nan("")}) {
        EXPECT_FALSE(writeChart(madeUpStudy(), path("huge.png"), {.pixelsPerUnit = scale}));
    }
    EXPECT_FALSE(writeChart(Study{}, path("empty.svg")).has_value());
}

} // namespace
} // namespace trixel::ui
