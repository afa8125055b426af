// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "ui/viewport/view_settings.h"

#include <map>
#include <optional>

class QAction;
class QActionGroup;
class QMenu;
class QToolBar;
class QWidget;

namespace trixel::ui {

/// The tools, one of which is chosen; holding S picks a colour and gives the tool back.
class ToolActions : public QObject
{
    Q_OBJECT

public:
    ToolActions(ViewSettings& settings, QWidget& window);

    void fillMenu(QMenu& menu);
    void fillToolBar(QToolBar& bar);

    /// What the tool does and with which keys, for the status bar.
    static QString hintFor(Tool tool);

protected:
    /// Watches the whole program for S going down and up while the window is active.
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void add(Tool tool, const QString& text, const QString& toolTip, int key, const QString& icon);
    void follow();
    bool takesText() const;

    ViewSettings& m_settings;
    QWidget& m_window;
    QActionGroup* m_group;
    std::map<Tool, QAction*> m_actions;
    std::optional<Tool> m_toolBeforePick; ///< while S is held
};

} // namespace trixel::ui
