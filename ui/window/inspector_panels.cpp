// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/inspector_panels.h"

#include "ui/window/panel_frames.h"
#include "ui/window/workspace.h"

namespace trixel::ui {

InspectorPanels::InspectorPanels([[maybe_unused]] const Workspace& work,
                                 [[maybe_unused]] const PanelFrames& frames,
                                 QObject* parent)
    : QObject(parent)
{
}

} // namespace trixel::ui
