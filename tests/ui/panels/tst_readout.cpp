// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTreeWidget>

#include "tests/ui/fixtures.h"
#include "ui/docks/readout_panel.h"
#include "ui/docks/readout_text.h"
#include "ui/docks/report_panel.h"
#include "ui/document/document.h"

#include <limits>

namespace trixel::ui {

namespace {

HoveredTexel upperTexel()
{
    HoveredTexel texel;
    texel.point = {FaceId{7}, {0.25F, 0.5F}, {0.1F, 0.2F, 0.3F}};
    texel.level = Level(3);
    texel.texel = {3, 1, TexelHalf::Upper};
    texel.pixel = packedPixel(texel.level, texel.texel);
    texel.index = texelIndex(texel.level, texel.texel);
    texel.values = {200.0F / 255.0F, 0.0F, 1.0F};
    texel.footprint = {{0.01, 0.002}, {-0.003, 0.02}};
    texel.ellipse.majorLength = 0.02;
    texel.ellipse.minorLength = 0.01;
    return texel;
}

} // namespace

class ReadoutTest : public QObject
{
    Q_OBJECT

private slots:
    void everyNumberOfTheTexelIsShown()
    {
        Document document;
        document.open(gridProject(), {}, "grid");
        ReadoutPanel panel(document);
        panel.show(upperTexel());
        const QString text = panel.text();
        for (const char* expected : {"Face: 7\n",
                                     "Level: 3 · 8 × 8",
                                     "(3, 1) upper",
                                     "pixel 6, 4 · index 38",
                                     "0.25000  0.50000  0.25000",
                                     "Values: 200  0  255",
                                     "#c800ff · 200 0 255",
                                     "W1: 0.01, 0.002",
                                     "W2: -0.003, 0.02",
                                     "0.02 × 0.01  (2 : 1)"}) {
            QVERIFY2(text.contains(expected), qPrintable(QString(expected) + " in\n" + text));
        }
    }

    void whatFiltersMakeOfThePixelIsShown()
    {
        Document document;
        document.open(gridProject(), {}, "grid");
        ReadoutPanel panel(document);
        panel.show(upperTexel());
        FilteredTexel filtered;
        filtered.method = {"probes-2", std::nullopt};
        filtered.values = {0.5F, 0.0F, 1.0F};
        filtered.level = 2;
        filtered.taps = 24;
        panel.showFiltered(filtered);
        QVERIFY2(panel.text().contains("Filtered: 127.50  0.00  255.00"), qPrintable(panel.text()));
        QVERIFY(panel.text().contains("Read at: level 2.00 · 24 taps"));
        QVERIFY(panel.text().contains("Exact: …"));
        filtered.exact = {0.5F, 0.02F, 1.0F};
        filtered.difference = 0.02;
        panel.showFiltered(filtered);
        QVERIFY(panel.text().contains("Exact: 127.50  5.10  255.00"));
        QVERIFY(panel.text().contains("Error: 2 %"));
        filtered.exactTaps = kRefusedTaps;
        panel.showFiltered(filtered);
        QVERIFY(panel.text().contains("Exact: refused"));
        panel.showUnfiltered("Because.");
        QVERIFY(panel.text().contains("Filtered: not prepared"));
    }

    void lastTexelStaysWhenThePointerLeaves()
    {
        Document document;
        document.open(gridProject(), {}, "grid");
        ReadoutPanel panel(document);
        panel.show(upperTexel());
        const QString text = panel.text();
        panel.show(std::nullopt);
        QCOMPARE(panel.text(), text);
        panel.clear();
        QVERIFY(panel.text() != text);
    }

    void copyPutsTheReadoutOnTheClipboard()
    {
        Document document;
        document.open(gridProject(), {}, "grid");
        ReadoutPanel panel(document);
        panel.show(upperTexel());
        QTest::mouseClick(panel.findChild<QPushButton*>(), Qt::LeftButton);
        QCOMPARE(QApplication::clipboard()->text(), panel.text());
    }

