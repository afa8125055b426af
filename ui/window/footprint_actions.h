// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>

class QAction;
class QDockWidget;
class QWidget;

namespace trixel::ui {

class FootprintPanel;

/// The commands of the footprint panel, so that the palette and the keyboard have them, too. Each
/// brings the panel to the front.
class FootprintActions : public QObject
{
    Q_OBJECT

public:
    FootprintActions(FootprintPanel& panel, QDockWidget& dock, QWidget& window);

    /// In the order of a menu.
    const QList<QAction*>& actions() const { return m_actions; }

private:
    void makeSources(QWidget& window);
    void makeToggles(QWidget& window);
    void showPanel();

    FootprintPanel& m_panel;
    QDockWidget& m_dock;
    QList<QAction*> m_actions;
};

} // namespace trixel::ui
