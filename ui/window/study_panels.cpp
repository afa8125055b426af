// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/study_panels.h"

#include <QDockWidget>
#include <QMainWindow>

#include "ui/docks/chart_panel.h"
#include "ui/docks/stability_panel.h"
#include "ui/document/face_selection.h"
#include "ui/viewport/viewport.h"
#include "ui/window/message_bar.h"
#include "ui/window/panel_frames.h"
#include "ui/window/workspace.h"

namespace trixel::ui {

StudyPanels::StudyPanels(const Workspace& work, const PanelFrames& frames, QObject* parent)
    : QObject(parent)
{
    auto* chart = new ChartPanel(work.document, work.settings, work.jobs, studyOffers());
    auto* stability = new StabilityPanel(work.document, work.jobs, stabilityWork());
    work.window.tabifyDockWidget(
        frames.below("chartPanel", tr("Speed and accuracy"), chart, {Qt::Key_F8}),
        frames.below("stabilityPanel", tr("Stability"), stability, {Qt::Key_F9}));
    connect(chart, &ChartPanel::failed, &work.messages, &MessageBar::showError);
    connect(chart, &ChartPanel::written, &work.messages, &MessageBar::showNote);
    connect(stability, &StabilityPanel::failed, &work.messages, &MessageBar::showError);
    connect(stability, &StabilityPanel::written, &work.messages, &MessageBar::showNote);
    connect(stability, &StabilityPanel::faceChosen, this, [work](FaceId face) {
        work.selection.set({face});
        work.viewport.frameFace(face);
    });
}

} // namespace trixel::ui
