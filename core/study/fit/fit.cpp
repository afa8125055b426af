// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/fit/fit.h"

#include "core/study/fit/fit_patches.h"
#include "core/study/fit/fitted_texels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace trixel {
namespace {

/// Part of the tolerance that patches may use. They are judged as if all of a picture were as close
/// as a covered view can be and seen from straight above; most of any picture is not, so that parts
/// of patches and points between the samples are allowed for already.
constexpr double kSafety = 0.9;
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
/// Part of the texels that another round must be expected to save.
constexpr double kLeastSaved = 0.01;
/// Part of a face's square error that is expected to go when it gets a level back.
constexpr double kGain = 0.7;

class Fitter
{
public:
    Fitter(const FitSource& source, const Surface& surface, double tolerance, Threads threads)
        : m_source(source)
        , m_most(kSafety * kSafety * tolerance * tolerance)
        , m_threads(threads)
        , m_coarsener(source)
        , m_before(levelsOf(source.texels))
        , m_patches(fitPatches(surface.adjacency(), source.samples))
        , m_steps(source.texels.faceCount(), 0)
        , m_squares(source.texels.faceCount(), 0)
    {
    }

    /// Measures every face at every level, all faces together.
    Status measure(Progress& progress)
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
            StageProgress round(
                progress, 1 - 0.9 * std::pow(0.5, k - 1), 1 - 0.9 * std::pow(0.5, k));
            m_steps = FaceMap<int>(m_before.size(), k);
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

    /// Chooses steps, and again and again gives some back where patches err too much and takes more
    /// where they err too little, learning what faces err among others that take other steps.
    Status choose(Progress& progress)
    {
        m_steps = FaceMap<int>(m_before.size(), 0);
        give(kFirstPart);
        for (int round = 0; round < kPlanningRounds; ++round) {
            StageProgress part(
                progress, double(round) / kPlanningRounds, (round + 1.0) / kPlanningRounds);
            if (const Status status = fit(kPlanningSteps, part); !status) {
                return status;
            }
            m_squares = m_fitted.squares;
            learn();
            if (!adjust(0) && round > 0) {
                break;
            }
        }
        return {};
    }

    /// The same with `exact` as the judge. Keeps the best plan that holds.
    Status settle(Progress& progress)
    {
        for (int round = 0; round < kMostRounds; ++round) {
            // Fewer and fewer are needed.
            StageProgress part(progress, 1 - std::pow(0.7, round), 1 - std::pow(0.7, round + 1));
            if (const Status status = judge(part); !status) {
                return status;
            }
            const bool holds = !isAnyExceeded();
            if (holds && (!m_best || texelsOf(m_steps) < texelsOf(m_best->steps))) {
                m_best = {m_steps, m_fitted, m_squares};
            }
            if (m_best && round + 1 >= kSettlingRounds) {
                return {};
            }
            learn();
            const bool matters = round + 2 < kSettlingRounds ? adjust(round) : mendOnce(round);
            if (holds && !matters) {
                return {};
            }
        }
        // No plan was found that holds: leave every seen face as it is.
        m_steps = FaceMap<int>(m_before.size(), 0);
        StageProgress last(progress, 1, 1);
        const Status status = judge(last);
        m_best = {m_steps, m_fitted, m_squares};
        return status;
    }

    /// The best plan of `settle`.
    FitPlan plan()
    {
        m_steps = m_best->steps;
        m_fitted = m_best->fitted;
        m_squares = m_best->squares;
        FitPlan plan;
        plan.levels = levelsAfter(m_steps);
        plan.cost = levelCost(m_source.texels, plan.levels);
        plan.errors = FaceMap<float>(m_before.size());
        double sum = 0;
        double pixels = 0;
        for (std::uint32_t f = 0; f < m_before.size(); ++f) {
            const FaceId face = faceId(f);
            const double error = std::sqrt(m_squares[face]);
            const bool isSeen = m_source.samples.isSeen(face);
            plan.errors[face] =
                isSeen ? static_cast<float>(error) : std::numeric_limits<float>::quiet_NaN();
            plan.worstFace = std::max(plan.worstFace, error);
            plan.unseenFaces += isSeen ? 0 : 1;
            sum += m_squares[face] * m_source.samples.pixels[face];
            pixels += m_source.samples.pixels[face];
            if (plan.levels[face] != m_before[face] || m_fitted.isMoved[face] != 0) {
                plan.fitted.addFace(face, m_fitted.texels.face(face));
            }
        }
        plan.rms = pixels > 0 ? std::sqrt(sum / pixels) : 0;
        for (std::size_t p = 0; p < m_patches.size(); ++p) {
            plan.worstPart = std::max(plan.worstPart, std::sqrt(meanSquare(p)));
        }
        return plan;
    }

private:
    Result<std::vector<float>> seen(const FilterScene& scene, Progress& progress) const
    {
        return seenThroughExact(scene, m_source.samples.queries, m_threads, progress);
    }

