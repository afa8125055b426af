// SPDX-License-Identifier: GPL-3.0-or-later
//
// Choosing faces in the view and giving them other levels, as the user does it.
#include <QInputDialog>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QSpinBox>

#include "core/lattice/texel.h"
#include "tests/ui/document/layered_fixture.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/document/face_selection.h"

#include <algorithm>
#include <vector>

namespace trixel::ui {

namespace {

std::vector<FaceId> ids(std::initializer_list<std::uint32_t> numbers)
{
    std::vector<FaceId> faces;
    for (const std::uint32_t number : numbers) {
        faces.push_back(FaceId{number});
    }
    return faces;
}

} // namespace

class LevelsTest : public WindowTest
{
    Q_OBJECT

private slots:
    void init()
    {
        openWindow();
        openGrid(); // 128 faces of level 3, two a cell, rows of 8 cells
        m_window->viewport().lookFrom(0, 0);
        m_window->viewport().settle();
        press(Qt::Key_Q);
        QCOMPARE(m_window->settings().tool(), Tool::Select);
    }
    void cleanup() { closeWindow(); }

    void clickReplacesShiftAddsControlRemoves()
    {
        const std::vector<std::byte> before = allTexels(document().texels());
        click(20);
        QCOMPARE(selected(), ids({20}));
        click(50);
        QCOMPARE(selected(), ids({50}));
        click(7, Qt::ShiftModifier);
        QCOMPARE(selected(), ids({7, 50}));
        click(50, Qt::ControlModifier);
        QCOMPARE(selected(), ids({7}));
        QTest::mouseClick(&view(), Qt::LeftButton, {}, QPoint(4, 4));
        QVERIFY(selected().empty());
        QVERIFY(allTexels(document().texels()) == before); // nothing is painted
        QCOMPARE(document().undoStack().count(), 0);
    }

    void draggingBrushesOverEveryFaceOnTheWay()
    {
        QTest::mousePress(&view(), Qt::LeftButton, {}, centre(0));
        drag(centre(14)); // in one leap along the lowest row
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, centre(14));
        QVERIFY(selected().size() >= 15);
        for (std::uint32_t even = 0; even <= 14; even += 2) {
            QVERIFY(m_window->selection().contains(FaceId{even}));
        }
        QVERIFY(std::ranges::is_sorted(selected()));
    }

