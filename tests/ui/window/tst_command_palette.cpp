// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLineEdit>
#include <QMenuBar>
#include <QTreeWidget>

#include "tests/ui/window/window_fixture.h"
#include "ui/window/command_palette.h"

namespace trixel::ui {

class CommandPaletteTest : public WindowTest
{
    Q_OBJECT

private slots:
    void init()
    {
        openWindow();
        openGrid();
    }
    void cleanup() { closeWindow(); }

    void lettersMustAppearInOrder()
    {
        QVERIFY(CommandPalette::fit("Swap Colours", "swcol") >= 0);
        QVERIFY(CommandPalette::fit("Swap Colours", "Colours") >= 0);
        QVERIFY(CommandPalette::fit("Swap Colours", "colsw") < 0);
        QVERIFY(CommandPalette::fit("Swap Colours", "xyz") < 0);
        QCOMPARE(CommandPalette::fit("Swap Colours", ""), CommandPalette::fit("Undo", ""));
    }

    void wordsThatBeginAsTypedComeFirst()
    {
        QVERIFY(CommandPalette::fit("Save As…", "sa") > CommandPalette::fit("Smaller", "sa"));
        QVERIFY(CommandPalette::fit("Frame All", "fa") >
                CommandPalette::fit("Fill Faces in", "la"));
    }

    void keysOpenItAndTypingFindsAndRuns()
    {
        QVERIFY(!m_window->settings().view().wireframe);
        QLineEdit* typed = openPalette();
        QTest::keyClicks(typed, "wirefr");
        QTest::keyClick(typed, Qt::Key_Return);
        QTRY_VERIFY(m_window->settings().view().wireframe);
        QTRY_VERIFY(!openDialog<CommandPalette>());
    }

    void everyEnabledCommandOfTheMenusIsFound()
    {
        QStringList expected;
        const auto collect = [&](auto&& self, const QList<QAction*>& actions) -> void {
            for (QAction* action : actions) {
                if (action->menu() != nullptr) {
                    self(self, action->menu()->actions());
                } else if (!action->isSeparator() && action->isEnabled()) {
                    expected += QString(action->text()).remove('&');
                }
            }
        };
        collect(collect, m_window->menuBar()->actions());
        QVERIFY(expected.size() > 40);
        openPalette();
        const auto* list = openDialog<CommandPalette>()->findChild<QTreeWidget*>();
        QCOMPARE(list->topLevelItemCount(), expected.size());
        QStringList found;
        for (int k = 0; k < list->topLevelItemCount(); ++k) {
            found += list->topLevelItem(k)->text(0).section(" › ", -1).remove(" ✓");
        }
        expected.sort();
        found.sort();
        QCOMPARE(found, expected);
    }

    void arrowsChooseAndEscapeCloses()
    {
        QLineEdit* typed = openPalette();
        auto* list = openDialog<CommandPalette>()->findChild<QTreeWidget*>();
        QTest::keyClick(typed, Qt::Key_Down);
        QCOMPARE(list->indexOfTopLevelItem(list->currentItem()), 1);
        QTest::keyClick(typed, Qt::Key_Up);
        QCOMPARE(list->indexOfTopLevelItem(list->currentItem()), 0);
        QTest::keyClick(typed, Qt::Key_Escape);
        QTRY_VERIFY(!openDialog<CommandPalette>());
    }

    void nothingFoundRunsNothing()
    {
        QLineEdit* typed = openPalette();
        QTest::keyClicks(typed, "qqqq");
        QTest::keyClick(typed, Qt::Key_Return);
        QVERIFY(openDialog<CommandPalette>());
    }

private:
    QLineEdit* openPalette()
    {
        press(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
        [&] { QTRY_VERIFY(openDialog<CommandPalette>()); }();
        return openDialog<CommandPalette>()->findChild<QLineEdit*>();
    }
};

} // namespace trixel::ui

TRIXEL_WINDOW_TEST_MAIN(trixel::ui::CommandPaletteTest)
#include "tst_command_palette.moc"
