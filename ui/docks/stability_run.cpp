// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/stability_run.h"

#include "ui/docks/study_scene.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace trixel::ui {

namespace {

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
    : MeasuredRun(jobs, parent)
    , m_work(std::move(work))
{
}

void StabilityRun::start(StabilityInput input)
{
    if (isRunning()) {
        return;
    }
    m_report = {};
    m_inbox = std::make_shared<Inbox<StabilitySweep>>();
    const auto work = [run = m_work, inbox = m_inbox, input = std::move(input)](
                          Progress& progress) -> Result<StabilityReport> {
        InboxWatcher watcher(progress, *inbox);
        return run(input, watcher);
    };
    launch(tr("Sweeping through the hazards…"), work, [this](StabilityReport report) {
        m_report = std::move(report);
    });
}

bool StabilityRun::take()
{
    std::vector<StabilitySweep> sweeps = m_inbox->take();
    std::ranges::move(sweeps, std::back_inserter(m_report.sweeps));
    return !sweeps.empty();
}

} // namespace trixel::ui
