// SPDX-License-Identifier: GPL-3.0-or-later
//
// One contestant in the course of a study: what it took so far and how wrong it was.
#pragma once

#include "core/study/error_sums.h"
#include "core/study/speed/query_batches.h"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace trixel {

class ContestRun
{
public:
    /// \param subjects, contestant  outlive the run
    ContestRun(const std::vector<StudySubject>& subjects, const Contestant& contestant);

    /// Processor time for one pass over all queries, as a few of them let expect.
    double estimatedSeconds() const;

    /// The first pass: judges every answer and times the classes. Queries that are refused do not
    /// count from then on.
    /// \param batches  of the subjects' queries, all or some
    /// \param partly   whether they are some
    void judge(const std::shared_ptr<const std::vector<QueryBatch>>& batches, bool partly);

    /// Times every batch once more; the least time of each counts.
    void time();

    /// Processor time of one pass over classes and mixtures, after `judge`.
    double secondsOfRound() const;

    bool hasRefused() const { return m_hasRefused; }

    /// One for all footprints, then one a class that occurs.
    std::vector<StudyPoint> points() const;

private:
    struct Timed
    {
        std::unique_ptr<PreparedQueries> prepared;
        double seconds = 0; ///< least so far; 0: never timed
    };

    void prepare(std::shared_ptr<const std::vector<QueryBatch>> batches);
    double timeOnce(const PreparedQueries& prepared, std::size_t count, int repeats) const;
    void
    judgeBatch(const QueryBatch& batch, const Timed& timed, std::vector<std::vector<bool>>& kept);
    StudyPoint pointOf(std::optional<FootprintClass> footprintClass) const;
    int channels() const { return m_subjects.front().scene->channels(); }

    const std::vector<StudySubject>& m_subjects;
    const Contestant& m_contestant;
    std::shared_ptr<const std::vector<QueryBatch>> m_batches;
    std::vector<Timed> m_timed; // by batch
    std::array<ErrorSums, kFootprintClasses> m_errors;
    std::array<std::uint64_t, kFootprintClasses> m_refused{};
    bool m_hasRefused = false;
    bool m_partly = false;
};

} // namespace trixel
