// SPDX-License-Identifier: GPL-3.0-or-later
//
// Images by the mesh's own uvs, from the export dialog.
#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QImage>
#include <QStandardItemModel>

#include "tests/ui/exchange/exchange_fixture.h"
#include "ui/dialogs/export_dialog.h"

namespace trixel::ui {

class BakingOutTest : public ExchangeTest
{
    Q_OBJECT

private slots:
    void init()
    {
        openWindow();
        m_window->resize(900, 600);
    }
    void cleanup() { closeWindow(); }

    void theSquareGoesOutByItsUvs()
    {
        openWithUvs(1);
        fillFace(0);
        ExportDialog& dialog = ask("grid.png");
        choose(*widgetNamed<QComboBox>(dialog, "Kind"), "Image by the mesh's own uvs (.png)");
        choose(*widgetNamed<QComboBox>(dialog, "Image size"), "128 × 128 pixels");
        expectSize(dialog, "1 image of 128 × 128 pixels, 3 channels of uint8");
        QTest::keyClick(&dialog, Qt::Key_Return);
        expectTold("Exported grid.png");
        const QImage image(path("grid.png"));
        QCOMPARE(image.size(), QSize(128, 128));
        QCOMPARE(image.pixelColor(2, 125), QColor(255, 0, 0)); // face 0 is at the lower left
        QCOMPARE(image.pixelColor(100, 20), QColor(204, 204, 204));
    }

    void theEstimateFollowsEveryChoice()
    {
        openWithUvs(1);
        ExportDialog& dialog = ask("grid.tif");
        choose(*widgetNamed<QComboBox>(dialog, "Kind"), "Image by the mesh's own uvs (.tif)");
        expectSize(dialog, "1 image of 2,048 × 2,048 pixels, 3 channels of uint8, 12.6 MB");
        QTest::mouseClick(widgetNamed<QCheckBox>(dialog, "With all halves"), Qt::LeftButton);
        expectSize(dialog, "16.8 MB");
        choose(*widgetNamed<QComboBox>(dialog, "Type of a pixel"), "float");
        expectSize(dialog, "3 channels of float");
        // What the kind of file cannot hold is said, and cannot be exported.
        choose(*widgetNamed<QComboBox>(dialog, "Type of a pixel"), "half");
        expectSize(dialog, "TIFF");
        QVERIFY(!widgetNamed<QPushButton>(dialog, "Export")->isEnabled());
        choose(*widgetNamed<QComboBox>(dialog, "Kind"), "Image by the mesh's own uvs (.exr)");
        expectSize(dialog, "channels of half");
        QVERIFY(widgetNamed<QPushButton>(dialog, "Export")->isEnabled());
    }

    void tilesPutTheirPlaceIntoTheName()
    {
        openWithUvs(2); // over two tiles
        ExportDialog& dialog = ask("grid.png");
        choose(*widgetNamed<QComboBox>(dialog, "Kind"), "Image by the mesh's own uvs (.png)");
        expectSize(dialog, "expected <UDIM> in the name");
        QVERIFY(!widgetNamed<QPushButton>(dialog, "Export")->isEnabled());
        choose(*widgetNamed<QComboBox>(dialog, "Image size"), "128 × 128 pixels");
        auto* tiles = widgetNamed<QCheckBox>(dialog, "One image for each tile");
        tiles->setFocus();
        QTest::keyClick(tiles, Qt::Key_Space);
        auto* name = widgetNamed<QLineEdit>(dialog, "Destination");
        QVERIFY2(name->text().endsWith("grid.<UDIM>.png"), qPrintable(name->text()));
        expectSize(dialog, "2 images of 128 × 128 pixels");
        // And the other way round.
        type(*name, path("other.png"));
        QVERIFY(!tiles->isChecked());
        type(*name, path("t.<UDIM>.png"));
        QVERIFY(tiles->isChecked());
        expectSize(dialog, "2 images");
        QTest::keyClick(&dialog, Qt::Key_Return);
        expectTold("Exported t.1001.png, t.1002.png");
        QVERIFY(QFile::exists(path("t.1002.png")));
    }

    void aMeshWithoutUvsSaysSo()
    {
        openGrid();
        ExportDialog& dialog = ask("grid.ptx");
        auto* kind = widgetNamed<QComboBox>(dialog, "Kind");
        const int uvs = kind->findText("Image by the mesh's own uvs (.png): the mesh has none");
        QVERIFY(uvs > 0);
        QVERIFY(!qobject_cast<QStandardItemModel*>(kind->model())->item(uvs)->isEnabled());
        type(*widgetNamed<QLineEdit>(dialog, "Destination"), path("grid.tx"));
        QVERIFY(textOf(dialog, "Note").contains("the mesh has none"));
        QVERIFY(!widgetNamed<QPushButton>(dialog, "Export")->isEnabled());
        // A .png is then an atlas.
        type(*widgetNamed<QLineEdit>(dialog, "Destination"), path("grid.png"));
        QVERIFY(kind->currentText().startsWith("Packed atlas"));
    }

