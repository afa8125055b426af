// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/fit/fitter.h"

#include "core/texture/level_change.h"

#include <algorithm>
#include <cmath>

namespace trixel {
namespace {

/// Steps of the search for texels: where all faces give up as many levels, in each round of
/// planning, and before the plan is judged.
constexpr int kMeasuringSteps = 20;
constexpr int kPlanningSteps = 16;
constexpr int kJudgedSteps = 16;
/// Rounds of planning, and rounds in which `exact` judges: at least so many, then as many as it
/// takes.
constexpr int kPlanningRounds = 6;
constexpr int kSettlingRounds = 6;
/// Times that a plan is mended before its failing patches take all their texels back.
constexpr int kGentleRounds = 12;
constexpr int kMostRounds = 24;
/// Parts of the room left that are used in the first round, and in one of the others.
constexpr double kFirstPart = 0.8;
constexpr double kPart = 0.6;
/// Levels that the rim gives up beyond its neighbours', until that shows.
constexpr int kRimSteps = 1;
/// Part of the texels that another round must be expected to save.
constexpr double kLeastSaved = 0.01;

} // namespace

Fitter::Fitter(const FitSource& source, const Surface& surface, double tolerance, Threads threads)
    : m_source(source)
    // Patches may use the whole tolerance. They are judged as if all of a picture were as close as
    // a covered view can be and seen from straight above; most of any picture is not, so that parts
    // of patches and points between the samples are allowed for already.
    , m_most(tolerance * tolerance)
    , m_threads(threads)
    , m_coarsener(source)
    , m_before(levelsOf(source.texels))
    , m_patches(fitPatches(surface.adjacency(), source.samples))
    , m_mender(source, m_patches, m_most)
    , m_steps(source.texels.faceCount(), 0)
    , m_squares(source.texels.faceCount(), 0)
{
}

Status Fitter::measure(Progress& progress)
{
    StageProgress before(progress, 0, 0.1);
    auto was = seen(m_source.scene, before);
    if (!was) {
        return tl::unexpected(was.error());
    }
    m_was = std::move(*was);
    m_options.errors.emplace_back(m_before.size(), 0);
    const int deepest = std::ranges::max(m_before.values(), {}, &Level::log2).log2();
    for (int k = 1; k <= deepest; ++k) {
        // Each round has a quarter of the texels of the one before.
        StageProgress round(progress, 1 - 0.9 * std::pow(0.5, k - 1), 1 - 0.9 * std::pow(0.5, k));
        m_steps = evenSteps(m_source, k, 0);
        if (const Status status = fit(kMeasuringSteps, round); !status) {
            return status;
        }
        m_options.errors.push_back(m_fitted.squares);
        if (!anyPasses(m_options.errors.back())) {
            break;
        }
    }
    return {};
}

Status Fitter::choose(Progress& progress)
{
    m_steps = evenSteps(m_source, 0, kRimSteps);
    give(kFirstPart);
    for (int round = 0; round < kPlanningRounds; ++round) {
        StageProgress part(
            progress, double(round) / kPlanningRounds, (round + 1.0) / kPlanningRounds);
        if (const Status status = fit(kPlanningSteps, part); !status) {
            return status;
        }
        m_squares = m_fitted.squares;
        learn();
        if (!adjust() && round > 0) {
            break;
        }
    }
    return {};
}

Result<FittedSteps> Fitter::settle(Progress& progress)
{
    std::optional<FittedSteps> best;
    for (int round = 0; round < kMostRounds; ++round) {
        // Fewer and fewer are needed.
        StageProgress part(progress, 1 - std::pow(0.7, round), 1 - std::pow(0.7, round + 1));
        if (const Status status = judge(part); !status) {
            return tl::unexpected(status.error());
        }
        const bool holds = !isAnyExceeded();
        if (holds &&
            (!best || texelsAfter(m_source, m_steps) < texelsAfter(m_source, best->steps))) {
            best = FittedSteps{m_steps, m_fitted, m_squares};
        }
        if (best && round + 1 >= kSettlingRounds) {
            return std::move(*best);
        }
        learn();
        const bool matters = round + 2 < kSettlingRounds
                                 ? adjust()
                                 : m_mender.mend(round < kGentleRounds ? FitMender::Manner::Gently
                                                                       : FitMender::Manner::Wholly,
                                                 m_squares,
                                                 m_steps);
        if (holds && !matters) {
            return std::move(*best);
        }
    }
    // No plan was found that holds: leave every judged face as it is.
    m_steps = evenSteps(m_source, 0, 0);
    StageProgress last(progress, 1, 1);
    if (const Status status = judge(last); !status) {
        return tl::unexpected(status.error());
    }
    return FittedSteps{m_steps, m_fitted, m_squares};
}

Result<std::vector<float>> Fitter::seen(const FilterScene& scene, Progress& progress) const
{
    return seenThroughExact(scene, m_source.samples.queries, m_threads, progress);
}

/// Makes the texels of the steps.
Status Fitter::fit(int searchSteps, Progress& progress)
{
    auto fitted =
        m_coarsener.fitted(levelsAfter(m_source, m_steps), searchSteps, m_threads, progress);
    if (!fitted) {
        return tl::unexpected(fitted.error());
    }
    m_fitted = std::move(*fitted);
    return {};
}

/// Makes the texels and compares what `exact` sees of them with what it saw.
Status Fitter::judge(Progress& progress)
{
    StageProgress making(progress, 0, 0.7);
    if (const Status status = fit(kJudgedSteps, making); !status) {
        return status;
    }
    StageProgress building(progress, 0.7, 0.75);
    const auto scene = FilterScene::build(m_source.shapes, m_fitted.texels, m_threads, building);
    if (!scene) {
        return tl::unexpected(scene.error());
    }
    StageProgress looking(progress, 0.75, 1);
    const auto now = seen(*scene, looking);
    if (!now) {
        return tl::unexpected(now.error());
    }
    m_squares = meanSquares(m_source.samples, m_was, *now, scene->channels());
    return {};
}

/// Mends and gives. Whether that matters: something was mended, or texels are saved.
bool Fitter::adjust()
{
    const auto before = static_cast<double>(texelsAfter(m_source, m_steps));
    const bool mended = m_mender.mend(FitMender::Manner::Gently, m_squares, m_steps);
    give(kPart);
    const auto after = static_cast<double>(texelsAfter(m_source, m_steps));
    return mended || after < (1 - kLeastSaved) * before;
}

/// Gives up levels where there is room.
void Fitter::give(double part)
{
    chooseSteps(m_patches, m_source.samples, m_options, m_before, m_most, part, m_steps);
}

/// Expects of every face at its step what was found, and of its other steps more or less likewise.
void Fitter::learn()
{
    const double least = 1e-4 * m_most;
    for (std::size_t f = 0; f < m_before.size(); ++f) {
        const FaceId face = faceId(f);
        if (!m_source.samples.isJudged(face)) {
            continue;
        }
        const auto step = static_cast<std::size_t>(m_steps[face]);
        const double found = m_squares[face];
        const double ratio =
            std::clamp((found + least) / (m_options.errors[step][face] + least), 0.1, 10.0);
        m_options.errors[step][face] = found;
        for (std::size_t k = 1; step > 0 && k < m_options.errors.size(); ++k) {
            m_options.errors[k][face] *= k == step ? 1 : std::sqrt(ratio);
        }
    }
}

bool Fitter::isAnyExceeded() const
{
    for (std::size_t p = 0; p < m_patches.size(); ++p) {
        // So written that infinity exceeds.
        if (!(patchMeanSquare(m_patches.patch(p), m_source.samples, m_squares) <= m_most)) {
            return true;
        }
    }
    return false;
}

bool Fitter::anyPasses(const FaceMap<double>& squares) const
{
    for (std::size_t f = 0; f < squares.size(); ++f) {
        if (m_source.samples.isJudged(faceId(f)) && squares[faceId(f)] <= m_most) {
            return true;
        }
    }
    return false;
}

} // namespace trixel
