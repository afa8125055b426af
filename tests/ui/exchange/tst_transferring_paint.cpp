// SPDX-License-Identifier: GPL-3.0-or-later
//
// File > Transfer Paint from…, driven as a user does.
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>

#include "tests/ui/document/layered_fixture.h"
#include "tests/ui/exchange/exchange_fixture.h"
#include "ui/exchange/transfer_dialog.h"

namespace trixel::ui {

class TransferringPaintTest : public ExchangeTest
{
    Q_OBJECT

private slots:
    void init()
    {
        openWindow();
        m_window->resize(900, 600);
        openGrid(); // 8 by 8 squares, light grey
    }
    void cleanup() { closeWindow(); }

    void paintOfOtherFacesArrivesInOneUndoStep()
    {
        const TexelStore before = document().texels();
        TransferDialog& dialog = ask(red(5, 0));
        QTest::keyClick(&dialog, Qt::Key_Return);
        QTRY_VERIFY(m_window->messages().sentence().startsWith("8,192 of 8,192 texels took paint"));
        QCOMPARE(document().undoStack().count(), 1);
        QVERIFY(document().undoStack().text(0).contains("Transfer paint from red.ptx"));
        for (std::uint32_t k = 0; k < 128; ++k) {
            QCOMPARE(colorOf(FaceId{k}), QColor(200, 10, 20));
            QVERIFY(document().texels().face(FaceId{k}).isConstant());
        }
        press(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(facesThatDiffer(document().texels(), before).empty());
    }

    void withLayersThePaintIsALayerOfItsOwn()
    {
        addLayer(document(), "Layer 1");
        fillFace(15);
        const LayersPicture before = pictureOf(document());
        const int steps = document().undoStack().count();
        TransferDialog& dialog = ask(red(5, 0));
        QTest::keyClick(&dialog, Qt::Key_Return);
        QTRY_COMPARE(document().undoStack().count(), steps + 1);
        QCOMPARE(document().layers().layers().back().settings.name, std::string("red"));
        QCOMPARE(document().layers().layers().size(), std::size_t{2});
        QCOMPARE(allTexels(document().layers().base()), before.texels[0]);
        QCOMPARE(colorOf(FaceId{15}), QColor(200, 10, 20));
        QVERIFY(isShown(document()));
        document().undoStack().undo();
        QVERIFY(pictureOf(document()) == before);
    }

    void theDistanceIsSensibleAndItsReachIsToldAsItIsTyped()
    {
        // Half a square's length above this one: farther than a fiftieth of the size.
        TransferDialog& dialog = ask(red(5, 0.5F), false);
        auto* distance = widgetNamed<QDoubleSpinBox>(dialog, "Distance");
        QVERIFY(std::abs(distance->value() - 0.028) < 1e-9); // of 1.41
        auto* transfer = widgetNamed<QPushButton>(dialog, "Transfer");
        QTRY_VERIFY2(textOf(dialog, "Reach estimate").contains("nearest of a sample is 0.5 units"),
                     qPrintable(textOf(dialog, "Reach estimate")));
        QVERIFY(!transfer->isEnabled());
        distance->setFocus();
        distance->selectAll();
        QTest::keyClicks(distance, "0.6");
        QTRY_VERIFY(transfer->isEnabled());
        QVERIFY2(textOf(dialog, "Reach estimate").contains("About 100 % of 8,192 texels"),
                 qPrintable(textOf(dialog, "Reach estimate")));
        QTest::mouseClick(transfer, Qt::LeftButton);
        QTRY_COMPARE(document().undoStack().count(), 1);
    }

    void whatIsBeyondStaysOrIsErased()
    {
        const QString half = red(4, 0, 0.5F);
        QTest::keyClick(&ask(half), Qt::Key_Return);
        QTRY_COMPARE(document().undoStack().count(), 1);
        QCOMPARE(colorOf(FaceId{0}), QColor(200, 10, 20));
        QCOMPARE(colorOf(FaceId{15}), QColor(204, 204, 204)); // at the other end
        document().undoStack().undo();
        fillFace(15);
        TransferDialog& dialog = ask(half);
        auto* beyond = widgetNamed<QComboBox>(dialog, "Texels beyond");
        beyond->setFocus();
        QTest::keyClick(beyond, Qt::Key_Down);
        QTest::mouseClick(widgetNamed<QPushButton>(dialog, "Transfer"), Qt::LeftButton);
        QTRY_COMPARE(document().undoStack().count(), 2);
        QCOMPARE(colorOf(FaceId{15}), QColor(204, 204, 204)); // the fill colour, not the red
    }

    void aSelectionMasksWhatTakesPaint()
    {
        m_window->selection().set({FaceId{2}, FaceId{9}});
        TransferDialog& dialog = ask(red(5, 0));
        QVERIFY(widgetNamed<QCheckBox>(dialog, "Only selected faces")->isChecked());
        QVERIFY(textOf(dialog, "Reach estimate").contains("of 128 texels"));
        QTest::keyClick(&dialog, Qt::Key_Return);
        QTRY_COMPARE(document().undoStack().count(), 1);
        QCOMPARE(colorOf(FaceId{2}), QColor(200, 10, 20));
        QCOMPARE(colorOf(FaceId{3}), QColor(204, 204, 204));
    }

    void whatCannotBeReadIsSaidBesideTheField()
    {
        TransferDialog& dialog = ask({}, false);
        auto* field = widgetNamed<QLineEdit>(dialog, "Painted file");
        const auto expectSaid = [&](const QString& file, const QString& words) {
            type(*field, file);
            QTRY_VERIFY2(textOf(dialog, "About the painted file").contains(words),
                         qPrintable(textOf(dialog, "About the painted file")));
            QVERIFY(!widgetNamed<QPushButton>(dialog, "Transfer")->isEnabled());
        };
        expectSaid(path("none.ptx"), "none.ptx: ");
        writeFile(path("square.obj"), kSquareObj);
        expectSaid(path("square.obj"), "expected a project or a .ptx");
        writeFile(path("noise.trixel"), "noise");
        expectSaid(path("noise.trixel"), "noise.trixel: ");
        PtxContents bare;
        bare.texels = document().texels();
        bare.adjacency = document().surface()->adjacency();
        NoProgress progress;
        QVERIFY(trixel::writePtx(path("bare.ptx").toStdString(), bare, {}, progress).has_value());
        expectSaid(path("bare.ptx"), "does not carry its mesh");
        QCOMPARE(document().undoStack().count(), 0);
    }

    void paintThatChangedMeanwhileIsNotOverwritten()
    {
        TransferDialog& dialog = ask(red(5, 0));
        QTest::mouseClick(widgetNamed<QPushButton>(dialog, "Transfer"), Qt::LeftButton);
        fillFace(7); // before the answer can be there
        QTRY_VERIFY(m_window->jobs().isIdle());
        QCOMPARE(document().undoStack().count(), 1);
        QCOMPARE(colorOf(FaceId{7}), QColor(255, 0, 0));
        QVERIFY(!m_window->messages().sentence().isEmpty());
    }

    void aTransferCanBeCancelled()
    {
        TransferDialog& dialog = ask(red(5, 0));
        QTest::mouseClick(widgetNamed<QPushButton>(dialog, "Transfer"), Qt::LeftButton);
        QVERIFY(m_window->jobs().latest() != nullptr);
        m_window->jobs().latest()->cancel();
        QTRY_VERIFY(m_window->jobs().isIdle());
        QCOMPARE(document().undoStack().count(), 0);
        QVERIFY(m_window->messages().sentence().isEmpty());
    }

    /// A .ptx opened on a mesh of another order says so and offers what helps.
    void aPtxOfAnotherOrderIsOfferedItsMatch()
    {
        openPainted();
        const QString ptx = writePtx("grid.ptx", document().snapshot());
        const TriangleMesh& mesh = document().surface()->mesh();
        QByteArray text;
        for (const glm::vec3& p : mesh.positions) {
            text +=
                QString("v %1 %2 %3\n").arg(double(p.x)).arg(double(p.y)).arg(double(p.z)).toUtf8();
        }
        for (std::size_t k = mesh.faceCount(); k-- > 0;) {
            const Triangle& t = mesh.triangles[k];
            text += QString("f %1 %2 %3\n").arg(t[1] + 1).arg(t[2] + 1).arg(t[0] + 1).toUtf8();
        }
        writeFile(path("reversed.obj"), text);
        const TexelStore before = document().texels();
        m_window->files().openPtxOn(ptx, path("reversed.obj"));
        QTRY_VERIFY2(m_window->messages().sentence().contains("can be matched by their positions"),
                     qPrintable(m_window->messages().sentence()));
        QVERIFY(m_window->messages().sentence().contains("does not fit the mesh"));
        for (auto* button : m_window->messages().findChildren<QPushButton*>()) {
            if (button->text() == "&Match Faces") {
                QTest::mouseClick(button, Qt::LeftButton);
            }
        }
        QTRY_COMPARE(document().texels().face(FaceId{0}).isConstant(), true);
        QTRY_COMPARE(colorOf(FaceId{0}), QColor(254, 100, 50)); // that of face 127
        QCOMPARE(document().texels().face(FaceId{127}), before.face(FaceId{0}));
        QCOMPARE(document().texels().face(FaceId{124}).isConstant(), false); // turned, of face 3
    }

private:
    /// A square of other faces, red, at a height above the grid's plane.
    QString red(int cells, float height, float width = 1)
    {
        NoProgress progress;
        TriangleMesh mesh = gridMesh(cells);
        for (glm::vec3& position : mesh.positions) {
            position = {position.x * width, position.y, height};
        }
        const LevelPlan plan = planUniform(mesh.faceCount(), Level(2));
        Project project = newProject(std::move(mesh),
                                     plan,
                                     {},
                                     std::vector<float>{200 / 255.0F, 10 / 255.0F, 20 / 255.0F},
                                     progress)
                              .value();
        return writePtx("red.ptx", project);
    }
    QColor colorOf(FaceId face)
    {
        const auto texel = document().texels().face(face).texel(0);
        return {int(texel[0]), int(texel[1]), int(texel[2])};
    }
    TransferDialog& ask(const QString& file, bool untilReady = true)
    {
        actionNamed(*m_window, "Transfer Paint from…")->trigger();
        auto* dialog = openDialog<TransferDialog>();
        check(dialog != nullptr, "the dialog is open");
        if (!file.isEmpty()) {
            type(*widgetNamed<QLineEdit>(*dialog, "Painted file"), file);
        }
        if (untilReady) {
            const auto* transfer = widgetNamed<QPushButton>(*dialog, "Transfer");
            check(QTest::qWaitFor([&] { return transfer->isEnabled(); }), "paint is in reach");
        }
        return *dialog;
    }
};

} // namespace trixel::ui

TRIXEL_WINDOW_TEST_MAIN(trixel::ui::TransferringPaintTest)
#include "tst_transferring_paint.moc"
