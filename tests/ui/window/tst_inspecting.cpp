// SPDX-License-Identifier: GPL-3.0-or-later
//
// Looking at single texels through the whole window: tool, keys, readout and clipboard together.
#include <QClipboard>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QScrollArea>
#include <QScrollBar>
#include <QStatusBar>
#include <QToolButton>

#include "core/texture/texel_address.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/docks/readout_panel.h"
#include "ui/document/inspection.h"

#include <nlohmann/json.hpp>

namespace trixel::ui {

class InspectingTest : public WindowTest
{
    Q_OBJECT

private slots:
    void init()
    {
        openWindow();
        openGrid(); // 128 faces of level 3, two a cell, rows of 8 cells
        m_window->viewport().lookFrom(0, 0);
        m_window->viewport().settle();
    }
    void cleanup() { closeWindow(); }

    void theReadoutFollowsThePointerAndKeepsWhatIsHeld()
    {
        press(Qt::Key_I);
        QCOMPARE(m_window->settings().tool(), Tool::Inspect);
        move(20);
        QTRY_COMPARE(row("Face"), QString("20"));
        QTest::mouseClick(&view(), Qt::LeftButton, {}, middleOf(20));
        move(53);
        QCoreApplication::processEvents();
        QCOMPARE(row("Face"), QString("20"));
        auto* hold = widgetNamed<QToolButton>(readout(), "Let the texel go");
        QVERIFY(hold && hold->isChecked());
        QVERIFY(actionNamed(*m_window, "Hold Texel")->isChecked());
        press(Qt::Key_Escape);
        QTRY_COMPARE(row("Face"), QString("53"));
        QVERIFY(!actionNamed(*m_window, "Hold Texel")->isChecked());
    }

    void hHoldsUnderAnyTool()
    {
        QCOMPARE(m_window->settings().tool(), Tool::Brush);
        move(20);
        press(Qt::Key_H);
        QVERIFY(inspection().isHeld());
        const TexelPlace place = inspection().texel()->place;
        press(Qt::Key_Left);
        QVERIFY(!(inspection().texel()->place == place));
        press(Qt::Key_Down);
        QVERIFY(inspection().texel()->place == place);
        press(Qt::Key_H);
        QVERIFY(!inspection().isHeld());
    }

    void controlGGoesToAnAddress()
    {
        press(Qt::Key_G, Qt::ControlModifier);
        auto* address = widgetNamed<QLineEdit>(view(), "Texel to go to");
        QVERIFY(address);
        QTRY_VERIFY(address->hasFocus());
        QTest::keyClicks(address, "77:2,1,upper");
        QTest::keyClick(address, Qt::Key_Return);
        QTRY_COMPARE(row("Address"), QString("77:2,1,upper"));
        QVERIFY(view().hasFocus());
        press(Qt::Key_Escape);
        QVERIFY(!inspection().isHeld());
    }

    void keysOfToolsAreLettersInTheLine()
    {
        press(Qt::Key_G, Qt::ControlModifier);
        auto* address = widgetNamed<QLineEdit>(view(), "Texel to go to");
        address->clear();
        QTest::keyClicks(address,
                         "1:2,1,lower"); // the b and e of tools are not in it, 1 is opacity
        QTest::keyClick(address, Qt::Key_H);
        QCOMPARE(address->text(), QString("1:2,1,lowerh"));
        QCOMPARE(m_window->settings().tool(), Tool::Brush);
    }

    void theTexelIsCopiedAsTextHexAndJson()
    {
        fillFace(20);
        move(20);
        press(Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(clipboard().contains("Face: 20\n"));
        QVERIFY(clipboard().contains("W1: "));
        QCOMPARE(clipboard(), readout().text());
        QVERIFY(m_window->statusBar()->currentMessage().contains("Copied"));
        press(Qt::Key_H, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(clipboard(), QString("ff 00 00"));
        press(Qt::Key_J, Qt::ControlModifier | Qt::ShiftModifier);
        const auto json = nlohmann::json::parse(clipboard().toStdString());
        QCOMPARE(json["face"].get<int>(), 20);
        QCOMPARE(json["stored"].get<std::vector<int>>(), (std::vector{255, 0, 0}));
        QCOMPARE(json["neighbours"].size(), std::size_t{3});
        QCOMPARE(json["display"]["rgba"].get<std::vector<int>>(), (std::vector{255, 0, 0, 255}));
    }

    void nothingIsCopiedBeforeAnythingWasPointedAt()
    {
        for (const char* name : {"As Text", "As Hex", "As JSON", "Hold Texel"}) {
            QVERIFY2(!actionNamed(*m_window, name)->isEnabled(), name);
        }
        move(20);
        for (const char* name : {"As Text", "As Hex", "As JSON", "Hold Texel"}) {
            QVERIFY2(actionNamed(*m_window, name)->isEnabled(), name);
        }
    }

    void theReadoutTellsPaintOverTheTexelThatWasLeft()
    {
        move(20);
        QTRY_COMPARE(row("Stored"), QString("204  204  204"));
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(&view(), &leave);
        fillFace(20);
        QTRY_COMPARE(row("Stored"), QString("255  0  0"));
        document().undoStack().undo();
        QTRY_COMPARE(row("Stored"), QString("204  204  204"));
    }

    void aNeighbourInTheReadoutIsGoneTo()
    {
        move(20);
        QTRY_COMPARE(row("Face"), QString("20"));
        auto* edge = widgetNamed<QLabel>(readout(), "Edge 1");
        QTest::mouseClick(edge, Qt::LeftButton, {}, {12, edge->height() / 2});
        QVERIFY(inspection().isHeld());
        QTRY_COMPARE(row("Address"), QString::fromStdString(toText(inspection().texel()->place)));
    }

    void theReadoutFitsItsDockWithoutScrolling()
    {
        m_window->resize(1440, 900);
        move(20);
        QCoreApplication::processEvents();
        const auto* scroll = readout().findChild<QScrollArea*>();
        QVERIFY(scroll->widget()->isVisible());
        QCOMPARE(scroll->verticalScrollBar()->maximum(), 0);
    }

private:
    Viewport& view() { return m_window->viewport(); }
    Inspection& inspection() { return m_window->inspection(); }
    ReadoutPanel& readout() { return *m_window->findChild<ReadoutPanel*>(); }
    static QString clipboard() { return QApplication::clipboard()->text(); }
    QPoint middleOf(std::uint32_t face)
    {
        const auto corners = document().surface()->mesh().corners(FaceId{face});
        const float third = 1 / 3.0F;
        return view()
            .widgetPosition({FaceId{face}, {third, third}, pointAt(corners, third, third)})
            ->toPoint();
    }
    void move(std::uint32_t face)
    {
        const QPoint to = middleOf(face);
        QMouseEvent event(QEvent::MouseMove,
                          QPointF(to),
                          QPointF(view().mapToGlobal(to)),
                          Qt::NoButton,
                          Qt::NoButton,
                          Qt::NoModifier);
        QCoreApplication::sendEvent(&view(), &event);
    }
    QString row(const QString& name)
    {
        const auto* label = widgetNamed<QLabel>(readout(), name);
        return label != nullptr ? label->text() : QString();
    }
};

} // namespace trixel::ui

TRIXEL_WINDOW_TEST_MAIN(trixel::ui::InspectingTest)
#include "tst_inspecting.moc"
