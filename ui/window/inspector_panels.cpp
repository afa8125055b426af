// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/inspector_panels.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QScrollArea>

#include "ui/inspector/face_panel.h"
#include "ui/inspector/footprint_panel.h"
#include "ui/inspector/layout_panel.h"
#include "ui/inspector/mip_panel.h"
#include "ui/look/look_overlay.h"
#include "ui/look/look_panel.h"
#include "ui/viewport/view_map.h"
#include "ui/viewport/viewport.h"
#include "ui/window/footprint_actions.h"
#include "ui/window/message_bar.h"
#include "ui/window/mip_actions.h"
#include "ui/window/panel_frames.h"
#include "ui/window/workspace.h"

namespace trixel::ui {

namespace {

/// Of the narrowest dock, less a scroll bar.
constexpr int kLookWidth = 280;

} // namespace

InspectorPanels::InspectorPanels(const Workspace& work, const PanelFrames& frames, QObject* parent)
    : QObject(parent)
    , m_look(new LookPanel(work.document, work.settings, work.inspection))
{
    makeLook(work, frames);
    makeLayout(work, frames);
    makeMips(work, frames);
    makeFootprint(work, frames);
    makeFaces(work, frames);
}

void InspectorPanels::showSeams(const std::shared_ptr<const SeamReport>& report)
{
    m_faces->setSeams(report);
}

void InspectorPanels::rememberBefore()
{
    m_layout->rememberBefore();
}

void InspectorPanels::fillMenu(QMenu& menu) const
{
    QMenu* layout = menu.addMenu(tr("Texel La&yout"));
    layout->addActions(m_layout->switches());
    QMenu* footprint = menu.addMenu(tr("Look i&nto Footprint"));
    footprint->addActions(m_footprint->actions());
    m_mipActions->fillMenu(menu);
}

void InspectorPanels::makeLook(const Workspace& work, const PanelFrames& frames)
{
    auto* scroll = new QScrollArea; // a low window need not grow for it
    m_look->setMinimumWidth(kLookWidth);
    scroll->setWidget(m_look);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    QDockWidget* look = frames.beside("lookPanel", tr("Look"), scroll, {Qt::SHIFT | Qt::Key_F2});
    // One of the two is wanted at a time: the brush to paint, the look to see.
    auto* brush = work.window.findChild<QDockWidget*>("brushPanel");
    work.window.tabifyDockWidget(brush, look);
    brush->raise();
    new LookOverlay(work.document, work.settings, work.viewport);
}

void InspectorPanels::makeLayout(const Workspace& work, const PanelFrames& frames)
{
    m_layout = new LayoutPanel(work.document, work.settings, work.inspection, work.selection);
    m_layout->useFilters(work.filterScene);
    connect(&work.viewMap, &ViewMap::facesNumbered, m_layout, &LayoutPanel::setFaceNumbers);
    QDockWidget* dock =
        frames.below("layoutPanel", tr("Layout"), m_layout, {Qt::SHIFT | Qt::Key_F3});
    work.window.tabifyDockWidget(work.window.findChild<QDockWidget*>("stabilityPanel"), dock);
}

/// Out of the way until wanted.
void InspectorPanels::makeFootprint(const Workspace& work, const PanelFrames& frames)
{
    auto* panel = new FootprintPanel(
        {work.document, work.inspection, work.settings, work.filterScene, work.viewport});
    QDockWidget* dock =
        frames.beside("footprintPanel", tr("Footprint"), panel, {Qt::SHIFT | Qt::Key_F5});
    auto* front = work.window.findChild<QDockWidget*>("readoutPanel");
    work.window.tabifyDockWidget(front, dock);
    dock->hide();
    front->raise(); // it stays the one that is read first
    m_footprint = new FootprintActions(*panel, *dock, work.window);
}

void InspectorPanels::makeFaces(const Workspace& work, const PanelFrames& frames)
{
    m_faces =
        new FacePanel(work.document, work.selection, work.inspection, work.settings, work.jobs);
    QDockWidget* dock = frames.below("facesPanel", tr("Faces"), m_faces, {Qt::SHIFT | Qt::Key_F8});
    work.window.tabifyDockWidget(work.window.findChild<QDockWidget*>("stabilityPanel"), dock);
    connect(m_faces, &FacePanel::faceChosen, &work.viewport, &Viewport::frameFace);
    connect(m_faces, &FacePanel::written, &work.messages, &MessageBar::showNote);
    connect(m_faces, &FacePanel::failed, &work.messages, &MessageBar::showError);
}

void InspectorPanels::makeMips(const Workspace& work, const PanelFrames& frames)
{
    auto* panel = new MipPanel(work.document, work.inspection, work.settings);
    QDockWidget* dock = frames.below("mipPanel", tr("Mips"), panel, {Qt::SHIFT | Qt::Key_F4});
    work.window.tabifyDockWidget(work.window.findChild<QDockWidget*>("stabilityPanel"), dock);
    m_mipActions = new MipActions(*panel, *dock, work.window);
}

} // namespace trixel::ui
