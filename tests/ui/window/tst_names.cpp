// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whoever cannot see the window, or has no mouse, is told and led everywhere.
#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QProgressBar>
#include <QScrollBar>
#include <QSet>
#include <QTabBar>

#include "tests/ui/window/window_fixture.h"
#include "ui/dialogs/export_dialog.h"
#include "ui/dialogs/new_dialog.h"
#include "ui/window/command_palette.h"

namespace trixel::ui {

namespace {

bool isControl(const QWidget& widget)
{
    // Parts of other controls, which speak for them.
    const QWidget* parent = widget.parentWidget();
    if (qobject_cast<const QAbstractSpinBox*>(parent) || qobject_cast<const QComboBox*>(parent) ||
        qobject_cast<const QTabBar*>(parent) || qobject_cast<const QScrollBar*>(&widget)) {
        return false;
    }
    return qobject_cast<const QAbstractButton*>(&widget) ||
           qobject_cast<const QAbstractSpinBox*>(&widget) ||
           qobject_cast<const QAbstractSlider*>(&widget) ||
           qobject_cast<const QComboBox*>(&widget) || qobject_cast<const QLineEdit*>(&widget) ||
           qobject_cast<const QAbstractItemView*>(&widget) ||
           qobject_cast<const QProgressBar*>(&widget);
}

QString describe(const QWidget& widget)
{
    QString path;
    for (const QWidget* w = &widget; w != nullptr; w = w->parentWidget()) {
        path.prepend("/" + QString(w->metaObject()->className()) + ":" + w->objectName());
    }
    return path;
}

/// What screen readers call the widget.
QString spokenName(QWidget& widget)
{
    QAccessibleInterface* accessible = QAccessible::queryAccessibleInterface(&widget);
    return accessible != nullptr ? accessible->text(QAccessible::Name) : QString();
}

/// Every control in the tree that can be seen and lacks a name or a tool tip.
QStringList unexplained(const QWidget& root, int& controls)
{
    QStringList found;
    for (QWidget* widget : root.findChildren<QWidget*>()) {
        if (!widget->isVisibleTo(&root) || !isControl(*widget)) {
            continue;
        }
        ++controls;
        if (spokenName(*widget).isEmpty()) {
            found += "no name: " + describe(*widget);
        }
        if (widget->toolTip().isEmpty()) {
            found += "no tool tip: " + describe(*widget);
        }
    }
    return found;
}

} // namespace

class NamesTest : public WindowTest
{
    Q_OBJECT

private slots:
    void init() { openWindow(); }
    void cleanup() { closeWindow(); }

    void everyControlOfTheEmptyWindowIsNamedAndExplained() { expectExplained(*m_window, 20); }

    void everyControlOfEveryPanelIsNamedAndExplained()
    {
        openGrid();
        m_window->messages().showMessage(MessageBar::Kind::Note, "Note.", {"&Act", [] {}});
        for (QDockWidget* dock : m_window->findChildren<QDockWidget*>()) {
            dock->raise();
            QCoreApplication::processEvents();
            expectExplained(*m_window, 40);
        }
        QCOMPARE(spokenName(m_window->viewport()), QString("3D view"));
    }

    void everyControlOfTheDialogsIsNamedAndExplained()
    {
        expectExplained(NewDialog({}), 7);
        for (const char* name : {"a.ptx", "a.exr", "a.glb"}) { // one for each kind
            expectExplained(ExportDialog({gridProject(), {}, {}}, name), 10);
        }
        expectExplained(CommandPalette(*m_window->menuBar()), 2);
    }

    void everyLabelOfAFormLeadsToItsField()
    {
        for (const QLabel* label : m_window->findChildren<QLabel*>()) {
            if (label->text().contains('&')) {
                QVERIFY2(label->buddy(), qPrintable(label->text()));
            }
        }
    }

    void everyCommandHasAMnemonicOrShortcutAndAToolTip()
    {
        openGrid();
        int commands = 0;
        const auto walk = [&](auto&& self, const QList<QAction*>& actions) -> void {
            for (const QAction* action : actions) {
                if (action->isSeparator()) {
                    continue;
                }
                ++commands;
                const bool reachable =
                    action->text().contains('&') || !action->shortcut().isEmpty() ||
                    qobject_cast<QMenu*>(action->parent()) != nullptr; // listed files
                QVERIFY2(reachable, qPrintable(action->text()));
                QVERIFY2(!action->toolTip().isEmpty(), qPrintable(action->text()));
                if (action->menu() != nullptr) {
                    self(self, action->menu()->actions());
                }
            }
        };
        walk(walk, m_window->menuBar()->actions());
        QVERIFY(commands > 50);
    }

    void mnemonicsOfEachMenuDiffer()
    {
        const auto walk =
            [&](auto&& self, const QString& menu, const QList<QAction*>& all) -> void {
            QSet<QChar> used;
            for (const QAction* action : all) {
                const qsizetype at = action->text().indexOf('&');
                if (at >= 0 && !action->isSeparator()) {
                    const QChar letter = action->text()[at + 1].toLower();
                    QVERIFY2(!used.contains(letter), qPrintable(menu + " › " + action->text()));
                    used += letter;
                }
                if (action->menu() != nullptr) {
                    self(self, action->text(), action->menu()->actions());
                }
            }
        };
        walk(walk, "menu bar", m_window->menuBar()->actions());
    }

    void noTwoCommandsShareAShortcut()
    {
        QHash<QKeySequence, QString> owner;
        for (const QAction* action : m_window->findChildren<QAction*>()) {
            for (const QKeySequence& keys : action->shortcuts()) {
                QVERIFY2(!owner.contains(keys),
                         qPrintable(keys.toString() + ": " + action->text() + ", " + owner[keys]));
                owner[keys] = action->text();
            }
        }
        QVERIFY(owner.size() > 30);
    }

private:
    static void expectExplained(const QWidget& root, int atLeast)
    {
        int controls = 0;
        const QStringList found = unexplained(root, controls);
        QVERIFY2(found.isEmpty(), qPrintable(found.join("\n")));
        QVERIFY2(controls >= atLeast, qPrintable(QString::number(controls)));
    }
};

} // namespace trixel::ui

TRIXEL_WINDOW_TEST_MAIN(trixel::ui::NamesTest)
#include "tst_names.moc"
