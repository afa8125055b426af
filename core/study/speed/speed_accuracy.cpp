// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/speed/speed_accuracy.h"

#include "core/study/machine.h"
#include "core/study/speed/auto_contestants.h"
#include "core/study/speed/contest_run.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

namespace trixel {
namespace {

std::string nameOf(const Contestant& contestant)
{
    return contestant.series() + (contestant.variant().empty() ? "" : ", " + contestant.variant());
}

std::string tooSlow(const Contestant& contestant, double seconds, std::size_t step)
{
    std::ostringstream text;
    text.precision(2);
    text << nameOf(contestant);
    if (step > 0) {
        text << " was measured on one footprint in " << step;
    } else {
        text << " was left out";
    }
    text << ": one pass over all would take about " << seconds << " s of processor time.";
    return text.str();
}

std::string refusedSome(const Contestant& contestant, std::uint64_t count)
{
    return nameOf(contestant) + " refused " + std::to_string(count) +
           " footprints; they are left out of its figures.";
}

Study describe(const std::vector<StudySubject>& subjects, const SpeedAccuracyOptions& options)
{
    Study study;
    study.name = "speed-accuracy";
    study.title = "Filters: time against error";
    study.costTitle = "Time per sample";
    study.costUnit = "ns";
    std::size_t queries = 0;
    for (const StudySubject& subject : subjects) {
        study.subject += (study.subject.empty() ? "" : ", ") + subject.name;
        queries += subject.queries.size();
    }
    std::ostringstream conditions;
    conditions << machineText() << "; one thread's processor time, least of up to "
               << options.rounds << " interleaved rounds; " << queries << " footprints, "
               << subjects.front().scene->channels() << " channels";
    study.conditions = conditions.str();
    return study;
}

void tell(const ContestRun& run, StudyWatcher& watcher)
{
    for (const StudyPoint& point : run.points()) {
        watcher.measured(point);
    }
}

/// Everyone who is measured, in the course of the study.
class Contest
{
public:
    Contest(const std::vector<StudySubject>& subjects,
            const SpeedAccuracyOptions& options,
            StudyWatcher& watcher)
        : m_subjects(subjects)
        , m_options(options)
        , m_watcher(watcher)
        , m_batches(std::make_shared<const std::vector<QueryBatch>>(makeBatches(subjects)))
        , m_study(describe(subjects, options))
    {
    }

    void enter(const Contestant& contestant)
    {
        auto run = std::make_unique<ContestRun>(m_subjects, contestant);
        const double expected = run->estimatedSeconds();
        if (expected <= m_options.secondsAtMost) {
            run->judge(m_batches, false);
        } else if (const std::size_t step = thinning(expected); step > 0) {
            m_study.notes.push_back(tooSlow(contestant, expected, step));
            run->judge(std::make_shared<const std::vector<QueryBatch>>(
                           thinned(m_subjects, *m_batches, step)),
                       true);
        } else {
            m_study.notes.push_back(tooSlow(contestant, expected, 0));
            return;
        }
        const auto points = run->points();
        if (run->hasRefused()) {
            m_study.notes.push_back(
                refusedSome(contestant, points.empty() ? m_batches->size() : points[0].refused));
        }
        tell(*run, m_watcher);
        const double affordable = m_options.secondsOfRounds / std::max(run->secondsOfRound(), 1e-9);
        m_rounds.push_back(static_cast<int>(std::min(affordable, double(m_options.rounds))));
        m_runs.push_back(std::move(run));
    }

    bool timeRounds(Progress& progress)
    {
        for (int round = 0; round < m_options.rounds; ++round) {
            for (std::size_t r = 0; r < m_runs.size(); ++r) {
                const double done =
                    round + static_cast<double>(r) / static_cast<double>(m_runs.size());
                if (!progress.report(done / m_options.rounds)) {
                    return false;
                }
                if (round < m_rounds[r]) {
                    m_runs[r]->time();
                }
            }
        }
        return true;
    }

    /// What is known so far.
    Study measured() const
    {
        Study study = m_study;
        for (const auto& run : m_runs) {
            const auto points = run->points();
            study.points.insert(study.points.end(), points.begin(), points.end());
        }
        return study;
    }

    Study finish()
    {
        m_study = measured();
        markFront(m_study.points);
        for (const StudyPoint& point : m_study.points) {
            m_watcher.measured(point);
        }
        return std::move(m_study);
    }

private:
    /// One query in how many is affordable; 0: too few.
    std::size_t thinning(double expected) const
    {
        constexpr double kMostThinning = 200;
        const double step = std::ceil(expected / m_options.secondsAtMost);
        return step >= 1 && step <= kMostThinning ? static_cast<std::size_t>(step) : 0;
    }

    const std::vector<StudySubject>& m_subjects;
    const SpeedAccuracyOptions& m_options;
    StudyWatcher& m_watcher;
    std::shared_ptr<const std::vector<QueryBatch>> m_batches;
    Study m_study;
    std::vector<std::unique_ptr<ContestRun>> m_runs;
    std::vector<int> m_rounds; // of each run
};

} // namespace

Result<Study> measureSpeedAccuracy(const std::vector<StudySubject>& subjects,
                                   const Contestants& contestants,
                                   const SpeedAccuracyOptions& options,
                                   StudyWatcher& watcher)
{
    check(!subjects.empty(), "a subject to measure on");
    Contestants chosen; // outlive the contest
    Contest contest(subjects, options, watcher);
    StageProgress judging(watcher, 0, 0.4);
    for (std::size_t k = 0; k < contestants.size(); ++k) {
        if (!judging.report(static_cast<double>(k) / static_cast<double>(contestants.size()))) {
            return cancelled();
        }
        contest.enter(*contestants[k]);
    }
    if (options.withAuto) {
        chosen = autoContestants(contest.measured(), subjects);
        for (const auto& contestant : chosen) {
            contest.enter(*contestant);
        }
    }
    StageProgress timing(watcher, 0.4, 1);
    if (!contest.timeRounds(timing)) {
        return cancelled();
    }
    return contest.finish();
}

std::string machineText()
{
    return toText(thisMachine());
}

} // namespace trixel
