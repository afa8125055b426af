// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/ewa_sum.h"

#include "core/filter/lattice_rows.h"

#include <algorithm>
#include <cmath>

namespace trixel {
namespace {

constexpr std::uint32_t kChunk = 64;

/// Sums of one face in float.
struct FaceSum
{
    GroupValue values{};
    float weight = 0;
};

/// Takes points of the ellipse's unit frame into one where the Gaussian left to do is the unit
/// one: G⁻¹ with G Gᵀ its covariance.
class Narrowing
{
public:
    /// \param xx, xy, yy  covariance in the ellipse's unit frame, positive definite
    Narrowing(double xx, double xy, double yy)
        : m_xx(1 / std::sqrt(xx))
        , m_xy(xy * m_xx)
        , m_yy(1 / std::sqrt(yy - m_xy * m_xy))
    {
    }

    glm::dvec2 operator()(glm::dvec2 p) const
    {
        const double x = p.x * m_xx;
        return {x, (p.y - m_xy * x) * m_yy};
    }

private:
    double m_xx, m_xy, m_yy;
};

/// \param e1, e2  sides of the face in the ellipse's unit frame
/// \param base, level  base level of the face, level that is read
Narrowing
narrowingOf(glm::dvec2 e1, glm::dvec2 e2, const GaussianWindow& window, Level base, Level level)
{
    const double widened = 1 / window.variance();
    if (level == base) {
        return {widened, 0, widened};
    }
    // The covariance of a triangle with these sides, times what a texel of the level has beyond
    // one of the base.
    const double share = (1.0 / level.texelCount() - 1.0 / base.texelCount()) / 18;
    const double xx = share * (e1.x * e1.x + e2.x * e2.x - e1.x * e2.x);
    const double xy = share * (e1.x * e1.y + e2.x * e2.y - 0.5 * (e1.x * e2.y + e1.y * e2.x));
    const double yy = share * (e1.y * e1.y + e2.y * e2.y - e1.y * e2.y);
    const double middle = (xx + yy) / 2;
    const double largest = middle + std::hypot((xx - yy) / 2, xy);
    const double part = widened * std::min(1.0, 0.5 / largest);
    return {widened - part * xx, -part * xy, widened - part * yy};
}

void addRun(const LevelTexels& texels,
            const TexelRun& run,
            float step,
            const GaussianWindow& window,
            const GroupValue& reference,
            FaceSum& sum)
{
    alignas(16) std::array<float, kChunk> weights;
    const auto height2 = static_cast<float>(run.height * run.height);
    for (std::uint32_t begin = 0; begin < run.count; begin += kChunk) {
        const std::uint32_t count = std::min(kChunk, run.count - begin);
        const auto foot = static_cast<float>(run.foot - begin);
        window.weigh(height2, foot, step, (count + 3) & ~3U, weights.data());
        const float* texel = texels.texel(static_cast<TexelIndex>(run.first + begin));
        FaceSum part;
        for (std::uint32_t k = 0; k < count; ++k) {
            part.weight += weights[k];
            for (std::size_t c = 0; c < kGroupChannels; ++c) {
                part.values[c] += weights[k] * (texel[c] - reference[c]);
            }
            texel += texels.stride;
        }
        sum.weight += part.weight;
        for (std::size_t c = 0; c < kGroupChannels; ++c) {
            sum.values[c] += part.values[c];
        }
    }
}

} // namespace

void EwaSum::add(const FilterScene& scene,
                 const PlacedFace& place,
                 const EllipseFrame& frame,
                 const GaussianWindow& window,
                 int level,
                 int group)
{
    const Level base = scene.level(place.face);
    const Level read(std::min(level, base.log2()));
    const LevelTexels texels = scene.mips().texels(place.face, read, group);
    const glm::dvec2 side1 = frame.toUnit(place.e1);
    const glm::dvec2 side2 = frame.toUnit(place.e2);
    const Narrowing narrow = narrowingOf(side1, side2, window, base, read);
    const glm::dvec2 origin = narrow(frame.toUnit(place.origin));
    const glm::dvec2 e1 = narrow(side1);
    const glm::dvec2 e2 = narrow(side2);
    FaceSum sum;
    for (const TexelHalf half : {TexelHalf::Lower, TexelHalf::Upper}) {
        const HalfLattice lattice(half, read, origin, e1, e2);
        const auto step = static_cast<float>(glm::length(lattice.alongRow));
        forRunsInCircle(lattice, window.cut(), [&](const TexelRun& run) {
            if (m_taps == 0) {
                const float* first = texels.texel(static_cast<TexelIndex>(run.first));
                for (std::size_t c = 0; c < kGroupChannels; ++c) {
                    m_reference[c] = std::isfinite(first[c]) ? first[c] : 0.0F;
                }
            }
            addRun(texels, run, step, window, m_reference, sum);
            m_taps += run.count;
        });
    }
    const double area = (e1.x * e2.y - e1.y * e2.x) / read.texelCount();
    m_weight += area * static_cast<double>(sum.weight);
    for (std::size_t c = 0; c < kGroupChannels; ++c) {
        m_values[c] += area * static_cast<double>(sum.values[c]);
    }
}

} // namespace trixel
