// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <QLabel>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include "tests/ui/fixtures.h"
#include "ui/docks/readout_panel.h"
#include "ui/docks/readout_text.h"
#include "ui/docks/report_panel.h"
#include "ui/document/document.h"
#include "ui/document/inspection.h"

#include <array>
#include <memory>

namespace trixel::ui {

namespace {

/// The texel (3, 1) upper of face 7 of the grid, held or not.
HoveredTexel upperTexel(Document& document)
{
    document.fillFaces(std::array{faceId(7)}, {200.0F / 255, 0, 1, 1});
    ShownTexels shown;
    const Surface& surface = *document.surface();
    const auto corners = surface.mesh().corners(faceId(7));
    HoveredTexel texel = describeTexel(surface,
                                       document.texels(),
                                       shown,
                                       {faceId(7), {0.48F, 0.21F}, pointAt(corners, 0.48F, 0.21F)},
                                       0);
    texel.report.display = displayOf(document.texels().format(), texel.values, {});
    texel.hasFootprint = true;
    texel.footprint = {{0.01, 0.002}, {-0.003, 0.02}};
    texel.ellipse.majorLength = 0.02;
    texel.ellipse.minorLength = 0.01;
    return texel;
}

QLabel* valueNamed(const QWidget& panel, const QString& name)
{
    for (QLabel* label : panel.findChildren<QLabel*>()) {
        if (label->accessibleName() == name) {
            return label;
        }
    }
    return nullptr;
}

} // namespace

class ReadoutTest : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        QSettings().clear();
        m_document = std::make_unique<Document>();
        m_inspection = std::make_unique<Inspection>(*m_document);
        m_document->open(gridProject(), {}, "grid");
        m_panel = std::make_unique<ReadoutPanel>(*m_document, *m_inspection);
        m_panel->resize(310, 520);
    }
    void cleanup()
    {
        m_panel.reset();
        m_inspection.reset();
        m_document.reset();
    }

    void everyNumberOfTheTexelIsShown()
    {
        m_panel->show(upperTexel(*m_document));
        const QString text = m_panel->text();
        for (const char* expected : {"Address: 7:3,1,upper\n",
                                     "Face: 7\n",
                                     "Level: 3 · 8 × 8\n",
                                     "(3, 1) upper\n",
                                     "pixel 6, 4 · index 38\n",
                                     "u v w: 0.48000  0.21000  0.31000\n",
                                     "Stored: 200  0  255\n",
                                     "Bytes: c8 00 ff\n",
                                     "Shown: 0.7843  0  1\n",
                                     "Colour: #c800ff\n",
                                     "Edge 0: 7:3,2,lower\n",
                                     "Edge 1: 7:3,1,lower\n",
                                     "Edge 2: 7:4,1,lower\n",
                                     "W1: 0.01, 0.002\n",
                                     "W2: -0.003, 0.02\n",
                                     "0.02 × 0.01  (2 : 1)\n"}) {
            QVERIFY2(text.contains(expected), qPrintable(QString(expected) + " in\n" + text));
        }
    }

    void valuesThatAreBeingReadAreSaidToBe()
    {
        showPanel();
        HoveredTexel texel = upperTexel(*m_document);
        m_panel->show(texel);
        QTRY_COMPARE(valueNamed(*m_panel, "Stored")->text(), QString("200  0  255"));
        texel.values.clear();
        texel.report.values.clear();
        texel.report.stored.clear();
        texel.report.display.reset();
        m_panel->show(texel);
        for (const char* row : {"Stored", "Shown", "Colour"}) {
            QTRY_COMPARE(valueNamed(*m_panel, row)->text(), QString("reading…"));
        }
        QCOMPARE(valueNamed(*m_panel, "Level")->text(), QString("3 · 8 × 8"));
        QVERIFY(!m_panel->text().contains("Bytes"));
    }

    void everyLineOfATexelHasARow()
    {
        showPanel();
        m_panel->show(upperTexel(*m_document));
        QTRY_COMPARE(valueNamed(*m_panel, "Address")->text(), QString("7:3,1,upper"));
        for (const ReportLine& line : linesOf(m_panel->texel()->report)) {
            if (line.name == "Address" || line.name == "Bytes") {
                continue; // the head of the panel, and on demand
            }
            const QLabel* value = valueNamed(*m_panel, QString::fromStdString(line.name));
            QVERIFY2(value && value->text() != "–", line.name.c_str());
            QVERIFY2(!value->toolTip().isEmpty(), line.name.c_str());
        }
        QCOMPARE(valueNamed(*m_panel, "Stored")->text(), QString("200  0  255"));
    }

    void bytesAreShownOnDemandAndAgainNextTime()
    {
        showPanel();
        m_panel->show(upperTexel(*m_document));
        QTest::mouseClick(buttonNamed("Show bytes"), Qt::LeftButton);
        QCOMPARE(valueNamed(*m_panel, "Stored")->text(), QString("c8 00 ff"));
        const ReadoutPanel another(*m_document, *m_inspection);
        for (const QToolButton* button : another.findChildren<QToolButton*>()) {
            QCOMPARE(button->isChecked(), button->accessibleName() == "Show bytes");
        }
    }

    void aHiddenPanelWritesNothingAndStillKnowsTheTexel()
    {
        m_panel->show(upperTexel(*m_document));
        QCoreApplication::processEvents();
        QCOMPARE(valueNamed(*m_panel, "Face")->text(), QString("–"));
        QVERIFY(m_panel->text().contains("Face: 7\n"));
        showPanel();
        QCOMPARE(valueNamed(*m_panel, "Face")->text(), QString("7"));
    }

    void theButtonHoldsTheTexelAndLetsItGo()
    {
        showPanel();
        QVERIFY(!buttonNamed("Hold the texel")->isEnabled());
        m_inspection->pointAt(faceId(7), {0.48F, 0.21F});
        m_panel->show(upperTexel(*m_document));
        QTRY_VERIFY(buttonNamed("Hold the texel")->isEnabled());
        QTest::mouseClick(buttonNamed("Hold the texel"), Qt::LeftButton);
        QVERIFY(m_inspection->isHeld());
        QToolButton* letGo = buttonNamed("Let the texel go");
        QVERIFY(letGo->isChecked());
        QCOMPARE(letGo->text(), QString("Held"));
        QTest::mouseClick(letGo, Qt::LeftButton);
        QVERIFY(!m_inspection->isHeld());
        m_inspection->hold();
        QVERIFY(letGo->isChecked());
    }

    void neighboursAreGoneToByAClickAndByTheKeyboard()
    {
        showPanel();
        m_inspection->pointAt(faceId(7), {0.48F, 0.21F});
        m_panel->show(upperTexel(*m_document));
        QLabel* edge = valueNamed(*m_panel, "Edge 0");
        QTRY_VERIFY(edge->text().contains("7:3,2,lower"));
        QTest::mouseClick(edge, Qt::LeftButton, {}, {12, edge->height() / 2});
        QVERIFY(m_inspection->isHeld());
        QVERIFY((m_inspection->texel()->place == TexelPlace{faceId(7), {3, 2, TexelHalf::Lower}}));
        QLabel* other = valueNamed(*m_panel, "Edge 1");
        other->setFocus(Qt::TabFocusReason);
        QTest::keyClick(other, Qt::Key_Tab); // to the first link
        QTest::keyClick(other, Qt::Key_Return);
        QVERIFY((m_inspection->texel()->place == TexelPlace{faceId(7), {3, 1, TexelHalf::Lower}}));
    }

    void severalNeighboursAcrossAnEdgeAreToldFromFirstToLast()
    {
        QCOMPARE(neighbourLinks({}), QString("border"));
        const TexelsAcross four{faceId(12),
                                Level(4),
                                LocalEdge::E1,
                                {3, 12, TexelHalf::Lower},
                                {6, 9, TexelHalf::Lower},
                                4};
        QCOMPARE(neighbourLinks(four),
                 QString("<a href='12:3,12,lower'>12:3,12,lower</a> … "
                         "<a href='12:6,9,lower'>6,9</a> ×4"));
    }

    void whatFiltersMakeOfThePixelIsShown()
    {
        m_panel->show(upperTexel(*m_document));
        FilteredTexel filtered;
        filtered.method = {"probes-2", std::nullopt};
        filtered.values = {0.5F, 0.0F, 1.0F};
        filtered.level = 2;
        filtered.taps = 24;
        m_panel->showFiltered(filtered);
        QVERIFY2(m_panel->text().contains("Filtered: 127.50  0.00  255.00"),
                 qPrintable(m_panel->text()));
        QVERIFY(m_panel->text().contains("Read at: level 2.00 · 24 taps"));
        QVERIFY(m_panel->text().contains("Exact: …"));
        filtered.exact = {0.5F, 0.02F, 1.0F};
        filtered.difference = 0.02;
        m_panel->showFiltered(filtered);
        QVERIFY(m_panel->text().contains("Exact: 127.50  5.10  255.00"));
        QVERIFY(m_panel->text().contains("Error: 2 %"));
        filtered.exactTaps = kRefusedTaps;
        m_panel->showFiltered(filtered);
        QVERIFY(m_panel->text().contains("Exact: refused"));
        m_panel->showUnfiltered("Because.");
        QVERIFY(m_panel->text().contains("Filtered: not prepared"));
    }

    void lastTexelStaysWhenThePointerLeaves()
    {
        m_panel->show(upperTexel(*m_document));
        const QString text = m_panel->text();
        m_panel->show(std::nullopt);
        QCOMPARE(m_panel->text(), text);
        m_panel->clear();
        QVERIFY(m_panel->text() != text);
    }

    void polygonIsNamedWhereItIsNotTheFace()
    {
        TriangleMesh mesh = gridMesh(8);
        mesh.sourceFaces.resize(mesh.faceCount());
        for (std::size_t k = 0; k < mesh.faceCount(); ++k) {
            mesh.sourceFaces[k] = static_cast<std::uint32_t>(k / 2);
        }
        NoProgress progress;
        const LevelPlan plan = planUniform(mesh.faceCount(), Level(3));
        const std::vector<float> fill(3, 1.0F);
        m_document->open(
            newProject(std::move(mesh), plan, {}, fill, progress).value(), {}, "quads");
        m_panel->show(upperTexel(*m_document));
        QVERIFY(m_panel->text().contains("Face: 7 · polygon 3"));
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

    void whatIsShownOfValuesFollowsTheLook()
    {
        const TexelFormat format;
        const std::array values{0.25F, 0.5F, 1.0F};
        render::Look look;
        look.exposure = 1;
        look.high = 2;
        const TexelDisplay shown = displayOf(format, values, look);
        QCOMPARE(shown.values, std::vector<float>({0.25F, 0.5F, 1.0F}));
        look.channel = 1;
        QCOMPARE(displayOf(format, values, look).color, render::shade(format, values, look));
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

private:
    void showPanel()
    {
        static_cast<QWidget&>(*m_panel).show();
        m_panel->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_panel.get()));
    }
    QToolButton* buttonNamed(const QString& name) const
    {
        for (QToolButton* button : m_panel->findChildren<QToolButton*>()) {
            if (button->accessibleName() == name) {
                return button;
            }
        }
        return nullptr;
    }

    TemporarySettings m_settings;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<Inspection> m_inspection;
    std::unique_ptr<ReadoutPanel> m_panel;
};

} // namespace trixel::ui

QTEST_MAIN(trixel::ui::ReadoutTest)
#include "tst_readout.moc"
