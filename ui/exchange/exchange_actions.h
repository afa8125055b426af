// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "ui/window/workspace.h"

class QAction;
class QDockWidget;
class QMenu;

namespace trixel::ui {

class DifferencePanel;
class PanelFrames;

/// What the open project has to do with other files: the commands of the File menu, and the panel
/// of differences.
class ExchangeActions : public QObject
{
    Q_OBJECT

public:
    ExchangeActions(const Workspace& work, const PanelFrames& frames, QObject* parent);

    void fillMenu(QMenu& menu);
    DifferencePanel& differences() { return *m_differences; }

private:
    void makeDifferences(const PanelFrames& frames);
    void enable();
    void askToCompare();

    Workspace m_work;
    DifferencePanel* m_differences = nullptr;
    QDockWidget* m_differenceDock = nullptr;
    QAction* m_compare = nullptr;
};

} // namespace trixel::ui
