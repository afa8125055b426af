// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/ewa_sum.h"

#include "core/filter/ewa_kernel.h"

#include <algorithm>
#include <cmath>

namespace trixel {
namespace {

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

/// Of every texel of a level, in packed order.
struct Centroids
{
    std::array<float, kFewTexels> u{}, v{};
};

/// \param level  at most 2
const Centroids& centroidsOf(Level level)
{
    static const auto kLevels = [] {
        std::array<Centroids, 3> levels;
        for (std::size_t n = 0; n < levels.size(); ++n) {
            const Level of(static_cast<int>(n));
            for (std::uint32_t k = 0; k < of.texelCount(); ++k) {
                const glm::dvec2 uv = centroid(of, texelAt(of, static_cast<TexelIndex>(k)));
                levels[n].u[k] = static_cast<float>(uv.x);
                levels[n].v[k] = static_cast<float>(uv.y);
            }
        }
        return levels;
    }();
    return kLevels[static_cast<std::size_t>(level.log2())];
}

} // namespace

void EwaSum::add(const FilterScene& scene,
                 const PlacedFace& place,
                 const GaussianWindow& window,
                 int level,
                 int group)
{
    const Level base = scene.level(place.face);
    const Level read(std::min(level, base.log2()));
    const LevelTexels texels = scene.mips().texels(place.face, read, group);
    const glm::dvec2 side1 = place.e1();
    const glm::dvec2 side2 = place.e2();
    const Narrowing narrow = narrowingOf(side1, side2, window, base, read);
    const glm::dvec2 origin = narrow(place.origin());
    const glm::dvec2 e1 = narrow(side1);
    const glm::dvec2 e2 = narrow(side2);
    WindowSums sums;
    // Floats place a centroid well enough while a face is few standard deviations wide.
    constexpr double kWidest = 32;
    if (read.texelCount() <= kFewTexels &&
        std::max({std::abs(e1.x), std::abs(e1.y), std::abs(e2.x), std::abs(e2.y)}) < kWidest) {
        const Centroids& centroids = centroidsOf(read);
        addFewUnderWindow(texels,
                          {read.texelCount(),
                           centroids.u.data(),
                           centroids.v.data(),
                           glm::vec2(origin),
                           glm::vec2(e1),
                           glm::vec2(e2)},
                          window,
                          m_reference,
                          sums);
    } else {
        addUnderWindow(texels,
                       {HalfLattice(TexelHalf::Lower, read, origin, e1, e2),
                        HalfLattice(TexelHalf::Upper, read, origin, e1, e2)},
                       window,
                       m_reference,
                       sums);
    }
    m_taps += sums.taps;
    const double area = (e1.x * e2.y - e1.y * e2.x) / read.texelCount();
    m_weight += area * sums.weight;
    for (std::size_t c = 0; c < kGroupChannels; ++c) {
        m_values[c] += area * sums.values[c];
    }
}

} // namespace trixel
