// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QDockWidget;
class QKeySequence;
class QMainWindow;
class QString;
class QWidget;

namespace trixel::ui {

class PanelActions;

/// Gives panels their places around the view, their titles and the keys that show and hide them.
class PanelFrames
{
public:
    PanelFrames(QMainWindow& window, PanelActions& actions)
        : m_window(window)
        , m_actions(actions)
    {
    }

    /// Right of the view.
    /// \param name   tells the panel from all others in settings and tests
    /// \param title  as users see it
    QDockWidget* beside(const QString& name,
                        const QString& title,
                        QWidget* content,
                        const QKeySequence& shortcut) const;

    /// Below the view, wide as charts are, and out of the way until wanted.
    QDockWidget* below(const QString& name,
                       const QString& title,
                       QWidget* content,
                       const QKeySequence& shortcut) const;

private:
    QDockWidget* frame(const QString& name, const QString& title, QWidget* content) const;

    QMainWindow& m_window;
    PanelActions& m_actions;
};

} // namespace trixel::ui
