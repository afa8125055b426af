// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/speed/contest_run.h"

#include "core/study/processor_clock.h"

#include <algorithm>
#include <cmath>

namespace trixel {
namespace {

/// A batch that takes less is run several times in a row: the clock itself takes a microsecond.
constexpr double kShortestTiming = 200e-6;
constexpr int kMostRepeats = 256;
constexpr std::size_t kPilotQueries = 48;

} // namespace

ContestRun::ContestRun(const std::vector<StudySubject>& subjects, const Contestant& contestant)
    : m_subjects(subjects)
    , m_contestant(contestant)
{
}

double ContestRun::estimatedSeconds() const
{
    double seconds = 0;
    for (std::size_t s = 0; s < m_subjects.size(); ++s) {
        const QueryBatch batch = sparseBatch(m_subjects[s], s, kPilotQueries);
        if (batch.queries.size() == 0) {
            continue;
        }
        const auto prepared = m_contestant.prepare(s, batch.queries.queries());
        seconds += timeOnce(*prepared, batch.queries.size(), 1) *
                   static_cast<double>(m_subjects[s].queries.size()) /
                   static_cast<double>(batch.queries.size());
    }
    return seconds;
}

void ContestRun::prepare(std::shared_ptr<const std::vector<QueryBatch>> batches)
{
    m_batches = std::move(batches);
    m_timed.clear();
    for (const QueryBatch& batch : *m_batches) {
        m_timed.push_back({m_contestant.prepare(batch.subject, batch.queries.queries()), 0});
    }
}

double ContestRun::timeOnce(const PreparedQueries& prepared, std::size_t count, int repeats) const
{
    std::vector<float> values(count * static_cast<std::size_t>(channels()));
    const FilterResults results{values, count, {}, {}};
    const double begin = processorSeconds();
    for (int k = 0; k < repeats; ++k) {
        prepared.run(results);
    }
    return (processorSeconds() - begin) / repeats;
}

void ContestRun::judgeBatch(const QueryBatch& batch,
                            const Timed& timed,
                            std::vector<std::vector<bool>>& kept)
{
    const StudySubject& subject = m_subjects[batch.subject];
    const std::size_t count = batch.indices.size();
    ResultArrays answers(count, channels());
    timed.prepared->run(answers.results());
    const auto number = static_cast<std::size_t>(*batch.footprintClass);
    for (std::size_t i = 0; i < count; ++i) {
        if (answers.taps[i] == kRefusedTaps) {
            ++m_refused[number];
            m_hasRefused = true;
            kept[batch.subject][batch.indices[i]] = false;
            continue;
        }
        for (std::size_t c = 0; c < static_cast<std::size_t>(channels()); ++c) {
            const float truth = subject.exact[c * subject.queries.size() + batch.indices[i]];
            m_errors[number].add(static_cast<double>(answers.values[c * count + i]),
                                 static_cast<double>(truth),
                                 subject.range);
        }
    }
}

void ContestRun::judge(const std::shared_ptr<const std::vector<QueryBatch>>& batches, bool partly)
{
    m_partly = partly;
    prepare(batches);
    std::vector<std::vector<bool>> kept;
    for (const StudySubject& subject : m_subjects) {
        kept.emplace_back(subject.queries.size());
    }
    for (const QueryBatch& batch : *m_batches) {
        for (const std::size_t i : batch.indices) {
            kept[batch.subject][i] = true;
        }
    }
    for (std::size_t b = 0; b < m_batches->size(); ++b) {
        const QueryBatch& batch = (*m_batches)[b];
        if (batch.footprintClass) {
            const double begin = processorSeconds();
            judgeBatch(batch, m_timed[b], kept);
            m_timed[b].seconds = processorSeconds() - begin;
        }
    }
    if (m_hasRefused) {
        prepare(std::make_shared<const std::vector<QueryBatch>>(makeBatches(m_subjects, kept)));
        time();
    }
}

void ContestRun::time()
{
    for (std::size_t b = 0; b < m_timed.size(); ++b) {
        Timed& timed = m_timed[b];
        const std::size_t count = (*m_batches)[b].indices.size();
        if (count == 0) {
            continue;
        }
        const double expected = std::max(timed.seconds, 1e-7);
        const int repeats =
            timed.seconds > 0
                ? static_cast<int>(
                      std::clamp(std::ceil(kShortestTiming / expected), 1.0, double{kMostRepeats}))
                : 1;
        const double seconds = timeOnce(*timed.prepared, count, repeats);
        timed.seconds = timed.seconds > 0 ? std::min(timed.seconds, seconds) : seconds;
    }
}

double ContestRun::secondsOfRound() const
{
    double classes = 0;
    for (std::size_t b = 0; b < m_timed.size(); ++b) {
        classes += (*m_batches)[b].footprintClass ? m_timed[b].seconds : 0;
    }
    return 2 * classes;
}

StudyPoint ContestRun::pointOf(std::optional<FootprintClass> footprintClass) const
{
    StudyPoint point;
    point.series = m_contestant.series();
    point.variant = m_contestant.variant();
    point.method = m_contestant.method();
    point.footprintClass = footprintClass;
    point.partly = m_partly;
    ErrorSums errors;
    for (std::size_t k = 0; k < m_errors.size(); ++k) {
        if (!footprintClass || k == static_cast<std::size_t>(*footprintClass)) {
            errors.join(m_errors[k]);
            point.refused += m_refused[k];
        }
    }
    errors.tell(point);
    double ofClasses = 0;
    double ofMixture = 0;
    bool mixtureTimed = true;
    for (std::size_t b = 0; b < m_timed.size(); ++b) {
        const QueryBatch& batch = (*m_batches)[b];
        if (!batch.footprintClass) {
            ofMixture += m_timed[b].seconds;
            mixtureTimed = mixtureTimed && m_timed[b].seconds > 0;
        } else if (!footprintClass || batch.footprintClass == footprintClass) {
            ofClasses += m_timed[b].seconds;
            point.samples += batch.indices.size();
        }
    }
    const double seconds = !footprintClass && mixtureTimed ? ofMixture : ofClasses;
    point.cost = point.samples > 0 ? 1e9 * seconds / static_cast<double>(point.samples) : 0;
    return point;
}

std::vector<StudyPoint> ContestRun::points() const
{
    std::vector<StudyPoint> points;
    points.push_back(pointOf(std::nullopt));
    for (const FootprintClass footprintClass : footprintClasses()) {
        StudyPoint point = pointOf(footprintClass);
        if (point.samples > 0) {
            points.push_back(std::move(point));
        }
    }
    if (points.front().samples == 0) {
        points.clear(); // all was refused: nothing to place on a chart
    }
    return points;
}

} // namespace trixel
