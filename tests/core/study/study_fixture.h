// SPDX-License-Identifier: GPL-3.0-or-later
//
// A small subject whose answers are known, contestants that are wrong by a known amount, and a
// watcher that remembers.
#pragma once

#include "core/study/speed/speed_accuracy.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace trixel::test {

/// Both stored textures, on a single tile: some 1,700 footprints each.
inline const std::vector<StudySubject>& smallSubjects()
{
    static const std::vector<StudySubject> subjects = [] {
        NoProgress progress;
        return storedSubjects(1, Threads{2}, progress).value();
    }();
    return subjects;
}

/// What a fake contestant answers, given the truth; nothing: it refuses.
using Answer = std::function<std::optional<float>(
    const StudySubject& subject, std::size_t query, std::size_t channel, float truth)>;

/// Knows the truth and answers as told.
class Fake final : public Contestant
{
public:
    Fake(std::string series, const std::vector<StudySubject>& subjects, Answer answer)
        : Contestant(std::move(series), "", std::nullopt)
        , m_subjects(subjects)
        , m_answer(std::move(answer))
    {
    }

    std::unique_ptr<PreparedQueries> prepare(std::size_t subject,
                                             const FilterQueries& queries) const override
    {
        return std::make_unique<Prepared>(m_subjects[subject], queries, m_answer);
    }

private:
    class Prepared final : public PreparedQueries
    {
    public:
        Prepared(const StudySubject& subject, FilterQueries queries, const Answer& answer)
            : m_subject(subject)
            , m_answer(answer)
        {
            // By the centre's u, which no two queries share.
            for (std::size_t i = 0; i < queries.size(); ++i) {
                const auto& all = m_subject.queries;
                std::size_t k = 0;
                while (all.u[k] != queries.u[i] || all.v[k] != queries.v[i]) {
                    ++k;
                }
                m_indices.push_back(k);
            }
        }

        void run(const FilterResults& results) const override
        {
            const std::size_t channels = static_cast<std::size_t>(m_subject.scene->channels());
            for (std::size_t i = 0; i < m_indices.size(); ++i) {
                for (std::size_t c = 0; c < channels; ++c) {
                    const std::size_t count = m_subject.queries.size();
                    const auto answer = m_answer(
                        m_subject, m_indices[i], c, m_subject.exact[c * count + m_indices[i]]);
                    results.values[c * results.stride + i] = answer.value_or(0);
                    if (!results.taps.empty()) {
                        results.taps[i] = answer ? 1 : kRefusedTaps;
                    }
                }
            }
        }

    private:
        const StudySubject& m_subject;
        const Answer& m_answer;
        std::vector<std::size_t> m_indices;
    };

    const std::vector<StudySubject>& m_subjects;
    Answer m_answer;
};

class RememberingWatcher final : public StudyWatcher
{
public:
    explicit RememberingWatcher(int reportsAllowed = 1 << 30)
        : m_allowed(reportsAllowed)
    {
    }
    bool report(double fraction) override
    {
        fractions.push_back(fraction);
        return static_cast<int>(fractions.size()) <= m_allowed;
    }
    void measured(const StudyPoint& point) override { points.push_back(point); }

    std::vector<StudyPoint> points;
    std::vector<double> fractions;

private:
    int m_allowed;
};

} // namespace trixel::test
