// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QKeySequence>
#include <QWidget>

#include "ui/window/icons.h"

namespace trixel::ui {

/// Makes the actions of one window: each has a text with a mnemonic, a tool tip that ends with its
/// shortcut, and works wherever the keyboard is in that window.
class ActionMaker
{
public:
    explicit ActionMaker(QWidget& window)
        : m_window(window)
    {
    }

    QAction* operator()(const QString& text,
                        const QString& toolTip,
                        const QKeySequence& shortcut = {},
                        const QString& iconName = {}) const
    {
        auto* action = new QAction(text, &m_window);
        action->setShortcut(shortcut);
        const QString keys = shortcut.toString(QKeySequence::NativeText);
        action->setToolTip(keys.isEmpty() ? toolTip : QString("%1 (%2)").arg(toolTip, keys));
        action->setStatusTip(toolTip);
        if (!iconName.isEmpty()) {
            action->setIcon(icon(iconName));
        }
        m_window.addAction(action);
        return action;
    }

    /// The same for something that is on or off.
    QAction* toggle(const QString& text,
                    const QString& toolTip,
                    const QKeySequence& shortcut = {},
                    const QString& iconName = {}) const
    {
        QAction* action = (*this)(text, toolTip, shortcut, iconName);
        action->setCheckable(true);
        return action;
    }

private:
    QWidget& m_window;
};

} // namespace trixel::ui
