// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/exact_answer.h"

#include "core/filter/exact_kernel.h"

#include <algorithm>
#include <array>

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

/// Collects faces of few texels, so that they are summed side by side.
class FewCollected
{
public:
    FewCollected(double cut, double offset)
        : m_cut(cut)
        , m_offset(offset)
    {
        for (FewExactFaces& faces : m_byLevel) {
            faces.count = 0;
        }
    }

    void add(const PlacedFace& place, const LevelTexels& texels, int level, ExactSums& sums)
    {
        FewExactFaces& faces = m_byLevel[static_cast<std::size_t>(level)];
        const std::uint32_t n = faces.count++;
        faces.originX[n] = place.origin().x;
        faces.originY[n] = place.origin().y;
        faces.e1X[n] = place.e1().x;
        faces.e1Y[n] = place.e1().y;
        faces.e2X[n] = place.e2().x;
        faces.e2Y[n] = place.e2().y;
        faces.texels[n] = texels.values;
        faces.stride[n] = texels.stride;
        if (faces.count == FewExactFaces::kRoom) {
            sumUp(level, sums);
        }
    }

    void sumUp(ExactSums& sums)
    {
        for (int level = 0; level <= kFewExactLevel; ++level) {
            sumUp(level, sums);
        }
    }

private:
    void sumUp(int level, ExactSums& sums)
    {
        FewExactFaces& faces = m_byLevel[static_cast<std::size_t>(level)];
        if (faces.count > 0) {
            addFewExactly(faces, level, m_cut, m_offset, sums);
            faces.count = 0;
        }
    }

    double m_cut, m_offset;
    std::array<FewExactFaces, kFewExactLevel + 1> m_byLevel;
};

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
    FewCollected few(cut, offset);
    for (const PlacedFace& place : places) {
        const Level level = scene.level(place.face);
        if (level.log2() <= kFewExactLevel) {
            few.add(place, scene.mips().texels(place.face, level, group), level.log2(), sums);
        } else {
            addFace(scene, place, group, cut, offset, sums);
        }
        if (sums.taps > kMostExactTaps) {
            return false;
        }
    }
    few.sumUp(sums);
    return sums.taps <= kMostExactTaps;
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
