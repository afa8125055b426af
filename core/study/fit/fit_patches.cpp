// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/fit/fit_patches.h"

#include <queue>

#include <algorithm>
#include <optional>

namespace trixel {
namespace {

/// The step of one face that is next to be judged.
struct Step
{
    double savedPerError = 0;
    FaceId face{};
    int steps = 0;    ///< after it
    double added = 0; ///< square error times pixels

    bool operator<(const Step& other) const
    {
        return savedPerError != other.savedPerError ? savedPerError < other.savedPerError
                                                    : face > other.face;
    }
};

class StepChooser
{
public:
    StepChooser(const FitPatches& patches,
                const FitSamples& samples,
                const FitOptions& options,
                const FaceMap<Level>& levels,
                double most,
                double part,
                FaceMap<int>& steps)
        : m_samples(samples)
        , m_options(options)
        , m_levels(levels)
        , m_most(most)
        , m_steps(steps)
        , m_patchesOf(levels.size())
        , m_room(patches.size(), 0)
    {
        for (std::uint32_t p = 0; p < patches.size(); ++p) {
            for (const FaceId face : patches.patch(p)) {
                m_patchesOf[face].push_back(p);
                m_room[p] += (most - error(face, steps[face])) * samples.pixels[face];
            }
            m_room[p] *= part;
        }
    }

    void choose()
    {
        for (std::size_t f = 0; f < m_levels.size(); ++f) {
            if (m_samples.isJudged(faceId(f))) {
                offer(faceId(f));
            }
        }
        while (!m_waiting.empty()) {
            const Step step = m_waiting.top();
            m_waiting.pop();
            if (fits(step)) { // if not, a cheaper face may still
                for (const std::uint32_t p : m_patchesOf[step.face]) {
                    m_room[p] -= step.added;
                }
                m_steps[step.face] = step.steps;
                offer(step.face);
            }
        }
    }

private:
    double error(FaceId face, int steps) const
    {
        return m_options.errors[static_cast<std::size_t>(steps)][face];
    }

    bool fits(const Step& step) const
    {
        return step.added <= 0 || std::ranges::all_of(m_patchesOf[step.face], [&](std::uint32_t p) {
                   return step.added <= m_room[p];
               });
    }

    /// The best of the steps that lie ahead of a face: the next may cost what the one after gains.
    void offer(FaceId face)
    {
        const int done = m_steps[face];
        const int deepest = static_cast<int>(m_options.errors.size()) - 1;
        std::optional<Step> best;
        for (int k = done + 1; k <= std::min(m_levels[face].log2(), deepest); ++k) {
            const double square = error(face, k);
            if (!(square <= kWorstFace * kWorstFace * m_most)) {
                continue;
            }
            const double added = (square - error(face, done)) * m_samples.pixels[face];
            const double saved = static_cast<double>(m_levels[face].coarser(done).texelCount()) -
                                 m_levels[face].coarser(k).texelCount();
            const double price = std::max(added, 1e-30);
            if (!best || saved / price > best->savedPerError) {
                best = Step{saved / price, face, k, added};
            }
        }
        if (best) {
            m_waiting.push(*best);
        }
    }

    const FitSamples& m_samples;
    const FitOptions& m_options;
    const FaceMap<Level>& m_levels;
    double m_most;
    FaceMap<int>& m_steps;
    FaceMap<std::vector<std::uint32_t>> m_patchesOf;
    std::vector<double> m_room; ///< of each patch, square error times pixels
    std::priority_queue<Step> m_waiting;
};

/// Faces across edges, breadth first, until they have the pixels.
class PatchGrower
{
public:
    PatchGrower(const Adjacency& adjacency, const FitSamples& samples)
        : m_adjacency(adjacency)
        , m_samples(samples)
        , m_reached(adjacency.faceCount(), 0)
    {
    }

    /// Appends the faces of a patch; returns how many are in its inner quarter.
    std::size_t grow(FaceId seed, std::vector<FaceId>& faces)
    {
        ++m_patch;
        const std::size_t first = faces.size();
        std::size_t next = first;
        std::size_t inner = 0;
        double pixels = 0;
        reach(seed, faces);
        while (next < faces.size() && pixels < kPatchPixels) {
            const FaceId face = faces[next++];
            pixels += m_samples.pixels[face];
            inner = pixels <= kPatchPixels / 4 ? next - first : inner;
            for (const LocalEdge edge : kLocalEdges) {
                if (const auto across = m_adjacency.neighbour(face, edge)) {
                    reach(across->face, faces);
                }
            }
        }
        faces.resize(next);
        // The only patch about a small part of the mesh.
        return pixels < kPatchPixels ? next - first : std::max<std::size_t>(inner, 1);
    }

private:
    void reach(FaceId face, std::vector<FaceId>& faces)
    {
        if (m_reached[indexOf(face)] != m_patch && m_samples.isJudged(face)) {
            m_reached[indexOf(face)] = m_patch;
            faces.push_back(face);
        }
    }

    const Adjacency& m_adjacency;
    const FitSamples& m_samples;
    std::vector<std::uint32_t> m_reached; ///< number of the patch that reached a face last
    std::uint32_t m_patch = 0;
};

} // namespace

FitPatches fitPatches(const Adjacency& adjacency, const FitSamples& samples)
{
    FitPatches patches;
    patches.begin.push_back(0);
    std::vector<bool> isInner(adjacency.faceCount());
    PatchGrower grower(adjacency, samples);
    for (std::size_t f = 0; f < adjacency.faceCount(); ++f) {
        if (isInner[f] || !samples.isJudged(faceId(f))) {
            continue;
        }
        const std::size_t first = patches.faces.size();
        const std::size_t inner = grower.grow(faceId(f), patches.faces);
        for (std::size_t k = first; k < first + inner; ++k) {
            isInner[indexOf(patches.faces[k])] = true;
        }
        patches.begin.push_back(static_cast<std::uint32_t>(patches.faces.size()));
    }
    return patches;
}

double patchMeanSquare(std::span<const FaceId> patch,
                       const FitSamples& samples,
                       const FaceMap<double>& squares)
{
    double sum = 0;
    double pixels = 0;
    for (const FaceId face : patch) {
        sum += squares[face] * samples.pixels[face];
        pixels += samples.pixels[face];
    }
    return pixels > 0 ? sum / pixels : 0;
}

void chooseSteps(const FitPatches& patches,
                 const FitSamples& samples,
                 const FitOptions& options,
                 const FaceMap<Level>& levels,
                 double most,
                 double part,
                 FaceMap<int>& steps)
{
    StepChooser(patches, samples, options, levels, most, part, steps).choose();
}

} // namespace trixel
