// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/fit.h"

#include "core/study/fit_patches.h"
#include "core/study/fitted_texels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trixel {
namespace {

/// Part of the tolerance that patches may use. They are judged as if all of a picture were as close
/// as a covered view can be and seen from straight above; most of any picture is not, so that parts
/// of patches and points between the samples are allowed for already.
constexpr double kSafety = 0.85;
/// Times that a plan is mended before its failing patches take all their texels back.
constexpr int kGentleRounds = 6;
constexpr int kMostRounds = 24;

class Fitter
{
public:
    Fitter(const FitSource& source, const Surface& surface, double tolerance, Threads threads)
        : m_source(source)
        , m_surface(surface)
        , m_most(kSafety * kSafety * tolerance * tolerance)
        , m_threads(threads)
        , m_exact(makeMethod({"exact", std::nullopt}))
        , m_coarsener(source)
        , m_before(levelsOf(source.texels))
        , m_patches(fitPatches(surface.adjacency(), source.samples))
        , m_steps(source.texels.faceCount())
    {
        m_was = seen(source.scene);
    }

    /// Measures every face at every level, all faces together.
    Result<FitOptions> measure(Progress& progress)
    {
        FitOptions options;
        options.errors.emplace_back(m_source.texels.faceCount());
        const int deepest = std::ranges::max(m_before.values(), {}, &Level::log2).log2();
        for (int k = 1; k <= deepest; ++k) {
            // Each round has a quarter of the texels of the one before.
            StageProgress round(progress, 1 - std::pow(0.5, k - 1), 1 - std::pow(0.5, k));
            FaceMap<int> steps(m_source.texels.faceCount(), k);
            auto squares = squaresOf(levelsAfter(steps), round);
            if (!squares) {
                return tl::unexpected(squares.error());
            }
            options.errors.push_back(std::move(*squares));
            if (!anyPasses(options.errors.back())) {
                break;
            }
        }
        return options;
    }

    void choose(const FitOptions& options)
    {
        for (std::size_t p = 0; p < m_patches.size(); ++p) {
            chooseSteps(m_patches.patch(p), m_source.samples, options, m_before, m_most, m_steps);
        }
    }

    /// Judges the plan as a whole and takes back steps where neighbours spoil each other, until
    /// every patch is within bounds.
    Status mend(Progress& progress)
    {
        for (int round = 0; round < kMostRounds; ++round) {
            StageProgress part(progress, double(round) / kMostRounds, (round + 1.0) / kMostRounds);
            auto squares = squaresOf(levelsAfter(m_steps), part);
            if (!squares) {
                return tl::unexpected(squares.error());
            }
            m_squares = std::move(*squares);
            if (!mendOnce(round)) {
                return {};
            }
        }
        // No plan was found that holds: leave every seen face as it is.
        for (std::size_t f = 0; f < m_before.size(); ++f) {
            m_steps[faceId(f)] = 0;
        }
        StageProgress last(progress, 1, 1);
        auto squares = squaresOf(levelsAfter(m_steps), last);
        if (!squares) {
            return tl::unexpected(squares.error());
        }
        m_squares = std::move(*squares);
        return {};
    }

