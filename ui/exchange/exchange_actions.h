// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

#include "ui/window/workspace.h"

class QAction;
class QDockWidget;
class QMenu;

namespace trixel::ui {

class DifferencePanel;
class PaintTransfer;
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
    void makeTransfer();
    void askToTransfer();

    Workspace m_work;
    DifferencePanel* m_differences = nullptr;
    QDockWidget* m_differenceDock = nullptr;
    QAction* m_compare = nullptr;
    QAction* m_transferFrom = nullptr;
    PaintTransfer* m_transfer = nullptr;
    QString m_transferPath; ///< the file that paint came from last
};

} // namespace trixel::ui
