// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "ui/window/panel_frames.h"
#include "ui/window/workspace.h"

class QDockWidget;

namespace trixel::ui {

class BookmarkActions;
class BrushPanel;
class FitPanel;
class HoverFilter;
class LayerActions;
class ReadoutPanel;
class ReportPanel;
class SeamPanel;
class ViewsPanel;

/// The panels beside the view: brush, texel, layers, mesh, history, seams, views and fit.
class WorkPanels : public QObject
{
    Q_OBJECT

public:
    WorkPanels(const Workspace& work, const PanelFrames& frames, QObject* parent);

    BrushPanel& brush() { return *m_brush; }
    ReadoutPanel& readout() { return *m_readout; }
    SeamPanel& seams() { return *m_seams; }
    BookmarkActions& bookmarkActions() { return *m_bookmarkActions; }
    LayerActions& layerActions() { return *m_layerActions; }

    /// Opens the panel of fits with nothing planned yet.
    void showFit();

private:
    void share(QDockWidget& dock);
    void makeReadout();
    void makeLayers();
    void makeMesh();
    void makeHistory();
    void makeSeams();
    void makeViews();
    void makeFit();
    void takeDocument();

    Workspace m_work;
    PanelFrames m_frames;
    BrushPanel* m_brush;
    ReadoutPanel* m_readout = nullptr;
    HoverFilter* m_hoverFilter = nullptr; ///< a child of the read-out
    ReportPanel* m_report = nullptr;
    SeamPanel* m_seams = nullptr;
    ViewsPanel* m_views = nullptr;
    FitPanel* m_fit = nullptr;
    QDockWidget* m_fitDock = nullptr;
    QDockWidget* m_shared = nullptr; ///< newest of the docks that share one place
    BookmarkActions* m_bookmarkActions = nullptr;
    LayerActions* m_layerActions = nullptr;
};

} // namespace trixel::ui