    FitPlan plan() const
    {
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
            if (plan.levels[face] != m_before[face]) {
                plan.fitted.addFace(face, m_texels.face(face));
            }
        }
        plan.rms = pixels > 0 ? std::sqrt(sum / pixels) : 0;
        for (std::size_t p = 0; p < m_patches.size(); ++p) {
            plan.worstPart = std::max(plan.worstPart, std::sqrt(meanSquare(p)));
        }
        return plan;
    }

private:
    std::vector<float> seen(const FilterScene& scene) const
    {
        ResultArrays results(m_source.samples.queries.size(), scene.channels());
        filterParallel(
            *m_exact, scene, m_source.samples.queries.queries(), results.results(), m_threads);
        return std::move(results.values);
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

    /// Makes the texels and compares what is seen of them with what was.
    Result<FaceMap<double>> squaresOf(const FaceMap<Level>& levels, Progress& progress)
    {
        StageProgress making(progress, 0, 0.8);
        auto texels = m_coarsener.coarsened(levels, m_threads, making);
        if (!texels) {
            return tl::unexpected(texels.error());
        }
        m_texels = std::move(*texels);
        StageProgress looking(progress, 0.8, 1);
        const auto scene = FilterScene::build(m_source.shapes, m_texels, m_threads, looking);
        if (!scene) {
            return tl::unexpected(scene.error());
        }
        return meanSquares(m_source.samples, m_was, seen(*scene), scene->channels());
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

    /// Faces about a vertex may give up at most one level more than the others: among much finer
    /// ones the filter's floor, which runs smoothly over vertices, is too small for a coarse face,
    /// and its texels show.
    void smooth()
    {
        const VertexRings& rings = m_source.shapes->rings();
        bool changed = true;
        while (changed) {
            changed = false;
            for (std::size_t r = 0; r < rings.ringCount(); ++r) {
                const auto corners = rings.corners(static_cast<RingId>(r));
                int least = Level::kMax;
                for (const Corner& corner : corners) {
                    least = std::min(least, given(corner.face));
                }
                for (const Corner& corner : corners) {
                    if (m_steps[corner.face] > least + 1) {
                        m_steps[corner.face] = least + 1;
                        changed = true;
                    }
                }
            }
        }
    }

    /// Levels that a face gives up; any number where it is at level 0 or not seen.
    int given(FaceId face) const
    {
        const bool lowest = m_steps[face] >= m_before[face].log2();
        return lowest || !m_source.samples.isSeen(face) ? Level::kMax : m_steps[face];
    }

    /// Whether anything had to be taken back.
    bool mendOnce(int round)
    {
        bool failed = false;
        for (std::size_t p = 0; p < m_patches.size(); ++p) {
            // Written so that infinity fails.
            if (!(meanSquare(p) <= m_most)) {
                failed = takeBack(p, round >= kGentleRounds) || failed;
            }
        }
        return failed;
    }

    /// Gives the faces that err most a level back, as many as it should take; or all faces of the
    /// patch and about it all of theirs. False where there was nothing left to give.
    bool takeBack(std::size_t p, bool all)
    {
        const auto patch = m_patches.patch(p);
        if (all) {
            bool changed = false;
            for (const FaceId face : patch) {
                forRings(face, [&](FaceId near) { changed = lower(near, Level::kMax) || changed; });
            }
            return changed;
        }
        std::vector<FaceId> byError(patch.begin(), patch.end());
        const auto weight = [&](FaceId face) {
            return m_squares[face] * m_source.samples.pixels[face];
        };
        std::ranges::stable_sort(byError,
                                 [&](FaceId a, FaceId b) { return weight(a) > weight(b); });
        double excess = 0;
        for (const FaceId face : patch) {
            excess += weight(face) - m_most * m_source.samples.pixels[face];
        }
        bool changed = false;
        for (const FaceId face : byError) {
            if (changed && !(excess > 0)) {
                break;
            }
            bool gained = lower(face, 1);
            if (!gained) { // it suffers from those about it
                forRings(face, [&](FaceId near) { gained = lower(near, 1) || gained; });
            }
            if (gained) {
                excess -= 0.75 * weight(face); // a level finer errs about half as much
                changed = true;
            }
        }
        return changed || takeBack(p, true);
    }

    /// Gives a face levels back; false where it has given up none.
    bool lower(FaceId face, int steps)
    {
        const bool changes = m_steps[face] > 0;
        m_steps[face] = std::max(m_steps[face] - steps, 0);
        return changes;
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
    const Surface& m_surface;
    double m_most; ///< mean square of a patch
    Threads m_threads;
    std::unique_ptr<const FilterMethod> m_exact;
    Coarsener m_coarsener;
    FaceMap<Level> m_before;
    FitPatches m_patches;
    std::vector<float> m_was; ///< what the samples see of the texels as they are
    FaceMap<int> m_steps;     ///< levels that each face gives up
    TexelStore m_texels;      ///< at those levels
    FaceMap<double> m_squares;
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
    StageProgress measuring(progress, 0.1, 0.6);
    const auto options = fitter.measure(measuring);
    if (!options) {
        return tl::unexpected(options.error());
    }
    fitter.choose(*options);
    StageProgress mending(progress, 0.6, 1);
    if (const Status mended = fitter.mend(mending); !mended) {
        return tl::unexpected(mended.error());
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
