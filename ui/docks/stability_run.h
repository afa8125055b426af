// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QTimer>

#include "core/io/project.h"
#include "core/study/stability.h"
#include "ui/docks/inbox.h"

#include <functional>
#include <memory>
#include <optional>

namespace trixel::ui {

class BackgroundJob;
class BackgroundJobs;

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

/// The sweeps under way in the background, and those that are done. They stay until the next run.
class StabilityRun : public QObject
{
    Q_OBJECT

public:
    StabilityRun(BackgroundJobs& jobs, StabilityWork work, QObject* parent = nullptr);

    /// Does nothing while the sweeps run.
    void start(StabilityInput input);
    void cancel();
    bool isRunning() const { return m_running; }
    double fraction() const;
    const StabilityReport& report() const { return m_report; }

signals:
    void started();
    void grew();
    void progressed();
    void ended();
    /// One sentence about why there is no result.
    void failed(const QString& sentence);

private:
    void takeSweeps();
    void finish(Result<StabilityReport> result);

    BackgroundJobs& m_jobs;
    StabilityWork m_work;
    QPointer<BackgroundJob> m_job;
    std::shared_ptr<Inbox<StabilitySweep>> m_inbox;
    QTimer m_timer;
    StabilityReport m_report;
    bool m_running = false;
};

} // namespace trixel::ui
