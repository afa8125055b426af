// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QTimer>

#include "ui/docks/chart_study.h"
#include "ui/docks/inbox.h"

#include <map>
#include <memory>
#include <tuple>

namespace trixel::ui {

class BackgroundJob;
class BackgroundJobs;

/// A study under way in the background, and what it has measured so far. What was measured stays
/// until the next run, also when it was cancelled.
class ChartRun : public QObject
{
    Q_OBJECT

public:
    explicit ChartRun(BackgroundJobs& jobs, QObject* parent = nullptr);

    /// Does nothing while a study runs.
    void start(const StudyOffer& offer, StudyInput input);
    void cancel();
    bool isRunning() const { return m_running; }
    /// Done so far, in [0, 1].
    double fraction() const;
    const Study& study() const { return m_study; }

signals:
    void started();
    /// The study has more points, or better ones.
    void grew();
    void progressed();
    void ended();
    /// One sentence about why there is no result.
    void failed(const QString& sentence);

private:
    using Key = std::tuple<std::string, std::string, std::optional<FootprintClass>>;
    void takePoints();
    void add(const StudyPoint& point);
    void finish(Result<Study> result);

    BackgroundJobs& m_jobs;
    QPointer<BackgroundJob> m_job;
    std::shared_ptr<Inbox<StudyPoint>> m_inbox;
    QTimer m_timer;
    Study m_study;
    std::map<Key, std::size_t> m_places; ///< of the points, by who they are
    bool m_running = false;
};

} // namespace trixel::ui
