// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "ui/window/panel_frames.h"
#include "ui/window/workspace.h"

class QAction;
class QDockWidget;
class QMenu;

namespace trixel::ui {

class ImportPanel;

/// File > Import Image…, and its panel beside the view: out of the way until wanted.
class ImportActions : public QObject
{
    Q_OBJECT

public:
    ImportActions(const Workspace& work, const PanelFrames& frames, QObject* parent);

    void fillMenu(QMenu& menu);
    /// Takes the files if the first is an image; whether it did.
    bool takeDropped(const QStringList& paths);

private:
    void begin(const QString& path);
    void enable();

    Workspace m_work;
    ImportPanel* m_panel;
    QDockWidget* m_dock;
    QAction* m_import;
};

} // namespace trixel::ui