    FaceMap<Level> levelsAfter(const FaceMap<int>& steps) const
    {
        FaceMap<Level> levels = m_before;
        for (std::size_t f = 0; f < levels.size(); ++f) {
            const FaceId face = faceId(f);
            levels[face] =
                m_source.samples.isSeen(face) ? m_before[face].coarser(steps[face]) : Level(0);
        }
        return levels;
    }

    /// Makes the texels of the steps.
    Status fit(int searchSteps, Progress& progress)
    {
        auto fitted = m_coarsener.fitted(levelsAfter(m_steps), searchSteps, m_threads, progress);
        if (!fitted) {
            return tl::unexpected(fitted.error());
        }
        m_fitted = std::move(*fitted);
        return {};
    }

    /// Mends and gives. Whether that matters: something was mended, or texels are saved.
    bool adjust(int round)
    {
        const auto before = static_cast<double>(texelsOf(m_steps));
        const bool mended = mendOnce(round);
        give(kPart);
        return mended || static_cast<double>(texelsOf(m_steps)) < (1 - kLeastSaved) * before;
    }

    /// Gives up levels where there is room.
    void give(double part)
    {
        chooseSteps(m_patches, m_source.samples, m_options, m_before, m_most, part, m_steps);
    }

    std::uint64_t texelsOf(const FaceMap<int>& steps) const
    {
        return levelCost(m_source.texels, levelsAfter(steps)).texelsAfter;
    }

    bool isAnyExceeded() const
    {
        for (std::size_t p = 0; p < m_patches.size(); ++p) {
            if (!(meanSquare(p) <= m_most)) { // so written that infinity exceeds
                return true;
            }
        }
        return false;
    }

