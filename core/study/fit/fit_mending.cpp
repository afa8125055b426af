// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/fit/fit_mending.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace trixel {
namespace {

/// Part of a face's square error that is expected to go when it gets a level back.
constexpr double kGain = 0.7;

} // namespace

/// A face to give a level back, or all about one that has none to give but suffers from them.
struct FitMender::Mending
{
    FaceId face{};
    bool isToBlame = false; ///< errs more than the tolerance by itself
    double errorPerTexel = 0;

    bool operator<(const Mending& other) const
    {
        return std::tie(isToBlame, errorPerTexel) < std::tie(other.isToBlame, other.errorPerTexel);
    }
};

FitMender::FitMender(const FitSource& source, const FitPatches& patches, double most)
    : m_source(source)
    , m_patches(patches)
    , m_most(most)
{
}

bool FitMender::mend(Manner manner, FaceMap<double>& squares, FitSteps& steps)
{
    bool failed = false;
    m_before = steps;
    m_squares = &squares;
    m_steps = &steps;
    for (std::size_t p = 0; p < m_patches.size(); ++p) {
        const auto patch = m_patches.patch(p);
        // Written so that infinity fails.
        if (!(patchMeanSquare(patch, m_source.samples, squares) <= m_most)) {
            const bool gained =
                (manner == Manner::Gently && mendGently(patch)) || mendWholly(patch);
            failed = gained || failed;
        }
    }
    return failed;
}

/// As many as it should take. Where a few faces carry the error, the others keep what they gave up:
/// it would not mend anything.
bool FitMender::mendGently(std::span<const FaceId> patch)
{
    double excess = 0;
    for (const FaceId face : patch) {
        excess += ((*m_squares)[face] - m_most) * m_source.samples.pixels[face];
    }
    bool changed = false;
    for (const Mending& mending : mendings(patch)) {
        if (changed && (!(excess > 0) || !mending.isToBlame)) {
            break;
        }
        // A level of its own does a face more good than one of the rim, and costs no more.
        if (giveBack(mending.face) || giveBackAbout(mending.face)) {
            double& square = (*m_squares)[mending.face];
            excess -= kGain * square * m_source.samples.pixels[mending.face];
            square = std::isfinite(square) ? (1 - kGain) * square : square;
            changed = true;
        }
    }
    return changed;
}

bool FitMender::mendWholly(std::span<const FaceId> patch)
{
    bool changed = false;
    for (const FaceId face : patch) {
        forAbout(face, [&](FaceId near) {
            changed = (*m_steps)[near] > 0 || changed;
            (*m_steps)[near] = 0;
        });
    }
    return changed;
}

/// Those that do most for their texels first.
std::vector<FitMender::Mending> FitMender::mendings(std::span<const FaceId> patch) const
{
    std::vector<Mending> found;
    for (const FaceId face : patch) {
        const double square = (*m_squares)[face];
        const double texels = texelsToMend(face);
        if (texels > 0) {
            found.push_back(
                {face, !(square <= m_most), square * m_source.samples.pixels[face] / texels});
        }
    }
    std::stable_sort(found.rbegin(), found.rend());
    return found;
}

/// Texels that mending a face costs; 0 where nothing is left to give.
double FitMender::texelsToMend(FaceId face) const
{
    const auto cost = [&](FaceId one) {
        const int steps = (*m_steps)[one];
        const Level level = m_source.texels.face(one).level();
        return steps > 0 ? static_cast<double>(level.coarser(steps - 1).texelCount()) -
                               level.coarser(steps).texelCount()
                         : 0.0;
    };
    double texels = cost(face);
    if ((*m_steps)[face] == 0) {
        forAbout(face, [&](FaceId near) { texels += cost(near); });
    }
    return texels;
}

/// Gives a face a level back, once a round; false where it has given up none.
bool FitMender::giveBack(FaceId face)
{
    const int before = m_before[face];
    int& steps = (*m_steps)[face];
    steps = std::min(steps, std::max(before - 1, 0));
    return before > 0;
}

bool FitMender::giveBackAbout(FaceId face)
{
    bool gained = false;
    forAbout(face, [&](FaceId near) { gained = giveBack(near) || gained; });
    return gained;
}

/// The face, all that meet it at a vertex and the rim that it reaches, some more than once.
template <class Visit>
void FitMender::forAbout(FaceId face, const Visit& visit) const
{
    const VertexRings& rings = m_source.shapes->rings();
    for (std::uint8_t corner = 0; corner < 3; ++corner) {
        for (const Corner& near : rings.corners(rings.ring({face, corner}))) {
            visit(near.face);
        }
    }
    std::ranges::for_each(m_source.rim.reached[face], visit);
}

} // namespace trixel
