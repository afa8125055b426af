// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/work_panels.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QUndoView>

#include "ui/docks/brush_colors.h"
#include "ui/docks/brush_panel.h"
#include "ui/docks/camera_files.h"
#include "ui/docks/fit_panel.h"
#include "ui/docks/readout_panel.h"
#include "ui/docks/report_panel.h"
#include "ui/docks/seam_panel.h"
#include "ui/docks/views_panel.h"
#include "ui/document/document.h"
#include "ui/document/face_selection.h"
#include "ui/document/inspection.h"
#include "ui/layers/layer_actions.h"
#include "ui/layers/layer_commands.h"
#include "ui/layers/layer_panel.h"
#include "ui/viewport/hover_filter.h"
#include "ui/viewport/viewport.h"
#include "ui/window/bookmark_actions.h"
#include "ui/window/message_bar.h"

namespace trixel::ui {

namespace {

constexpr int kFitHeight = 560;

} // namespace

WorkPanels::WorkPanels(const Workspace& work, const PanelFrames& frames, QObject* parent)
    : QObject(parent)
    , m_work(work)
    , m_frames(frames)
    , m_brush(new BrushPanel(work.settings, work.colors))
{
    m_frames.beside("brushPanel", tr("Brush"), m_brush, {Qt::Key_F2});
    makeReadout();
    QDockWidget* first = m_shared;
    makeLayers();
    makeMesh();
    makeHistory();
    makeSeams();
    makeViews();
    makeFit();
    first->raise(); // when all that share its place are there
    connect(&m_work.document, &Document::opened, this, &WorkPanels::takeDocument);
}

void WorkPanels::showFit()
{
    if (m_fitDock->isHidden()) {
        m_fitDock->show();
        // A plan has more to tell than the other panels beside it.
        m_work.window.resizeDocks({m_fitDock}, {kFitHeight}, Qt::Vertical);
    }
    m_fitDock->raise();
    m_fit->begin();
}

/// Puts a dock into the one place where all but the brush are, a tab each.
void WorkPanels::share(QDockWidget& dock)
{
    if (m_shared != nullptr) {
        m_work.window.tabifyDockWidget(m_shared, &dock);
    }
    m_shared = &dock;
}

void WorkPanels::makeReadout()
{
    m_readout = new ReadoutPanel(m_work.document, m_work.inspection);
    m_hoverFilter =
        new HoverFilter(m_work.document, m_work.settings, m_work.filterScene, m_readout);
    share(*m_frames.beside("readoutPanel", tr("Texel"), m_readout, {Qt::Key_F3}));
    connect(&m_work.viewport, &Viewport::hovered, m_readout, &ReadoutPanel::show);
    connect(&m_work.viewport,
            &Viewport::hovered,
            m_readout,
            [this](const std::optional<HoveredTexel>& texel) {
                if (m_readout->isVisible()) {
                    m_hoverFilter->ask(texel);
                }
            });
    // The texel that stays when the pointer has left may be painted over, or shown otherwise.
    const auto showLeft = [this] {
        if (!m_work.inspection.isPointedAt()) {
            m_readout->show(m_work.viewport.inspectedTexel());
        }
    };
    connect(&m_work.inspection, &Inspection::changed, m_readout, showLeft);
    connect(&m_work.viewport, &Viewport::inspectedRead, m_readout, showLeft);
    connect(m_hoverFilter, &HoverFilter::answered, m_readout, &ReadoutPanel::showFiltered);
    connect(m_hoverFilter, &HoverFilter::unanswered, m_readout, &ReadoutPanel::showUnfiltered);
}

void WorkPanels::makeLayers()
{
    auto* commands = new LayerCommands(m_work.document, m_work.jobs, this);
    m_layerActions = new LayerActions(m_work.document, *commands, m_work.window);
    auto* panel = new LayerPanel(m_work.document, *commands, *m_layerActions);
    QDockWidget* dock = m_frames.beside("layerPanel", tr("Layers"), panel, {Qt::Key_F11});
    share(*dock);
    connect(commands, &LayerCommands::renameWanted, panel, [panel, dock] {
        dock->show();
        dock->raise();
        panel->editName();
    });
    connect(commands, &LayerCommands::failed, &m_work.messages, &MessageBar::showError);
    connect(commands, &LayerCommands::done, this, [this](const QString& sentence) {
        m_work.messages.showMessage(MessageBar::Kind::Note,
                                    sentence,
                                    {tr("&Undo"), [this] { m_work.document.undoStack().undo(); }});
    });
}

void WorkPanels::makeMesh()
{
    m_report = new ReportPanel;
    share(*m_frames.beside("reportPanel", tr("Mesh"), m_report, {Qt::Key_F4}));
    connect(m_report, &ReportPanel::faceChosen, this, [this](FaceId face) {
        m_work.selection.set({face});
        m_work.viewport.frameFace(face);
    });
    connect(m_report, &ReportPanel::facesChosen, &m_work.selection, &FaceSelection::set);
}

void WorkPanels::makeHistory()
{
    auto* history = new QUndoView(&m_work.document.undoStack());
    history->setEmptyLabel(tr("As opened"));
    history->setAccessibleName(tr("Undo history"));
    history->setToolTip(tr("Choose a step to go back or forward to it"));
    share(*m_frames.beside("historyPanel", tr("History"), history, {Qt::Key_F5}));
}

void WorkPanels::makeSeams()
{
    m_seams = new SeamPanel(
        m_work.document, m_work.settings, m_work.filterScene, m_work.jobs, m_work.viewport);
    share(*m_frames.beside("seamPanel", tr("Seams"), m_seams, {Qt::Key_F7}));
    connect(m_seams, &SeamPanel::edgeChosen, &m_work.viewport, [this](SurfaceEdge edge) {
        const auto across = m_work.document.surface()->adjacency().neighbour(edge.face, edge.edge);
        m_work.selection.set({edge.face, across ? across->face : edge.face});
        m_work.viewport.markEdge(edge);
        m_work.viewport.frameEdge(edge);
    });
}

void WorkPanels::makeViews()
{
    m_views = new ViewsPanel(m_work.document, m_work.jobs, m_work.viewport);
    QDockWidget* dock = m_frames.beside("viewsPanel", tr("Views"), m_views, {Qt::Key_F10});
    share(*dock);
    m_bookmarkActions = new BookmarkActions(m_work.document, *m_views, *dock, m_work.window);
    connect(m_views, &ViewsPanel::viewChosen, &m_work.viewport, &Viewport::lookThrough);
    connect(&m_views->files(), &CameraFiles::done, &m_work.messages, &MessageBar::showNote);
    connect(&m_views->files(), &CameraFiles::failed, &m_work.messages, &MessageBar::showError);
}

/// Out of the way until wanted.
void WorkPanels::makeFit()
{
    m_fit = new FitPanel(
        m_work.document, m_work.settings, m_work.jobs, m_work.viewport, m_work.viewMap, fitWork());
    m_fitDock = m_frames.beside("fitPanel", tr("Fit"), m_fit, {Qt::SHIFT | Qt::Key_F7});
    share(*m_fitDock);
    m_fitDock->hide();
    connect(m_fit, &FitPanel::failed, &m_work.messages, &MessageBar::showError);
    connect(m_fit, &FitPanel::applied, this, [this](const QString& sentence) {
        m_work.messages.showMessage(MessageBar::Kind::Note,
                                    sentence,
                                    {tr("&Undo"), [this] { m_work.document.undoStack().undo(); }});
    });
}

void WorkPanels::takeDocument()
{
    m_readout->clear();
    m_report->show(m_work.document.surface().get());
    if (m_work.document.isOpen()) {
        m_brush->setSurfaceSize(m_work.document.surface()->size());
        m_brush->setHasAlpha(m_work.document.texels().format().channels >= 4);
    }
}

} // namespace trixel::ui
