// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QTimer>

#include "core/base/result.h"
#include "ui/document/background_job.h"

#include <utility>

namespace trixel::ui {

/// Something measured in the background, what it finds shown as it comes. What was found stays
/// until the next run, also when it was cancelled.
class MeasuredRun : public QObject
{
    Q_OBJECT

public:
    void cancel();
    bool isRunning() const { return m_running; }
    /// Done so far, in [0, 1].
    double fraction() const;

signals:
    void started();
    /// There is more to show, or better.
    void grew();
    void progressed();
    void ended();
    /// One sentence about why there is no result.
    void failed(const QString& sentence);

protected:
    explicit MeasuredRun(BackgroundJobs& jobs, QObject* parent);

    /// Starts what is not running yet (checked).
    /// \param work  Progress& → Result<T>, on another thread
    /// \param keep  called with the T when all is done
    template <class Work, class Keep>
    void launch(const QString& title, Work work, Keep keep)
    {
        begin();
        const auto done = [self = QPointer(this), keep = std::move(keep)](auto result) mutable {
            if (!self) {
                return;
            }
            self->stop();
            if (result) {
                keep(std::move(*result));
                self->finish({});
            } else {
                self->finish(tl::unexpected(result.error()));
            }
        };
        watch(m_jobs.run(title, std::move(work), done));
    }

private:
    /// Takes what was found since the last time; whether there was anything.
    virtual bool take() = 0;
    /// The work ended without its result: what was found has to do.
    virtual void settle() {}

    void begin();
    void watch(BackgroundJob& job);
    void stop();
    void finish(const Status& status);

    BackgroundJobs& m_jobs;
    QPointer<BackgroundJob> m_job;
    QTimer m_timer;
    bool m_running = false;
};

} // namespace trixel::ui
