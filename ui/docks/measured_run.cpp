// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/measured_run.h"

#include "core/base/check.h"

namespace trixel::ui {

namespace {

/// Often enough to look alive, seldom enough to leave the processors to the measurement.
constexpr int kTakeEveryMs = 120;

} // namespace

MeasuredRun::MeasuredRun(BackgroundJobs& jobs, QObject* parent)
    : QObject(parent)
    , m_jobs(jobs)
{
    m_timer.setInterval(kTakeEveryMs);
    connect(&m_timer, &QTimer::timeout, this, [this] {
        if (take()) {
            emit grew();
        }
    });
}

void MeasuredRun::cancel()
{
    if (m_job) {
        m_job->cancel();
    }
}

double MeasuredRun::fraction() const
{
    return m_job ? m_job->fraction() : 0;
}

void MeasuredRun::begin()
{
    check(!m_running, "one run at a time");
    m_running = true;
}

void MeasuredRun::watch(BackgroundJob& job)
{
    m_job = &job;
    connect(m_job, &BackgroundJob::progressed, this, &MeasuredRun::progressed);
    m_timer.start();
    emit started();
    emit grew();
}

void MeasuredRun::stop()
{
    m_timer.stop();
    m_running = false;
    take();
}

void MeasuredRun::finish(const Status& status)
{
    if (!status) {
        settle();
    }
    emit grew();
    emit ended();
    if (!status && status.error().kind != ErrorKind::Cancelled) {
        emit failed(QString::fromStdString(status.error().message));
    }
}

} // namespace trixel::ui
