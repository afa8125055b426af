// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QList>
#include <QObject>

#include "render/look.h"

#include <functional>
#include <utility>

class QAction;
class QMenu;
class QToolBar;
class QWidget;

namespace trixel::ui {

class Document;
class LookPanel;
class ViewSettings;

/// The commands that change how texel values become colours.
class LookActions : public QObject
{
    Q_OBJECT

public:
    LookActions(const Document& document,
                ViewSettings& settings,
                LookPanel& panel,
                QWidget& window);

    void fillMenu(QMenu& menu);
    /// The looks that are changed most often: channel, exposure, false colour.
    void fillToolBar(QToolBar& bar);

private:
    using Change = std::function<render::Look(render::Look)>;
    QAction*
    add(const QString& text, const QString& toolTip, const QKeySequence& shortcut, Change change);
    QAction* addToggle(const QString& text,
                       const QString& toolTip,
                       const QKeySequence& shortcut,
                       bool render::Look::*member);
    void follow();

    const Document& m_document;
    ViewSettings& m_settings;
    QWidget& m_window;
    QAction* m_falseColor = nullptr;
    QList<QAction*> m_actions; ///< in the order of the menu; null separates
    QList<std::pair<QAction*, bool render::Look::*>> m_toggles;
};

} // namespace trixel::ui