    void theLastKindComesBackAndRepeats()
    {
        openWithUvs(1);
        ExportDialog& dialog = ask("grid.png");
        choose(*widgetNamed<QComboBox>(dialog, "Kind"), "Image by the mesh's own uvs (.png)");
        choose(*widgetNamed<QComboBox>(dialog, "Image size"), "256 × 256 pixels");
        expectSize(dialog, "256 × 256");
        QTest::keyClick(&dialog, Qt::Key_Return);
        expectTold("Exported grid.png");
        press(Qt::Key_E, Qt::ControlModifier);
        auto* again = openDialog<ExportDialog>();
        QVERIFY(again != nullptr);
        QVERIFY(widgetNamed<QComboBox>(*again, "Kind")->currentText().startsWith("Image by"));
        QCOMPARE(widgetNamed<QComboBox>(*again, "Image size")->currentData().toInt(), 256);
    }

    void aLayerThatIsGoneIsNotExportedAgainAndTheDialogIsOffered()
    {
        openWithUvs(1);
        LayerStack layers(document().texels());
        const LayerId ink = layers.insert(0, {"Ink"});
        QVERIFY(document().editLayers(std::move(layers), ink, "Add Layer"));
        ExportDialog& dialog = ask("ink.png");
        choose(*widgetNamed<QComboBox>(dialog, "Layer"), "Ink");
        QTest::keyClick(&dialog, Qt::Key_Return);
        expectTold("Exported ink");
        LayerStack without = document().layers();
        without.remove(ink);
        QVERIFY(document().editLayers(std::move(without), kBaseLayer, "Delete Layer"));
        press(Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
        expectTold("The layer that was exported last is no longer there: choose what to export.");
        QCOMPARE(m_window->messages().kind(), MessageBar::Kind::Error);
        auto* wayOut = widgetNamed<QPushButton>(m_window->messages(), "Export…");
        QVERIFY(wayOut != nullptr);
        QTest::mouseClick(wayOut, Qt::LeftButton);
        QVERIFY(openDialog<ExportDialog>() != nullptr);
        openDialog<ExportDialog>()->reject();
        document().undoStack().undo(); // the layer is back
        press(Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
        expectTold("Exported ink");
    }

    void labelsOfPagesLineUpWithThoseAbove()
    {
        openWithUvs(1);
        for (const char* file : {"a.ptx", "a.exr", "a.glb", "a.tx"}) {
            ExportDialog dialog({document().snapshot(), {}, {}}, path(file));
            dialog.show();
            QVERIFY(QTest::qWaitForWindowExposed(&dialog));
            QSet<int> lefts;
            for (QWidget* field : dialog.findChildren<QWidget*>()) {
                if (field->isVisible() && (qobject_cast<QComboBox*>(field) != nullptr)) {
                    lefts += field->mapTo(&dialog, QPoint()).x();
                }
            }
            QVERIFY2(lefts.size() == 1, file);
        }
    }

private:
    /// A square whose uvs are its places, spread over so many tiles.
    void openWithUvs(float tiles)
    {
        NoProgress progress;
        TriangleMesh mesh = gridMesh(4);
        for (const Triangle& t : mesh.triangles) {
            for (const std::uint32_t vertex : t) {
                const glm::vec3 p = mesh.positions[vertex];
                mesh.cornerUvs.emplace_back(p.x * tiles, p.y);
            }
        }
        const LevelPlan plan = planUniform(mesh.faceCount(), Level(3));
        document().open(
            newProject(std::move(mesh), plan, {}, std::vector<float>{0.8F, 0.8F, 0.8F}, progress)
                .value(),
            {},
            "grid");
        m_window->viewport().setFocus();
    }
    ExportDialog& ask(const QString& file)
    {
        press(Qt::Key_E, Qt::ControlModifier);
        auto* dialog = openDialog<ExportDialog>();
        check(dialog != nullptr, "the dialog is open");
        type(*widgetNamed<QLineEdit>(*dialog, "Destination"), path(file));
        return *dialog;
    }
    /// Images are written by a process of their own, slowly on a busy machine.
    void expectTold(const QString& words)
    {
        QTRY_VERIFY2_WITH_TIMEOUT(m_window->messages().sentence().startsWith(words),
                                  qPrintable(m_window->messages().sentence()),
                                  60'000);
    }
    /// As the keyboard does: by typing what it is called.
    static void choose(QComboBox& box, const QString& text)
    {
        const int index = box.findText(text);
        QVERIFY2(index >= 0, qPrintable(text));
        box.setFocus();
        while (box.currentIndex() < index) {
            QTest::keyClick(&box, Qt::Key_Down);
        }
        while (box.currentIndex() > index) {
            QTest::keyClick(&box, Qt::Key_Up);
        }
        QCOMPARE(box.currentText(), text);
    }
    static void expectSize(const ExportDialog& dialog, const QString& words)
    {
        QTRY_VERIFY2(textOf(dialog, "Size estimate").contains(words),
                     qPrintable(textOf(dialog, "Size estimate")));
    }
};

} // namespace trixel::ui

TRIXEL_WINDOW_TEST_MAIN(trixel::ui::BakingOutTest)
#include "tst_baking_out.moc"
