// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QList>

class QAction;
class QLineEdit;
class QTreeWidget;
class QMenuBar;

namespace trixel::ui {

/// Every command of the menus in one list that is searched by typing.
class CommandPalette : public QDialog
{
    Q_OBJECT

public:
    explicit CommandPalette(QMenuBar& menus, QWidget* parent = nullptr);

    /// How well a name answers what was typed: every letter must appear in order; runs of letters
    /// and beginnings of words count more. Nothing typed fits all alike; a negative number does not
    /// fit.
    static int fit(const QString& name, const QString& typed);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Command
    {
        QString name; ///< with its menus: "File › Save"
        QAction* action;
    };

    void collect(const QList<QAction*>& actions, const QString& path);
    void list();
    void run();

    QList<Command> m_commands;
    QLineEdit* m_typed;
    QTreeWidget* m_list;
};

} // namespace trixel::ui
