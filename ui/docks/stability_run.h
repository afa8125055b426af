// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/project.h"
#include "core/study/stability/stability.h"
#include "ui/docks/inbox.h"
#include "ui/docks/measured_run.h"

#include <functional>
#include <memory>
#include <optional>

namespace trixel::ui {

/// What the sweeps are run with: the open project, whose own faces are then looked at, or nothing.
struct StabilityInput
{
    std::optional<Project> project;
    QString name;
};

/// Runs on another thread.
using StabilityWork =
    std::function<Result<StabilityReport>(const StabilityInput& input, StabilityWatcher& watcher)>;

/// Every sweep of core, and the hazards of the project's faces.
StabilityWork stabilityWork();

/// The sweeps under way in the background, and those that are done.
class StabilityRun : public MeasuredRun
{
    Q_OBJECT

public:
    StabilityRun(BackgroundJobs& jobs, StabilityWork work, QObject* parent = nullptr);

    /// Does nothing while the sweeps run.
    void start(StabilityInput input);
    const StabilityReport& report() const { return m_report; }

private:
    bool take() override;

    StabilityWork m_work;
    std::shared_ptr<Inbox<StabilitySweep>> m_inbox;
    StabilityReport m_report;
};

} // namespace trixel::ui
