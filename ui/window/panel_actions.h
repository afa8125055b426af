// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>

class QAction;
class QDockWidget;
class QMainWindow;
class QMenu;
class QWidget;

namespace trixel::ui {

/// Panels shown and hidden, walked through by keyboard, and the theme.
class PanelActions : public QObject
{
    Q_OBJECT

public:
    /// \param view  the widget that keeps the keyboard while painting
    PanelActions(QMainWindow& window, QWidget& view);

    /// Lists a panel in the menu.
    void add(QDockWidget& dock, const QKeySequence& shortcut);
    void fillMenu(QMenu& menu);

    /// Hides all panels, or shows those again that were hidden by it.
    void toggleAll();

protected:
    /// Enter or Escape in a number field gives the keyboard back to the view.
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void makeThemes();
    void focusNext();

    QMainWindow& m_window;
    QWidget& m_view;
    QList<QDockWidget*> m_docks;
    QList<QDockWidget*> m_hidden; ///< by toggleAll, to be shown again
    QAction* m_toggleAll;
    QAction* m_next;
    QList<QAction*> m_themes;
};

} // namespace trixel::ui
