// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/chart_run.h"

#include "ui/document/background_job.h"

#include <utility>

namespace trixel::ui {

namespace {

/// Often enough to look alive, seldom enough to leave the processors to the measurement.
constexpr int kTakeEveryMs = 120;

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
    : QObject(parent)
    , m_jobs(jobs)
{
    m_timer.setInterval(kTakeEveryMs);
    connect(&m_timer, &QTimer::timeout, this, &ChartRun::takePoints);
}

void ChartRun::start(const StudyOffer& offer, StudyInput input)
{
    if (m_running) {
        return;
    }
    m_running = true;
    m_study = offer.header;
    m_study.subject = input.name.toStdString();
    m_places.clear();
    m_inbox = std::make_shared<Inbox<StudyPoint>>();
    const auto work = [run = offer.run, inbox = m_inbox, input = std::move(input)](
                          Progress& progress) -> Result<Study> {
        InboxWatcher watcher(progress, *inbox);
        return run(input, watcher);
    };
    const auto done = [self = QPointer(this)](Result<Study> result) {
        if (self) {
            self->finish(std::move(result));
        }
    };
    m_job = &m_jobs.run(tr("Measuring: %1").arg(offer.title), work, done);
    connect(m_job, &BackgroundJob::progressed, this, &ChartRun::progressed);
    m_timer.start();
    emit started();
    emit grew();
}

void ChartRun::cancel()
{
    if (m_job) {
        m_job->cancel();
    }
}

double ChartRun::fraction() const
{
    return m_job ? m_job->fraction() : 0;
}

void ChartRun::takePoints()
{
    const std::vector<StudyPoint> points = m_inbox->take();
    for (const StudyPoint& point : points) {
        add(point);
    }
    if (!points.empty()) {
        emit grew();
    }
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

void ChartRun::finish(Result<Study> result)
{
    m_timer.stop();
    m_running = false;
    takePoints();
    if (result) {
        m_study = std::move(*result);
    } else {
        markFront(m_study.points); // what was measured before the end, as it is exported
    }
    emit grew();
    emit ended();
    if (!result && result.error().kind != ErrorKind::Cancelled) {
        emit failed(QString::fromStdString(result.error().message));
    }
}

} // namespace trixel::ui
