// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/ewa_sum.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trixel {
namespace {

/// Floats place a centroid well enough while a face is few standard deviations wide.
bool isSmall(const PlacedFace& place)
{
    constexpr double kWidest = 24;
    const glm::dvec2 e1 = place.e1();
    const glm::dvec2 e2 = place.e2();
    return std::max({std::abs(e1.x), std::abs(e1.y), std::abs(e2.x), std::abs(e2.y)}) < kWidest;
}

void append(const PlacedFace& place, const LevelTexels& texels, float share, FewFaces& faces)
{
    const std::uint32_t n = faces.count++;
    const glm::dvec2 e1 = place.e1();
    const glm::dvec2 e2 = place.e2();
    faces.originX[n] = static_cast<float>(place.origin().x);
    faces.originY[n] = static_cast<float>(place.origin().y);
    faces.e1X[n] = static_cast<float>(e1.x);
    faces.e1Y[n] = static_cast<float>(e1.y);
    faces.e2X[n] = static_cast<float>(e2.x);
    faces.e2Y[n] = static_cast<float>(e2.y);
    faces.share[n] = share;
    faces.texels[n] = texels.values;
    faces.stride[n] = texels.stride;
}

} // namespace

bool EwaSum::add(const FilterScene& scene,
                 std::span<const PlacedFace> places,
                 const GaussianWindow& window,
                 int level,
                 int group,
                 std::uint64_t mostTaps)
{
    std::array<FewFaces, kFewLevel + 1> few; // by level
    for (FewFaces& faces : few) {
        faces.count = 0;
    }
    const auto sumUp = [&](int n) {
        FewFaces& faces = few[static_cast<std::size_t>(n)];
        if (faces.count > 0) {
            addFewUnderWindow(faces, n, window, m_reference, m_sums);
            faces.count = 0;
        }
    };
    for (const PlacedFace& place : places) {
        const Level base = scene.level(place.face);
        const Level read(std::min(level, base.log2()));
        const LevelTexels texels = scene.mips().texels(place.face, read, group);
        if (read.log2() <= kFewLevel && isSmall(place)) {
            FewFaces& faces = few[static_cast<std::size_t>(read.log2())];
            append(place, texels, spreadShare(base, read), faces);
            if (faces.count == FewFaces::kRoom) {
                sumUp(read.log2());
            }
        } else {
            addUnderWindow(texels, base, read, place, window, m_reference, m_sums);
        }
        if (m_sums.taps > mostTaps) {
            return false;
        }
    }
    for (int n = 0; n <= kFewLevel; ++n) {
        sumUp(n);
    }
    return m_sums.taps <= mostTaps;
}

} // namespace trixel
