// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFutureWatcher>
#include <QSignalSpy>
#include <QTest>
#include <QThread>

#include "ui/document/background_job.h"
#include "ui/document/run_within_memory.h"

#include <atomic>
#include <new>

namespace trixel::ui {

class BackgroundJobTest : public QObject
{
    Q_OBJECT

private slots:
    void workRunsElsewhereAndItsValueComesBackHere()
    {
        BackgroundJobs jobs;
        QThread* worker = nullptr;
        std::optional<int> answer;
        jobs.run(
            "sum",
            [&worker](Progress&) -> Result<int> {
                worker = QThread::currentThread();
                return 42;
            },
            [&answer, this](const Result<int>& result) {
                QCOMPARE(QThread::currentThread(), thread());
                answer = result.value();
            });
        QTRY_VERIFY(answer.has_value());
        QCOMPARE(*answer, 42);
        QVERIFY(worker != thread());
        QVERIFY(jobs.isIdle());
    }

    void workThatRunsOutOfMemoryKeepsTheResultsItHas()
    {
        const auto future = runWithinMemory<int>([](QPromise<int>& promise) {
            promise.addResult(1);
            throw std::bad_alloc();
        });
        QFutureWatcher<int> watcher;
        watcher.setFuture(future);
        watcher.waitForFinished(); // as owners do when they go: it must not throw
        QCOMPARE(future.resultCount(), 1);
        QCOMPARE(watcher.resultAt(0), 1);
    }

    void progressIsToldAndNeverGoesBack()
    {
        BackgroundJobs jobs;
        std::vector<double> seen;
        bool ended = false;
        BackgroundJob& job = jobs.run(
            "steps",
            [](Progress& progress) -> Status {
                for (const double fraction : {0.2, 0.5, 0.4, 0.9}) {
                    if (!progress.report(fraction)) {
                        return cancelled();
                    }
                    QThread::msleep(60); // progress is told at most so often
                }
                return {};
            },
            [&ended](const Status& status) { ended = status.has_value(); });
        connect(&job, &BackgroundJob::progressed, this, [&] { seen.push_back(job.fraction()); });
        QTRY_VERIFY(ended);
        QVERIFY(seen.size() >= 2);
        QVERIFY(std::is_sorted(seen.begin(), seen.end()));
        QVERIFY(seen.back() >= 0.5);
    }

    void cancelStopsTheWorkAndDropsItsValue()
    {
        BackgroundJobs jobs;
        std::atomic<bool> started = false;
        std::optional<Result<int>> outcome;
        BackgroundJob& job = jobs.run(
            "long",
            [&started](Progress& progress) -> Result<int> {
                started = true;
                while (progress.report(0.5)) {
                    QThread::msleep(1);
                }
                return 7; // too late
            },
            [&outcome](const Result<int>& result) { outcome = result; });
        QTRY_VERIFY(started);
        job.cancel();
        QVERIFY(job.isCancelled());
        QTRY_VERIFY(outcome.has_value());
        QVERIFY(!outcome->has_value());
        QCOMPARE(outcome->error().kind, ErrorKind::Cancelled);
    }

    void fileWrittenDespiteCancelIsNotDenied()
    {
        BackgroundJobs jobs;
        std::atomic<bool> started = false;
        std::atomic<bool> goOn = false;
        std::optional<Status> outcome;
        BackgroundJob& job = jobs.run(
            "save",
            [&started, &goOn](Progress&) -> Status {
                started = true;
                while (!goOn) {
                    QThread::msleep(1);
                }
                return {};
            },
            [&outcome](const Status& status) { outcome = status; });
        QTRY_VERIFY(started);
        job.cancel();
        goOn = true;
        QTRY_VERIFY(outcome.has_value());
        QVERIFY(outcome->has_value());
    }

    void workCancelledBeforeItBeganIsCancelled()
    {
        BackgroundJobs jobs;
        std::optional<Status> outcome;
        jobs.run(
                "never",
                [](Progress&) -> Status { return {}; },
                [&outcome](const Status& status) { outcome = status; })
            .cancel();
        QTRY_VERIFY(outcome.has_value());
        // It may have run before it heard; either way nothing is made up.
        QVERIFY(outcome->has_value() || outcome->error().kind == ErrorKind::Cancelled);
    }

    void wantOfMemoryIsAnErrorWithASentence()
    {
        BackgroundJobs jobs;
        std::optional<Result<int>> outcome;
        jobs.run(
            "huge",
            [](Progress&) -> Result<int> { throw std::bad_alloc(); },
            [&outcome](const Result<int>& result) { outcome = result; });
        QTRY_VERIFY(outcome.has_value());
        QVERIFY(!outcome->has_value());
        QVERIFY(outcome->error().message.find("memory") != std::string::npos);
    }

    void workStartsAtOnceHoweverMuchIsUnderWay()
    {
        BackgroundJobs jobs;
        const int crowd = 2 * QThread::idealThreadCount() + 2;
        std::atomic<int> waiting = 0;
        std::atomic<bool> mayEnd = false;
        for (int k = 0; k < crowd; ++k) {
            jobs.run(
                "study",
                [&](Progress&) -> Status {
                    ++waiting;
                    while (!mayEnd) {
                        QThread::msleep(1);
                    }
                    return {};
                },
                [](const Status&) {});
        }
        bool saved = false;
        jobs.run(
            "save", [](Progress&) { return Status(); }, [&](const Status&) { saved = true; });
        const bool atOnce = QTest::qWaitFor([&] { return saved && waiting == crowd; });
        mayEnd = true;
        QVERIFY(atOnce);
    }

    void dyingWaitsForTheWorkAndDropsItsAnswer()
    {
        std::atomic<bool> finished = false;
        bool told = false;
        {
            BackgroundJobs jobs;
            std::atomic<bool> started = false;
            jobs.run(
                "long",
                [&](Progress& progress) -> Status {
                    started = true;
                    while (progress.report(0.0)) {
                        QThread::msleep(1);
                    }
                    finished = true;
                    return {};
                },
                [&told](const Status&) { told = true; });
            QTRY_VERIFY(started);
        }
        QVERIFY(finished);
        QCoreApplication::processEvents();
        QVERIFY(!told);
    }
};

} // namespace trixel::ui

QTEST_MAIN(trixel::ui::BackgroundJobTest)
#include "tst_background_job.moc"
