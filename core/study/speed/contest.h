// SPDX-License-Identifier: GPL-3.0-or-later
//
// Who is measured and on what: filters of the table and peers alike.
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/filter/filter_method.h"
#include "core/filter/filter_queries.h"
#include "core/filter/filter_scene.h"
#include "core/study/test_scene.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trixel {

/// Footprints on a scene and what `exact` answers to them.
struct StudySubject
{
    std::string name;
    std::shared_ptr<const FilterScene> scene;
    QueryArrays queries;
    std::vector<float> exact; ///< channel c of query i at c * queries.size() + i
    double range = 1;         ///< what errors are fractions of
    /// Where the subject is a patch of stored tiles: of which content, and the patch.
    std::optional<TestContent> content;
    TestPatch patch{0};
};

/// Queries that a contestant has put into its own terms; that work is not timed.
class PreparedQueries
{
public:
    virtual ~PreparedQueries() = default;
    /// Answers all of them, in their order. Called again and again.
    virtual void run(const FilterResults& results) const = 0;
};

/// One method with its parameter, or a peer.
class Contestant
{
public:
    Contestant(std::string series, std::string variant, std::optional<MethodChoice> method)
        : m_series(std::move(series))
        , m_variant(std::move(variant))
        , m_method(std::move(method))
    {
    }
    virtual ~Contestant() = default;
    Contestant(const Contestant&) = delete;
    Contestant& operator=(const Contestant&) = delete;

    const std::string& series() const { return m_series; }
    const std::string& variant() const { return m_variant; }
    const std::optional<MethodChoice>& method() const { return m_method; }

    /// \param subject  number of the subject among those of the study
    /// \param queries  some of the subject's; valid as long as what is returned
    virtual std::unique_ptr<PreparedQueries> prepare(std::size_t subject,
                                                     const FilterQueries& queries) const = 0;

private:
    std::string m_series;
    std::string m_variant;
    std::optional<MethodChoice> m_method;
};

using Contestants = std::vector<std::unique_ptr<const Contestant>>;

/// Every method of the table at every value of its curve, the cheapest kind first.
/// \param subjects  outlive the contestants
Contestants tableContestants(const std::vector<StudySubject>& subjects);

/// Tiles along each side of the patch that studies use: none of the stored
/// footprints reaches beyond it.
inline constexpr int kStudyTiles = kAllQueriesTiles;

/// The stored distribution on both stored textures.
/// \param patch  see `buildTestScene`
Result<std::vector<StudySubject>>
storedSubjects(const TestPatch& patch, Threads threads, Progress& progress);

/// Footprints spread over a surface by area, widths and anisotropies as in the stored distribution
/// (¼ to 64 texels and 1 to 64, both log-uniform), with their exact values. The same seed gives the
/// same footprints. Those that `exact` refuses are left out; `refused` says how many.
Result<StudySubject> subjectOn(std::shared_ptr<const FilterScene> scene,
                               std::string name,
                               int samples,
                               std::uint64_t seed,
                               Threads threads,
                               Progress& progress,
                               std::uint64_t* refused = nullptr);

} // namespace trixel
