// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/chart_run.h"

#include <utility>

namespace trixel::ui {

namespace {

/// The study's view of the inbox.
class InboxWatcher final : public StudyWatcher
{
public:
    InboxWatcher(Progress& progress, Inbox<StudyPoint>& inbox)
        : m_progress(progress)
        , m_inbox(inbox)
    {
    }

    bool report(double fraction) override { return m_progress.report(fraction); }
    void measured(const StudyPoint& point) override { m_inbox.put(point); }

private:
    Progress& m_progress;
    Inbox<StudyPoint>& m_inbox;
};

} // namespace

ChartRun::ChartRun(BackgroundJobs& jobs, QObject* parent)
    : MeasuredRun(jobs, parent)
{
}

void ChartRun::start(const StudyOffer& offer, StudyInput input)
{
    if (isRunning()) {
        return;
    }
    m_study = offer.header;
    m_study.subject = input.name.toStdString();
    m_places.clear();
    m_inbox = std::make_shared<Inbox<StudyPoint>>();
    const auto work = [run = offer.run, inbox = m_inbox, input = std::move(input)](
                          Progress& progress) -> Result<Study> {
        InboxWatcher watcher(progress, *inbox);
        return run(input, watcher);
    };
    launch(tr("Measuring: %1").arg(offer.title), work, [this](Study study) {
        m_study = std::move(study);
    });
}

bool ChartRun::take()
{
    const std::vector<StudyPoint> points = m_inbox->take();
    for (const StudyPoint& point : points) {
        add(point);
    }
    return !points.empty();
}

void ChartRun::settle()
{
    markFront(m_study.points);
}

void ChartRun::add(const StudyPoint& point)
{
    const auto [place, isNew] = m_places.try_emplace(
        {point.series, point.variant, point.footprintClass}, m_study.points.size());
    if (isNew) {
        m_study.points.push_back(point);
    } else {
        m_study.points[place->second] = point;
    }
}

} // namespace trixel::ui
