// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/exact_answer.h"

#include "core/filter/exact_kernel.h"

namespace trixel {
namespace {

/// Beyond six standard deviations lie 1.5e-8 of a Gaussian.
constexpr double kCut = 6.0;
/// Adds the texels of a face within `cut` standard deviations.
void addFace(const FilterScene& scene,
             const PlacedFace& place,
             int group,
             double cut,
             double offset,
             ExactSums& sums)
{
    const Level level = scene.level(place.face);
    const LevelTexels texels = scene.mips().texels(place.face, level, group);
    const double area = place.doubleArea() / level.texelCount();
    for (const TexelHalf half : {TexelHalf::Lower, TexelHalf::Upper}) {
        const HalfLattice lattice(half, level, place.origin(), place.e1(), place.e2());
        addExactly(texels, lattice, cut, offset, area, sums);
    }
}

/// False where it would take too many texels.
bool addFaces(const FilterScene& scene,
              Unfolding& unfolding,
              const QueryEllipse& ellipse,
              const EllipseFrame& frame,
              FaceId face,
              int group,
              double cut,
              double offset,
              ExactSums& sums)
{
    const auto places = unfolding.unfold(scene.surface(), face, ellipse, frame, cut);
    if (texelsOfWholeFaces(scene, places, cut) > kMostExactTaps) {
        return false;
    }
    for (const PlacedFace& place : places) {
        addFace(scene, place, group, cut, offset, sums);
        if (sums.taps > kMostExactTaps) {
            return false;
        }
    }
    return true;
}

} // namespace

std::uint64_t
texelsOfWholeFaces(const FilterScene& scene, std::span<const PlacedFace> places, double cut)
{
    std::uint64_t texels = 0;
    for (const PlacedFace& place : places) {
        bool whole = true;
        for (const glm::dvec2 p : place.corners) {
            whole = whole && glm::dot(p, p) <= cut * cut;
        }
        texels += whole ? scene.level(place.face).texelCount() : 0;
    }
    return texels;
}

QueryCost exactAnswer(const FilterScene& scene,
                      Unfolding& unfolding,
                      const QueryEllipse& ellipse,
                      FaceId face,
                      int group,
                      GroupValue& value)
{
    const EllipseFrame frame(ellipse);
    const auto level = static_cast<float>(scene.level(face).log2());
    // Amid large texels next to small ones no centroid may lie within the cut: then the search
    // widens, its weights taken relative to the least distance there can be.
    double offset = 0;
    constexpr double kWidestCut = kCut * 65536;
    for (double cut = kCut; cut <= kWidestCut; cut *= 2) {
        ExactSums sums;
        if (!addFaces(scene, unfolding, ellipse, frame, face, group, cut, offset, sums)) {
            return {level, kRefusedTaps};
        }
        if (sums.weight > 0) {
            for (std::size_t c = 0; c < kGroupChannels; ++c) {
                value[c] = static_cast<float>(sums.values[c] / sums.weight);
            }
            return {level, static_cast<std::uint32_t>(sums.taps)};
        }
        offset = cut * cut;
    }
    std::copy_n(scene.mips().average(face, group), kGroupChannels, value.begin());
    return {0, 1};
}

} // namespace trixel