    /// Makes the texels and compares what `exact` sees of them with what it saw.
    Status judge(Progress& progress)
    {
        StageProgress making(progress, 0, 0.7);
        if (const Status status = fit(kJudgedSteps, making); !status) {
            return status;
        }
        StageProgress building(progress, 0.7, 0.75);
        const auto scene =
            FilterScene::build(m_source.shapes, m_fitted.texels, m_threads, building);
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

    /// Expects of every face at its step what was found, and of its other steps more or less
    /// likewise.
    void learn()
    {
        const double least = 1e-4 * m_most;
        for (std::size_t f = 0; f < m_before.size(); ++f) {
            const FaceId face = faceId(f);
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

    double meanSquare(std::size_t p) const
    {
        return patchMeanSquare(m_patches.patch(p), m_source.samples, m_squares);
    }

    bool anyPasses(const FaceMap<double>& squares) const
    {
        for (std::size_t f = 0; f < squares.size(); ++f) {
            if (m_source.samples.isSeen(faceId(f)) && squares[faceId(f)] <= m_most) {
                return true;
            }
        }
        return false;
    }

    /// Whether anything had to be taken back. However many patches ask for it, a face gets back
    /// one level at a time: what that mends is only known afterwards.
    bool mendOnce(int round)
    {
        bool failed = false;
        m_stepsBefore = m_steps;
        for (std::size_t p = 0; p < m_patches.size(); ++p) {
            // Written so that infinity fails.
            if (!(meanSquare(p) <= m_most)) {
                failed = takeBack(p, round >= kGentleRounds) || failed;
            }
        }
        return failed;
    }

    /// A face to give a level back, or all about one that has none to give but suffers from them.
    struct Mending
    {
        FaceId face{};
        bool isToBlame = false; ///< errs more than the tolerance by itself
        double errorPerTexel = 0;

        bool operator<(const Mending& other) const
        {
            return std::tie(isToBlame, errorPerTexel) <
                   std::tie(other.isToBlame, other.errorPerTexel);
        }
    };

    /// Gives faces of the patch a level back, those first that err most for the texels they get, as
    /// many as it should take; or all faces of the patch and about it all of theirs. Where a few
    /// faces carry the error, the others keep what they gave up: it would not mend anything. False
    /// where there was nothing left to give. What should be gained is taken off m_squares, so that
    /// patches that overlap do not mend the same twice.
    bool takeBack(std::size_t p, bool all)
    {
        const auto patch = m_patches.patch(p);
        if (all) {
            bool changed = false;
            for (const FaceId face : patch) {
                forRings(face, [&](FaceId near) {
                    changed = m_steps[near] > 0 || changed;
                    m_steps[near] = 0;
                });
            }
            return changed;
        }
        std::vector<Mending> mendings;
        double excess = 0;
        for (const FaceId face : patch) {
            const double error = m_squares[face] * m_source.samples.pixels[face];
            excess += error - m_most * m_source.samples.pixels[face];
            const double texels = texelsToMend(face);
            if (texels > 0) {
                mendings.push_back({face, !(m_squares[face] <= m_most), error / texels});
            }
        }
        std::stable_sort(mendings.rbegin(), mendings.rend()); // the largest first
        bool changed = false;
        for (const Mending& mending : mendings) {
            if (changed && (!(excess > 0) || !mending.isToBlame)) {
                break;
            }
            bool gained = giveBack(mending.face);
            if (!gained) {
                forRings(mending.face, [&](FaceId near) { gained = giveBack(near) || gained; });
            }
            if (gained) {
                double& square = m_squares[mending.face];
                excess -= kGain * square * m_source.samples.pixels[mending.face];
                square = std::isfinite(square) ? (1 - kGain) * square : square;
                changed = true;
            }
        }
        return changed || takeBack(p, true);
    }

    /// Texels that mending a face costs; 0 where nothing is left to give.
    double texelsToMend(FaceId face) const
    {
        const auto cost = [&](FaceId one) {
            const int steps = m_steps[one];
            return steps > 0 ? static_cast<double>(m_before[one].coarser(steps - 1).texelCount()) -
                                   m_before[one].coarser(steps).texelCount()
                             : 0.0;
        };
        double texels = cost(face);
        if (m_steps[face] == 0) {
            forRings(face, [&](FaceId near) { texels += cost(near); });
        }
        return texels;
    }

    /// Gives a face a level back, once a round; false where it has given up none.
    bool giveBack(FaceId face)
    {
        const int before = m_stepsBefore[face];
        m_steps[face] = std::min(m_steps[face], std::max(before - 1, 0));
        return before > 0;
    }

    /// The face and all that meet it at a vertex, some more than once.
    template <class Visit>
    void forRings(FaceId face, const Visit& visit) const
    {
        const VertexRings& rings = m_source.shapes->rings();
        for (std::uint8_t corner = 0; corner < 3; ++corner) {
            for (const Corner& near : rings.corners(rings.ring({face, corner}))) {
                visit(near.face);
            }
        }
    }

    const FitSource& m_source;
    double m_most; ///< mean square of a patch
    Threads m_threads;
    Coarsener m_coarsener;
    FaceMap<Level> m_before;
    FitPatches m_patches;
    FitOptions m_options;
    std::vector<float> m_was;   ///< what the samples see of the texels as they are
    FaceMap<int> m_steps;       ///< levels that each face gives up
    FaceMap<int> m_stepsBefore; ///< the same, before they were mended
    FittedTexels m_fitted;      ///< at those levels
    FaceMap<double> m_squares;
    struct Best
    {
        FaceMap<int> steps;
        FittedTexels fitted;
        FaceMap<double> squares;
    };
    std::optional<Best> m_best;
};

} // namespace

Result<FitPlan> planFit(const Surface& surface,
                        const TexelStore& texels,
                        const FitSettings& settings,
                        Threads threads,
                        Progress& progress)
{
    check(surface.mesh().faceCount() == texels.faceCount(), "texels of this surface");
    if (!(settings.tolerance > 0) || !std::isfinite(settings.tolerance)) {
        return contentsError("tolerance: expected a number above 0, found " +
                             std::to_string(settings.tolerance));
    }
    if (settings.views.isEmpty()) {
        return contentsError("A fit needs at least one camera or view distance.");
    }
    StageProgress preparing(progress, 0, 0.1);
    const auto source = FitSource::make(surface, texels, settings.views, threads, preparing);
    if (!source) {
        return tl::unexpected(source.error());
    }
    Fitter fitter(*source, surface, settings.tolerance, threads);
    StageProgress measuring(progress, 0.1, 0.4);
    if (const Status measured = fitter.measure(measuring); !measured) {
        return tl::unexpected(measured.error());
    }
    StageProgress choosing(progress, 0.4, 0.75);
    if (const Status chosen = fitter.choose(choosing); !chosen) {
        return tl::unexpected(chosen.error());
    }
    StageProgress settling(progress, 0.75, 1);
    if (const Status settled = fitter.settle(settling); !settled) {
        return tl::unexpected(settled.error());
    }
    return fitter.plan();
}

TexelPatch applyFit(const FitPlan& plan, TexelStore& texels)
{
    TexelPatch patch = plan.fitted;
    patch.swap(texels);
    return patch;
}

} // namespace trixel
