// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace trixel::ui {

class PanelFrames;
struct Workspace;

/// The panels that show how texels are laid out, reduced and filtered. They meet in the
/// workspace's `Inspection`, `FaceSelection` and `ViewSettings`, never each other.
class InspectorPanels : public QObject
{
    Q_OBJECT

public:
    InspectorPanels(const Workspace& work, const PanelFrames& frames, QObject* parent);
};

} // namespace trixel::ui