    void escapeGivesBackTheSelectionBeforeTheDrag()
    {
        click(20);
        QTest::mousePress(&view(), Qt::LeftButton, {}, centre(60));
        drag(centre(66));
        press(Qt::Key_Escape);
        QCOMPARE(selected(), ids({20}));
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, centre(66));
        QCOMPARE(selected(), ids({20}));
    }

    void commandsSelectAllNoneTheOthersAndTheNeighbours()
    {
        press(Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(selected().size(), std::size_t{128});
        QCOMPARE(widgetNamed<QLabel>(*m_window, "Selected faces")->text(), QString("128 selected"));
        press(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(selected().empty());
        QVERIFY(!widgetNamed<QLabel>(*m_window, "Selected faces"));
        click(36);
        actionNamed(*m_window, "Grow Selection")->trigger();
        QCOMPARE(selected(), ids({21, 35, 36, 37})); // below, to the left, itself, across
        press(Qt::Key_I, Qt::ControlModifier);
        QCOMPARE(selected().size(), std::size_t{124});
        QVERIFY(!m_window->selection().contains(FaceId{36}));
    }

    void anotherProjectClearsTheSelection()
    {
        click(20);
        openGrid();
        QVERIFY(selected().empty());
    }

    void outlineOfTheSelectionIsSeen()
    {
        const QImage before = view().grabFramebuffer();
        press(Qt::Key_A, Qt::ControlModifier);
        QTRY_VERIFY(view().grabFramebuffer() != before);
        press(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(view().grabFramebuffer() == before);
    }

    void halvingSaysWhatItCostsThenIsOneStep()
    {
        fillFace(20);
        const std::vector<std::byte> before = allTexels(document().texels());
        click(20);
        click(50, Qt::ShiftModifier);
        actionNamed(*m_window, "Halve")->trigger();
        QTRY_VERIFY(applyButton());
        QVERIFY2(sentence().contains("2 faces") && sentence().contains("→"),
                 qPrintable(sentence()));
        QVERIFY(allTexels(document().texels()) == before); // only said so far
        QTest::mouseClick(applyButton(), Qt::LeftButton);
        QTRY_COMPARE(levelOf(20), 2);
        QCOMPARE(levelOf(50), 2);
        QCOMPARE(levelOf(21), 3);
        QVERIFY(sentence().isEmpty());
        QCOMPARE(document().undoStack().count(), 2);
        press(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(allTexels(document().texels()) == before);
        press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(levelOf(20), 2);
    }

    void withoutSelectionAllFacesChange()
    {
        actionNamed(*m_window, "Double")->trigger();
        QTRY_VERIFY(applyButton());
        QTest::mouseClick(applyButton(), Qt::LeftButton);
        QTRY_COMPARE(document().texels().texelCount(), std::uint64_t{128 * 256});
    }

    void allLayersGetTheLevelInOneStep()
    {
        fillFace(4);
        const LayerId layer = addLayer(document(), "Layer 1");
        fillFace(20);
        const LayersPicture before = pictureOf(document());
        const int steps = document().undoStack().count();
        actionNamed(*m_window, "Double")->trigger();
        QTRY_VERIFY(applyButton());
        QVERIFY2(sentence().contains("57.3 kB"), // of base and layer, 3 + 4 bytes a texel
                 qPrintable(sentence()));
        QTest::mouseClick(applyButton(), Qt::LeftButton);
        QTRY_COMPARE(levelOf(20), 4);
        QCOMPARE(document().undoStack().count(), steps + 1);
        QCOMPARE(document().layers().texels(layer).face(FaceId{9}).level().log2(), 4);
        QCOMPARE(document().layers().base().face(FaceId{9}).level().log2(), 4);
        QVERIFY(isShown(document()));
        document().undoStack().undo();
        QVERIFY(pictureOf(document()) == before);
    }

    void levelIsAskedFor()
    {
        click(36);
        actionNamed(*m_window, "Set Level…")->trigger();
        auto* dialog = openDialog<QInputDialog>();
        QVERIFY(dialog);
        QCOMPARE(dialog->intValue(), 3);
        dialog->setIntValue(6);
        dialog->accept();
        QTRY_VERIFY(applyButton());
        QTest::mouseClick(applyButton(), Qt::LeftButton);
        QTRY_COMPARE(levelOf(36), 6);
    }

    void leavingTheLevelsIsRefused()
    {
        document().open(gridProject(8, 0), {}, "coarse");
        actionNamed(*m_window, "Halve")->trigger();
        QTRY_VERIFY2(sentence().contains("128 of 128"), qPrintable(sentence()));
        QVERIFY(!applyButton());
        QCOMPARE(document().undoStack().count(), 0);
    }

    void moreThanTheBudgetIsRefused()
    {
        document().open(gridProject(8, 11), {}, "fine"); // constant faces: nothing is stored
        actionNamed(*m_window, "Double")->trigger();
        QTRY_VERIFY2(sentence().contains("allowed"), qPrintable(sentence()));
        QVERIFY(!applyButton());
    }

    void anOfferEndsWhenTheSelectionChanges()
    {
        click(20);
        actionNamed(*m_window, "Halve")->trigger();
        QTRY_VERIFY(applyButton());
        click(50);
        QVERIFY(sentence().isEmpty());
    }

    void aPatchForAnotherStateIsRefused()
    {
        const StateId state = document().state();
        fillFace(3);
        const std::vector<std::byte> before = allTexels(document().texels());
        TexelPatch patch;
        patch.addFace(FaceId{3}, document().texels().face(FaceId{4}));
        QVERIFY(!document().applyPatch(std::move(patch), state, "Late"));
        QVERIFY(allTexels(document().texels()) == before);
        QCOMPARE(document().undoStack().count(), 1);
        QVERIFY(sentence().contains("meanwhile"));
    }

private:
    Viewport& view() { return m_window->viewport(); }
    std::vector<FaceId> selected()
    {
        const auto faces = m_window->selection().faces();
        return {faces.begin(), faces.end()};
    }
    int levelOf(std::uint32_t face)
    {
        return document().texels().face(FaceId{face}).level().log2();
    }
    QString sentence() { return m_window->messages().sentence(); }
    QPushButton* applyButton()
    {
        for (auto* button : m_window->messages().findChildren<QPushButton*>()) {
            if (button->isVisible() && button->text() == "&Apply") {
                return button;
            }
        }
        return nullptr;
    }
    QPoint centre(std::uint32_t face)
    {
        const auto corners = document().surface()->mesh().corners(FaceId{face});
        const glm::vec2 middle(1.0F / 3);
        const SurfacePoint point{FaceId{face}, middle, pointAt(corners, middle.x, middle.y)};
        return view().widgetPosition(point)->toPoint();
    }
    void click(std::uint32_t face, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mouseClick(&view(), Qt::LeftButton, modifiers, centre(face));
    }
    void drag(QPoint to)
    {
        QMouseEvent move(QEvent::MouseMove,
                         QPointF(to),
                         QPointF(view().mapToGlobal(to)),
                         Qt::NoButton,
                         Qt::LeftButton,
                         Qt::NoModifier);
        QCoreApplication::sendEvent(&view(), &move);
    }
};

} // namespace trixel::ui

TRIXEL_WINDOW_TEST_MAIN(trixel::ui::LevelsTest)
#include "tst_levels.moc"
