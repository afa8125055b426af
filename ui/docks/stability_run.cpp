// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/stability_run.h"

#include "ui/docks/study_scene.h"
#include "ui/document/background_job.h"

#include <utility>

namespace trixel::ui {

namespace {

constexpr int kTakeEveryMs = 120;

/// The sweeps' view of the inbox.
class InboxWatcher final : public StabilityWatcher
{
public:
    InboxWatcher(Progress& progress, Inbox<StabilitySweep>& inbox)
        : m_progress(progress)
        , m_inbox(inbox)
    {
    }

    bool report(double fraction) override { return m_progress.report(fraction); }
    void swept(const StabilitySweep& sweep) override { m_inbox.put(sweep); }

private:
    Progress& m_progress;
    Inbox<StabilitySweep>& m_inbox;
};

} // namespace

StabilityWork stabilityWork()
{
    return [](const StabilityInput& input, StabilityWatcher& watcher) -> Result<StabilityReport> {
        if (!input.project) {
            return runStability(nullptr, Threads::all(), watcher);
        }
        StageProgress building(watcher, 0, 0); // the sweeps tell how far it is
        const auto scene = studyScene(*input.project, building);
        if (!scene) {
            return tl::unexpected(scene.error());
        }
        const StabilityAsset asset{
            input.name.toStdString(), **scene, &input.project->surface->mesh()};
        return runStability(&asset, Threads::all(), watcher);
    };
}

StabilityRun::StabilityRun(BackgroundJobs& jobs, StabilityWork work, QObject* parent)
    : QObject(parent)
    , m_jobs(jobs)
    , m_work(std::move(work))
{
    m_timer.setInterval(kTakeEveryMs);
    connect(&m_timer, &QTimer::timeout, this, &StabilityRun::takeSweeps);
}

void StabilityRun::start(StabilityInput input)
{
    if (m_running) {
        return;
    }
    m_running = true;
    m_report = {};
    m_inbox = std::make_shared<Inbox<StabilitySweep>>();
    const auto work = [run = m_work, inbox = m_inbox, input = std::move(input)](
                          Progress& progress) -> Result<StabilityReport> {
        InboxWatcher watcher(progress, *inbox);
        return run(input, watcher);
    };
    const auto done = [self = QPointer(this)](Result<StabilityReport> result) {
        if (self) {
            self->finish(std::move(result));
        }
    };
    m_job = &m_jobs.run(tr("Sweeping through the hazards…"), work, done);
    connect(m_job, &BackgroundJob::progressed, this, &StabilityRun::progressed);
    m_timer.start();
    emit started();
    emit grew();
}

void StabilityRun::cancel()
{
    if (m_job) {
        m_job->cancel();
    }
}

double StabilityRun::fraction() const
{
    return m_job ? m_job->fraction() : 0;
}

void StabilityRun::takeSweeps()
{
    std::vector<StabilitySweep> sweeps = m_inbox->take();
    for (StabilitySweep& sweep : sweeps) {
        m_report.sweeps.push_back(std::move(sweep));
    }
    if (!sweeps.empty()) {
        emit grew();
    }
}

void StabilityRun::finish(Result<StabilityReport> result)
{
    m_timer.stop();
    m_running = false;
    takeSweeps();
    if (result) {
        m_report = std::move(*result);
    }
    emit grew();
    emit ended();
    if (!result && result.error().kind != ErrorKind::Cancelled) {
        emit failed(QString::fromStdString(result.error().message));
    }
}

} // namespace trixel::ui
