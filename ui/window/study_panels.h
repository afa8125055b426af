// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace trixel::ui {

class PanelFrames;
struct Workspace;

/// The panels below the view that measure: the chart of speed and accuracy, and the stability
/// sweeps.
class StudyPanels : public QObject
{
    Q_OBJECT

public:
    StudyPanels(const Workspace& work, const PanelFrames& frames, QObject* parent);
};

} // namespace trixel::ui