    void polygonIsNamedWhereItIsNotTheFace()
    {
        Document document;
        TriangleMesh mesh = gridMesh(8);
        mesh.sourceFaces.resize(mesh.faceCount());
        for (std::size_t k = 0; k < mesh.faceCount(); ++k) {
            mesh.sourceFaces[k] = static_cast<std::uint32_t>(k / 2);
        }
        NoProgress progress;
        const LevelPlan plan = planUniform(mesh.faceCount(), Level(3));
        const std::vector<float> fill(3, 1.0F);
        document.open(newProject(std::move(mesh), plan, {}, fill, progress).value(), {}, "quads");
        ReadoutPanel panel(document);
        panel.show(upperTexel());
        QVERIFY(panel.text().contains("Face: 7 · polygon 3"));
    }

    void positionsKeepTheDigitsThatCountAndNoMore()
    {
        QCOMPARE(positionText({-2.3e-10F, 1.5F, -0.23708F}, 3.2F),
                 QString("0.00000  1.50000  -0.23708"));
        QCOMPARE(positionText({-812.25F, 0.0F, 31.5F}, 2000.0F), QString("-812.25  0.00  31.50"));
        QCOMPARE(positionText({1.25e-7F, 0.0F, -5e-8F}, 1e-6F), QString("1.25e-07  0  -5e-08"));
        const int fits = 31; // characters of the panel
        for (const float size : {1e-6F, 0.01F, 0.5F, 99.0F, 9999.0F, 1e5F, 1e8F}) {
            const float most = -0.98765F * size;
            QVERIFY2(positionText({most, most, most}, size).size() <= fits,
                     qPrintable(positionText({most, most, most}, size)));
        }
    }

    void storedValuesAreWrittenAsTheirTypeStoresThem()
    {
        const std::array values{1.0F, 0.5F, 0.1F};
        QCOMPARE(storedText(TexelType::UInt8, values), QString("255  128  26"));
        QCOMPARE(storedText(TexelType::UInt16, values), QString("65535  32768  6554"));
        QCOMPARE(storedText(TexelType::Float, values), QString("1  0.5  0.1"));
        const float nan = std::numeric_limits<float>::quiet_NaN();
        const float inf = std::numeric_limits<float>::infinity();
        QCOMPARE(storedText(TexelType::Float, std::array{nan, inf}), QString("nan  inf"));
    }

    void shownColorTakesAnyValue()
    {
        const float nan = std::numeric_limits<float>::quiet_NaN();
        QCOMPARE(shownColor(std::array{nan, 7.0F, -1.0F}), QColor(0, 255, 0));
        QCOMPARE(shownColor(std::array{0.2F}), QColor(51, 51, 51));
        QVERIFY(!shownColor({}).isValid());
    }

    void reportListsFacesAndTellsWhichWasChosen()
    {
        TriangleMesh mesh = gridMesh(2);
        mesh.triangles.push_back(mesh.triangles[0]); // on top of face 0
        mesh.triangles.push_back({0, 0, 1});         // no area
        NoProgress progress;
        const auto surface = Surface::build(std::move(mesh), progress).value();
        ReportPanel panel;
        panel.show(surface.get());
        auto* tree = panel.findChild<QTreeWidget*>();
        QVERIFY(tree->topLevelItemCount() >= 2);

        QSignalSpy chosen(&panel, &ReportPanel::faceChosen);
        QTreeWidgetItem* degenerate = nullptr;
        for (int k = 0; k < tree->topLevelItemCount(); ++k) {
            if (tree->topLevelItem(k)->text(0).startsWith("Faces without area")) {
                degenerate = tree->topLevelItem(k);
            }
        }
        QVERIFY(degenerate);
        QCOMPARE(degenerate->childCount(), 1);
        panel.resize(300, 400);
        static_cast<QWidget&>(panel).show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        tree->expandAll();
        const QRect row = tree->visualItemRect(degenerate->child(0));
        QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, row.center());
        QCOMPARE(chosen.count(), 1);
        QCOMPARE(chosen.at(0).at(0).value<FaceId>(), FaceId{9});
        panel.show(nullptr);
        QCOMPARE(tree->topLevelItemCount(), 0);
    }

    void cleanMeshIsSaidToBeClean()
    {
        ReportPanel panel;
        panel.show(gridProject().surface.get());
        QVERIFY(panel.findChild<QLabel*>()->text().contains("Nothing unusual"));
        QCOMPARE(panel.findChild<QTreeWidget*>()->topLevelItemCount(), 0);
    }
};

} // namespace trixel::ui

QTEST_MAIN(trixel::ui::ReadoutTest)
#include "tst_readout.moc"
