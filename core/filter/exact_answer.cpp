// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/exact_answer.h"

#include "core/filter/lattice_rows.h"
#include "core/footprint/gaussian_weights.h"

#include <cmath>

namespace trixel {
namespace {

/// Beyond six standard deviations lie 1.5e-8 of a Gaussian.
constexpr double kCut = 6.0;
/// Sums in double of weight and of weight times value.
struct Sums
{
    double weight = 0;
    std::array<double, kGroupChannels> values{};
    std::uint64_t taps = 0;
};

/// Adds a run of texels with weights exp(-(q - offset)/2) area, q the squared distance from the
/// centre in standard deviations.
void addRun(const LevelTexels& texels,
            const TexelRun& run,
            glm::dvec2 along,
            double offset,
            double area,
            Sums& sums)
{
    constexpr std::uint32_t kPiece = 64;
    std::array<double, kPiece> weights{};
    Sums row;
    for (std::uint32_t begin = 0; begin < run.count; begin += kPiece) {
        const std::uint32_t count = std::min(kPiece, run.count - begin);
        gaussianWeights(run.centroid + static_cast<double>(begin) * along,
                        along,
                        offset,
                        std::span(weights).first(count));
        for (std::uint32_t k = 0; k < count; ++k) {
            const float* texel = texels.texel(static_cast<TexelIndex>(run.first + begin + k));
            row.weight += weights[k];
            for (std::size_t c = 0; c < kGroupChannels; ++c) {
                row.values[c] += weights[k] * static_cast<double>(texel[c]);
            }
        }
    }
    sums.weight += area * row.weight;
    for (std::size_t c = 0; c < kGroupChannels; ++c) {
        sums.values[c] += area * row.values[c];
    }
    sums.taps += run.count;
}

/// Adds the texels of a face within `cut` standard deviations.
void addFace(const FilterScene& scene,
             const PlacedFace& place,
             const EllipseFrame& frame,
             int group,
             double cut,
             double offset,
             Sums& sums)
{
    const Level level = scene.level(place.face);
    const LevelTexels texels = scene.mips().texels(place.face, level, group);
    const double area = place.doubleArea() / level.texelCount();
    for (const TexelHalf half : {TexelHalf::Lower, TexelHalf::Upper}) {
        const HalfLattice lattice(half,
                                  level,
                                  frame.toUnit(place.origin),
                                  frame.toUnit(place.e1),
                                  frame.toUnit(place.e2));
        forRunsInCircle(lattice, cut, [&](const TexelRun& run) {
            addRun(texels, run, lattice.alongRow, offset, area, sums);
        });
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
              Sums& sums)
{
    const auto places = unfolding.unfold(scene.surface(), face, ellipse, frame, cut);
    if (texelsOfWholeFaces(scene, places, frame, cut) > kMostExactTaps) {
        return false;
    }
    for (const PlacedFace& place : places) {
        addFace(scene, place, frame, group, cut, offset, sums);
        if (sums.taps > kMostExactTaps) {
            return false;
        }
    }
    return true;
}

} // namespace

std::uint64_t texelsOfWholeFaces(const FilterScene& scene,
                                 std::span<const PlacedFace> places,
                                 const EllipseFrame& frame,
                                 double cut)
{
    std::uint64_t texels = 0;
    for (const PlacedFace& place : places) {
        bool whole = true;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec2 p = frame.toUnit(place.corner(k));
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
        Sums sums;
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
