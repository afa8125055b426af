// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/fit_patches.h"

#include <queue>

#include <algorithm>
#include <optional>

namespace trixel {
namespace {

/// The step of one face that is next to be judged.
struct Step
{
    double savedPerError = 0;
    std::uint32_t place = 0; ///< of the face in its patch
    int steps = 0;           ///< after it
    double added = 0;        ///< square error times pixels

    bool operator<(const Step& other) const
    {
        return savedPerError != other.savedPerError ? savedPerError < other.savedPerError
                                                    : place > other.place;
    }
};

class StepChooser
{
public:
    StepChooser(std::span<const FaceId> patch,
                const FitSamples& samples,
                const FitOptions& options,
                const FaceMap<Level>& levels,
                double most,
                FaceMap<int>& steps)
        : m_patch(patch)
        , m_samples(samples)
        , m_options(options)
        , m_levels(levels)
        , m_most(most)
        , m_steps(steps)
    {
    }

    void choose()
    {
        double room = 0;
        for (std::uint32_t place = 0; place < m_patch.size(); ++place) {
            m_steps[m_patch[place]] = 0;
            room += m_most * m_samples.pixels[m_patch[place]];
            offer(place);
        }
        while (!m_waiting.empty()) {
            const Step step = m_waiting.top();
            m_waiting.pop();
            if (step.added > room) {
                continue; // a cheaper face may still fit
            }
            room -= step.added;
            m_steps[m_patch[step.place]] = step.steps;
            offer(step.place);
        }
    }

private:
    /// The best of the steps that lie ahead of a face: the next may cost what the one after gains.
    void offer(std::uint32_t place)
    {
        const FaceId face = m_patch[place];
        const int done = m_steps[face];
        const double pixels = m_samples.pixels[face];
        std::optional<Step> best;
        for (int k = done + 1; k <= std::min(m_levels[face].log2(), reach()); ++k) {
            const double square = m_options.errors[static_cast<std::size_t>(k)][face];
            if (!(square <= kWorstFace * kWorstFace * m_most)) {
                continue;
            }
            const double before = m_options.errors[static_cast<std::size_t>(done)][face];
            const double added = (square - before) * pixels;
            const double saved = static_cast<double>(m_levels[face].coarser(done).texelCount()) -
                                 m_levels[face].coarser(k).texelCount();
            const double price = std::max(added, 1e-30);
            if (!best || saved / price > best->savedPerError) {
                best = Step{saved / price, place, k, added};
            }
        }
        if (best) {
            m_waiting.push(*best);
        }
    }

    int reach() const { return static_cast<int>(m_options.errors.size()) - 1; }

    std::span<const FaceId> m_patch;
    const FitSamples& m_samples;
    const FitOptions& m_options;
    const FaceMap<Level>& m_levels;
    double m_most;
    FaceMap<int>& m_steps;
    std::priority_queue<Step> m_waiting;
};

} // namespace

FitPatches fitPatches(const Adjacency& adjacency, const FitSamples& samples)
{
    FitPatches patches;
    patches.begin.push_back(0);
    std::vector<bool> taken(adjacency.faceCount());
    const auto take = [&](FaceId face) {
        if (!taken[indexOf(face)] && samples.isSeen(face)) {
            taken[indexOf(face)] = true;
            patches.faces.push_back(face);
        }
    };
    for (std::size_t f = 0; f < adjacency.faceCount(); ++f) {
        take(faceId(f));
        std::size_t next = patches.begin.back();
        double pixels = 0;
        std::size_t end = next; // of the faces that are let in
        while (next < patches.faces.size() && pixels < kPatchPixels) {
            const FaceId face = patches.faces[next++];
            pixels += samples.pixels[face];
            end = next;
            for (const LocalEdge edge : kLocalEdges) {
                if (const auto across = adjacency.neighbour(face, edge)) {
                    take(across->face);
                }
            }
        }
        for (std::size_t left = end; left < patches.faces.size(); ++left) {
            taken[indexOf(patches.faces[left])] = false;
        }
        patches.faces.resize(end);
        if (end > patches.begin.back()) {
            patches.begin.push_back(static_cast<std::uint32_t>(end));
        }
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

void chooseSteps(std::span<const FaceId> patch,
                 const FitSamples& samples,
                 const FitOptions& options,
                 const FaceMap<Level>& levels,
                 double most,
                 FaceMap<int>& steps)
{
    StepChooser(patch, samples, options, levels, most, steps).choose();
}

} // namespace trixel
