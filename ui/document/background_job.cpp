// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/background_job.h"

#include <QtConcurrent>

#include <algorithm>
#include <limits>
#include <new>

namespace trixel::ui {

namespace {

constexpr int kProgressSteps = 1000;

/// Core's view of a promise.
class PromiseProgress final : public Progress
{
public:
    explicit PromiseProgress(QPromise<void>& promise)
        : m_promise(promise)
    {
        m_promise.setProgressRange(0, kProgressSteps);
    }

    bool report(double fraction) override
    {
        const int step = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * kProgressSteps);
        if (step > m_step) {
            m_step = step;
            m_promise.setProgressValue(step);
        }
        return !m_promise.isCanceled();
    }

private:
    QPromise<void>& m_promise;
    int m_step = 0;
};

} // namespace

BackgroundJob::BackgroundJob(const QString& title, QObject* parent)
    : QObject(parent)
    , m_title(title)
{
    connect(
        &m_watcher, &QFutureWatcher<void>::progressValueChanged, this, &BackgroundJob::progressed);
}

double BackgroundJob::fraction() const
{
    return static_cast<double>(m_watcher.progressValue()) / kProgressSteps;
}

void BackgroundJob::cancel()
{
    m_cancelled = true;
    m_watcher.cancel();
    emit cancelRequested();
}

void BackgroundJob::start(QThreadPool& threads, std::function<void(Progress&)> work)
{
    m_watcher.setFuture(
        QtConcurrent::run(&threads, [work = std::move(work)](QPromise<void>& promise) {
            PromiseProgress progress(promise);
            try {
                work(progress);
            } catch (const std::bad_alloc&) {
                // Leaves no outcome, which is told as want of memory.
            }
        }));
}

BackgroundJobs::BackgroundJobs(QObject* parent)
    : QObject(parent)
{
    m_threads.setMaxThreadCount(std::numeric_limits<int>::max());
}

BackgroundJobs::~BackgroundJobs()
{
    for (BackgroundJob* job : m_jobs) {
        job->disconnect();
        job->m_watcher.disconnect();
        job->m_watcher.cancel();
    }
    for (BackgroundJob* job : m_jobs) {
        job->m_watcher.waitForFinished();
    }
}

tl::unexpected<Error> BackgroundJobs::missing(bool wasCancelled)
{
    return wasCancelled ? cancelled() : contentsError("There is not enough memory for this.");
}

BackgroundJob& BackgroundJobs::add(const QString& title,
                                   std::function<void(Progress&)> work,
                                   std::function<void(bool cancelled)> deliver)
{
    auto* job = new BackgroundJob(title, this);
    m_jobs.push_back(job);
    connect(&job->m_watcher,
            &QFutureWatcher<void>::finished,
            this,
            [this, job, deliver = std::move(deliver)] {
                std::erase(m_jobs, job);
                deliver(job->isCancelled());
                emit ended(job);
                job->deleteLater();
            });
    job->start(m_threads, std::move(work));
    emit started(job);
    return *job;
}

} // namespace trixel::ui
