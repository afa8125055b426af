// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "core/study/seam_meter.h"

#include <memory>

class QMenu;

namespace trixel::ui {

class FootprintActions;
class FacePanel;
class LayoutPanel;
class LookPanel;
class MipActions;
class PanelFrames;
struct Workspace;

/// The panels that show how texels are laid out, reduced and filtered. They meet in the
/// workspace's `Inspection`, `FaceSelection` and `ViewSettings`, never each other.
class InspectorPanels : public QObject
{
    Q_OBJECT

public:
    InspectorPanels(const Workspace& work, const PanelFrames& frames, QObject* parent);

    LookPanel& look() const { return *m_look; }
    LayoutPanel& layout() const { return *m_layout; }
    /// From now on Before and After shows the present texels as before.
    void rememberBefore();
    /// What is switched in the panels, so that the command palette finds it.
    void fillMenu(QMenu& menu) const;
    /// The seams that the table of faces tells of; null for none.
    void showSeams(const std::shared_ptr<const SeamReport>& report);

private:
    void makeLook(const Workspace& work, const PanelFrames& frames);
    void makeLayout(const Workspace& work, const PanelFrames& frames);
    void makeFootprint(const Workspace& work, const PanelFrames& frames);
    void makeFaces(const Workspace& work, const PanelFrames& frames);
    void makeMips(const Workspace& work, const PanelFrames& frames);

    LookPanel* m_look;
    LayoutPanel* m_layout = nullptr;
    FootprintActions* m_footprint = nullptr;
    FacePanel* m_faces = nullptr;
    MipActions* m_mipActions = nullptr;
};

} // namespace trixel::ui
