// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <QPromise>
#include <QString>
#include <QThreadPool>

#include "core/base/progress.h"
#include "core/base/result.h"

#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace trixel::ui {

/// Work on another thread as the GUI thread sees it: a title, how far it is, and Cancel.
class BackgroundJob : public QObject
{
    Q_OBJECT

public:
    const QString& title() const { return m_title; }
    /// Done so far, in [0, 1].
    double fraction() const;
    /// Asks the work to stop; it ends, with or without a result, a little later.
    void cancel();
    bool isCancelled() const { return m_cancelled; }

signals:
    void progressed();
    void cancelRequested();

private:
    friend class BackgroundJobs;
    BackgroundJob(const QString& title, QObject* parent);
    void start(QThreadPool& threads, std::function<void(Progress&)> work);

    QString m_title;
    QFutureWatcher<void> m_watcher;
    bool m_cancelled = false;
};

/// Runs work away from the GUI thread and brings the answers back to it. No work waits for other
/// work: a save starts at once while a study runs. Answers of work still running when this object
/// dies are dropped, after waiting for the work to stop.
class BackgroundJobs : public QObject
{
    Q_OBJECT

public:
    explicit BackgroundJobs(QObject* parent = nullptr);
    ~BackgroundJobs() override;

    /// Starts `work(Progress&)`, which returns `Result<T>`, on another thread; it may refer only to
    /// what it owns. `done(Result<T>)` is then called on this thread. A value that arrives after
    /// Cancel becomes `Cancelled`; the outcome of work that returns no value (a file written) is
    /// told as it is.
    template <class Work, class Done>
    BackgroundJob& run(const QString& title, Work work, Done done)
    {
        using Outcome = std::invoke_result_t<Work, Progress&>;
        auto outcome = std::make_shared<std::optional<Outcome>>();
        const auto store = [outcome, work = std::move(work)](Progress& progress) mutable {
            outcome->emplace(work(progress));
        };
        const auto deliver = [outcome, done = std::move(done)](bool wasCancelled) mutable {
            Outcome result = *outcome ? std::move(**outcome) : Outcome(missing(wasCancelled));
            if constexpr (!std::is_void_v<typename Outcome::value_type>) {
                if (wasCancelled) {
                    result = cancelled();
                }
            }
            done(std::move(result));
        };
        return add(title, store, deliver);
    }

    bool isIdle() const { return m_jobs.empty(); }
    /// The job that started last; null when idle.
    BackgroundJob* latest() const { return m_jobs.empty() ? nullptr : m_jobs.back(); }

signals:
    void started(trixel::ui::BackgroundJob* job);
    /// After `done` was called; the job dies when control returns to the event loop.
    void ended(trixel::ui::BackgroundJob* job);

private:
    /// Why work left no outcome: it was cancelled before it began, or memory ran out.
    static tl::unexpected<Error> missing(bool wasCancelled);
    BackgroundJob& add(const QString& title,
                       std::function<void(Progress&)> work,
                       std::function<void(bool cancelled)> deliver);

    QThreadPool m_threads;              // of its own, as many as there are jobs
    std::vector<BackgroundJob*> m_jobs; // children, in the order they started
};

} // namespace trixel::ui
