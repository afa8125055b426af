// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is measured in the background, seen apart from the panels that show it.
#include <QSignalSpy>
#include <QTest>
#include <QThread>

#include "tests/ui/charts/made_up_study.h"
#include "ui/docks/chart_run.h"
#include "ui/docks/stability_run.h"

#include <atomic>
#include <memory>
#include <string>

namespace trixel::ui {

namespace {

/// Work that finds one thing, then waits to be let go or cancelled.
struct FakeWork
{
    std::atomic<bool> mayEnd = false;
    std::atomic<int> runs = 0;
    std::atomic<int> ends = 0;

    bool waitToEnd(Progress& progress)
    {
        bool goOn = true;
        while (!mayEnd && goOn) {
            goOn = progress.report(0.5);
            QThread::msleep(1);
        }
        ++ends;
        return goOn;
    }

    Result<Study> study(StudyWatcher& watcher)
    {
        ++runs;
        const Study whole = madeUpStudy();
        watcher.measured(whole.points.front());
        return waitToEnd(watcher) ? Result<Study>(whole) : cancelled();
    }

    Result<StabilityReport> sweeps(StabilityWatcher& watcher)
    {
        ++runs;
        StabilitySweep sweep;
        sweep.name = "first";
        watcher.swept(sweep);
        StabilityReport report;
        report.sweeps.assign(2, sweep);
        return waitToEnd(watcher) ? Result<StabilityReport>(report) : cancelled();
    }
};

/// A study's run and what it has found.
struct StudyRun
{
    static std::unique_ptr<ChartRun> make(BackgroundJobs& jobs, std::shared_ptr<FakeWork> /*work*/)
    {
        return std::make_unique<ChartRun>(jobs);
    }
    static void start(ChartRun& run, const std::shared_ptr<FakeWork>& work)
    {
        StudyOffer offer;
        offer.title = "Made up";
        offer.run = [work](const StudyInput& /*input*/, StudyWatcher& watcher) {
            return work->study(watcher);
        };
        run.start(offer, {});
    }
    static std::size_t found(const ChartRun& run) { return run.study().points.size(); }
    static std::size_t all() { return madeUpStudy().points.size(); }
};

/// The same for sweeps.
struct SweepRun
{
    static std::unique_ptr<StabilityRun> make(BackgroundJobs& jobs, std::shared_ptr<FakeWork> work)
    {
        return std::make_unique<StabilityRun>(
            jobs, [work](const StabilityInput& /*input*/, StabilityWatcher& watcher) {
                return work->sweeps(watcher);
            });
    }
    static void start(StabilityRun& run, const std::shared_ptr<FakeWork>& /*work*/)
    {
        run.start({});
    }
    static std::size_t found(const StabilityRun& run) { return run.report().sweeps.size(); }
    static std::size_t all() { return 2; }
};

template <class Kind>
void startedTwiceItRunsOnce()
{
    BackgroundJobs jobs;
    const auto work = std::make_shared<FakeWork>();
    const auto run = Kind::make(jobs, work);
    QSignalSpy started(run.get(), &MeasuredRun::started);
    QSignalSpy ended(run.get(), &MeasuredRun::ended);
    Kind::start(*run, work);
    QTRY_COMPARE(Kind::found(*run), std::size_t(1));
    Kind::start(*run, work);
    QCOMPARE(Kind::found(*run), std::size_t(1)); // nor does it forget
    QCOMPARE(started.size(), 1);
    work->mayEnd = true;
    QTRY_VERIFY(!run->isRunning());
    QTRY_VERIFY(jobs.isIdle());
    QCOMPARE(work->runs, 1);
    QCOMPARE(ended.size(), 1);
    QCOMPARE(Kind::found(*run), Kind::all());
}

template <class Kind>
void cancelledItKeepsWhatItFoundAndSaysNothing()
{
    BackgroundJobs jobs;
    const auto work = std::make_shared<FakeWork>();
    const auto run = Kind::make(jobs, work);
    QSignalSpy failed(run.get(), &MeasuredRun::failed);
    QSignalSpy ended(run.get(), &MeasuredRun::ended);
    Kind::start(*run, work);
    // At once: what was found is not even shown yet.
    QTRY_COMPARE(work->runs, 1);
    run->cancel();
    QTRY_COMPARE(ended.size(), 1);
    QCOMPARE(Kind::found(*run), std::size_t(1));
    QVERIFY(!run->isRunning());
    QCOMPARE(failed.size(), 0);
}

/// Its panel may be closed, or the window, while the work goes on.
template <class Kind>
void deadItIsNotToldOfTheEnd()
{
    BackgroundJobs jobs;
    const auto work = std::make_shared<FakeWork>();
    auto run = Kind::make(jobs, work);
    Kind::start(*run, work);
    QTRY_COMPARE(work->runs, 1);
    run.reset();
    work->mayEnd = true;
    QTRY_VERIFY(jobs.isIdle());
    QCOMPARE(work->ends, 1);
}

template <class Kind>
void itOutlivesTheJobs()
{
    auto jobs = std::make_unique<BackgroundJobs>();
    const auto work = std::make_shared<FakeWork>();
    const auto run = Kind::make(*jobs, work);
    Kind::start(*run, work);
    QTRY_COMPARE(work->runs, 1);
    jobs.reset();
    QCOMPARE(work->ends, 1);
    run->cancel();
    QCOMPARE(run->fraction(), 0.0);
}

} // namespace

class MeasuredRunTest : public QObject
{
    Q_OBJECT

private slots:
    void aStudyStartedTwiceRunsOnce() { startedTwiceItRunsOnce<StudyRun>(); }
    void sweepsStartedTwiceRunOnce() { startedTwiceItRunsOnce<SweepRun>(); }
    void aCancelledStudyKeepsItsPoints() { cancelledItKeepsWhatItFoundAndSaysNothing<StudyRun>(); }
    void cancelledSweepsKeepThoseDone() { cancelledItKeepsWhatItFoundAndSaysNothing<SweepRun>(); }
    void aStudyOutlivesItsRun() { deadItIsNotToldOfTheEnd<StudyRun>(); }
    void sweepsOutliveTheirRun() { deadItIsNotToldOfTheEnd<SweepRun>(); }
    void aRunOfAStudyOutlivesTheJobs() { itOutlivesTheJobs<StudyRun>(); }
    void aRunOfSweepsOutlivesTheJobs() { itOutlivesTheJobs<SweepRun>(); }
};

} // namespace trixel::ui

QTEST_MAIN(trixel::ui::MeasuredRunTest)
#include "tst_measured_run.moc"
