// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/speed/contest.h"

#include "core/study/speed/prepared_filter.h"
#include "core/study/speed/spread_queries.h"
#include "core/study/value_range.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace trixel {
namespace {

class TableContestant final : public Contestant
{
public:
    TableContestant(const MethodEntry& entry,
                    std::string variant,
                    MethodChoice choice,
                    const std::vector<StudySubject>& subjects)
        : Contestant(std::string(entry.name), std::move(variant), choice)
        , m_method(makeMethod(choice))
        , m_subjects(subjects)
    {
    }

    std::unique_ptr<PreparedQueries> prepare(std::size_t subject,
                                             const FilterQueries& queries) const override
    {
        return std::make_unique<PreparedFilter<FilterMethod>>(
            *m_method, *m_subjects[subject].scene, queries);
    }

private:
    std::unique_ptr<const FilterMethod> m_method;
    const std::vector<StudySubject>& m_subjects;
};

std::string variantOf(const MethodParameter& parameter, double value)
{
    std::ostringstream text;
    text << parameter.name << ' ' << value;
    return text.str();
}

double rangeOf(const FloatMips& mips, Threads threads)
{
    const double range = valueRange(mips, threads);
    return range > 0 ? range : 1;
}

/// Drops the queries that were refused and those without a finite answer; returns how many were
/// refused.
std::uint64_t
keepAnswered(const QueryArrays& all, const ResultArrays& exact, int channels, StudySubject& out)
{
    std::uint64_t refused = 0;
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (exact.taps[i] == kRefusedTaps) {
            ++refused;
            continue;
        }
        kept.push_back(i);
        out.queries.add(
            all.face[i], {all.u[i], all.v[i]}, {all.uw1[i], all.vw1[i]}, {all.uw2[i], all.vw2[i]});
    }
    for (std::size_t c = 0; c < static_cast<std::size_t>(channels); ++c) {
        for (const std::size_t i : kept) {
            out.exact.push_back(exact.values[c * all.size() + i]);
        }
    }
    return refused;
}

} // namespace

Contestants tableContestants(const std::vector<StudySubject>& subjects)
{
    Contestants contestants;
    for (const MethodEntry& entry : filterMethods()) {
        const auto add = [&](std::string variant, std::optional<double> parameter) {
            contestants.push_back(
                std::make_unique<TableContestant>(entry,
                                                  std::move(variant),
                                                  MethodChoice{std::string(entry.name), parameter},
                                                  subjects));
        };
        if (!entry.parameter) {
            add("", std::nullopt);
            continue;
        }
        for (const double value : entry.parameter->curve) {
            add(variantOf(*entry.parameter, value), value);
        }
    }
    return contestants;
}

Result<std::vector<StudySubject>>
storedSubjects(const TestPatch& patch, Threads threads, Progress& progress)
{
    const auto data = parseTestData(storedTestFiles());
    if (!data) {
        return tl::unexpected(data.error());
    }
    std::vector<StudySubject> subjects;
    for (const TestContent content : kTestContents) {
        const double begin = 0.5 * static_cast<double>(subjects.size());
        StageProgress building(progress, begin, begin + 0.5);
        auto scene = buildTestScene(*data, content, patch, threads, building);
        if (!scene) {
            return tl::unexpected(scene.error());
        }
        StudySubject subject;
        subject.name = nameOf(content);
        if (patch.faces == TestFaces::Large) {
            subject.name += " on large faces";
        }
        NoProgress quick; // one tile has the range of all
        const auto tile =
            FloatMips::build(data->tiles[static_cast<std::size_t>(content)], threads, quick);
        subject.range = rangeOf(*tile, threads);
        subject.scene = std::make_shared<const FilterScene>(std::move(scene->scene));
        subject.queries = std::move(scene->queries);
        subject.exact = std::move(scene->exact);
        subject.content = content;
        subject.patch = patch;
        subjects.push_back(std::move(subject));
    }
    return subjects;
}

Result<StudySubject> subjectOn(std::shared_ptr<const FilterScene> scene,
                               std::string name,
                               int samples,
                               std::uint64_t seed,
                               Threads threads,
                               Progress& progress,
                               std::uint64_t* refused)
{
    const QueryArrays all = spreadQueries(*scene, samples, seed);
    const auto exact = makeMethod(MethodChoice{"exact", {}});
    ResultArrays answers(all.size(), scene->channels());
    // Few at a time: one of them may take long.
    constexpr std::size_t kBatch = 32;
    for (std::size_t begin = 0; begin < all.size(); begin += kBatch) {
        if (!progress.report(static_cast<double>(begin) / static_cast<double>(all.size()))) {
            return cancelled();
        }
        const std::size_t count = std::min(kBatch, all.size() - begin);
        FilterResults results = answers.results();
        results.values = results.values.subspan(begin);
        results.levels = results.levels.subspan(begin, count);
        results.taps = results.taps.subspan(begin, count);
        parallelFor(count, 1, threads, [&](std::size_t from, std::size_t to) {
            FilterResults part = results;
            part.values = part.values.subspan(from);
            part.levels = part.levels.subspan(from, to - from);
            part.taps = part.taps.subspan(from, to - from);
            exact->filter(*scene, all.queries().subspan(begin + from, to - from), part);
        });
    }
    StudySubject subject;
    subject.name = std::move(name);
    subject.range = rangeOf(scene->mips(), threads);
    const std::uint64_t left = keepAnswered(all, answers, scene->channels(), subject);
    if (refused != nullptr) {
        *refused = left;
    }
    subject.scene = std::move(scene);
    return subject;
}

} // namespace trixel
