// SPDX-License-Identifier: GPL-3.0-or-later
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/filter/ewa_kernel.cpp"
// clang-format off
#include <hwy/foreach_target.h> // before all others
// clang-format on

#include "core/filter/ewa_kernel.h"

#include "core/filter/window_rows-inl.h"
#include "core/filter/window_taps-inl.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace trixel {
namespace HWY_NAMESPACE {

/// Takes points of the ellipse's unit frame into one where the Gaussian left to do is the unit one:
/// G⁻¹ with G Gᵀ its covariance, which is that of the widened window less what the level has.
class Narrowing
{
public:
    /// \param share  `spreadShare`
    Narrowing(glm::dvec2 e1, glm::dvec2 e2, double share, double widened)
    {
        const double xx = share * (e1.x * e1.x + e2.x * e2.x - e1.x * e2.x);
        const double xy = share * (e1.x * e1.y + e2.x * e2.y - 0.5 * (e1.x * e2.y + e1.y * e2.x));
        const double yy = share * (e1.y * e1.y + e2.y * e2.y - e1.y * e2.y);
        const double half = (xx - yy) / 2;
        const double largest = (xx + yy) / 2 + std::sqrt(half * half + xy * xy);
        const double part = 2 * largest > 1 ? widened / (2 * largest) : widened;
        m_xx = 1 / std::sqrt(widened - part * xx);
        m_xy = -part * xy * m_xx;
        m_yy = 1 / std::sqrt(widened - part * yy - m_xy * m_xy);
    }

    glm::dvec2 operator()(glm::dvec2 p) const
    {
        const double x = p.x * m_xx;
        return {x, (p.y - m_xy * x) * m_yy};
    }

private:
    double m_xx = 1, m_xy = 0, m_yy = 1;
};

void addUnderWindow(const LevelTexels& texels,
                    Level base,
                    Level level,
                    const PlacedFace& place,
                    const GaussianWindow& window,
                    const GroupValue& reference,
                    WindowSums& sums)
{
    const double share = static_cast<double>(spreadShare(base, level));
    const Narrowing narrow(place.e1(), place.e2(), share, 1 / window.variance());
    const glm::dvec2 origin = narrow(place.origin());
    const glm::dvec2 e1 = narrow(place.e1());
    const glm::dvec2 e2 = narrow(place.e2());
    WaitingPieces pieces(texels, level, window, reference);
    for (const TexelHalf half : {TexelHalf::Lower, TexelHalf::Upper}) {
        addRowsInCircle(HalfLattice(half, level, origin, e1, e2), window.cut(), pieces);
    }
    pieces.addTo(sums, (e1.x * e2.y - e1.y * e2.x) / level.texelCount());
}

/// As many faces as a vector has lanes, in the frame where the Gaussian left to do is the unit one.
struct NarrowedFaces
{
    using V = hn::Vec<WideTag>;

    V originX, originY, e1X, e1Y, e2X, e2Y;
    V area; ///< of a face, twice

    NarrowedFaces(const FewFaces& faces, std::uint32_t first, float widened)
    {
        constexpr WideTag d;
        const auto at = [&](const auto& values)
                            HWY_ATTR { return hn::LoadU(d, values.data() + first); };
        originX = at(faces.originX);
        originY = at(faces.originY);
        e1X = at(faces.e1X);
        e1Y = at(faces.e1Y);
        e2X = at(faces.e2X);
        e2Y = at(faces.e2Y);
        const auto share = at(faces.share);
        const auto half = hn::Set(d, 0.5F);
        const auto full = hn::Set(d, widened);
        // As class Narrowing.
        const auto squares = [&](V a, V b) HWY_ATTR {
            return hn::Mul(share, hn::MulAdd(a, a, hn::Mul(b, hn::Sub(b, a))));
        };
        const auto xx = squares(e1X, e2X);
        const auto yy = squares(e1Y, e2Y);
        const auto mixed = hn::MulAdd(e1X, e2Y, hn::Mul(e1Y, e2X));
        const auto xy =
            hn::Mul(share, hn::NegMulAdd(mixed, half, hn::MulAdd(e1X, e1Y, hn::Mul(e2X, e2Y))));
        const auto apart = hn::Mul(hn::Sub(xx, yy), half);
        const auto largest =
            hn::MulAdd(hn::Add(xx, yy), half, hn::Sqrt(hn::MulAdd(apart, apart, hn::Mul(xy, xy))));
        const auto part = hn::Mul(full, hn::Div(half, hn::Max(largest, half)));
        const auto one = hn::Set(d, 1.0F);
        const auto scaleX = hn::Div(one, hn::Sqrt(hn::NegMulAdd(part, xx, full)));
        const auto shear = hn::Neg(hn::Mul(hn::Mul(part, xy), scaleX));
        const auto scaleY =
            hn::Div(one, hn::Sqrt(hn::NegMulAdd(shear, shear, hn::NegMulAdd(part, yy, full))));
        const auto narrow = [&](V& x, V& y) HWY_ATTR {
            x = hn::Mul(x, scaleX);
            y = hn::Mul(hn::NegMulAdd(shear, x, y), scaleY);
        };
        narrow(originX, originY);
        narrow(e1X, e1Y);
        narrow(e2X, e2Y);
        area = hn::MulSub(e1X, e2Y, hn::Mul(e1Y, e2X));
    }
};

/// Of every texel of a level up to kFewLevel, in packed order.
struct Centroids
{
    float u[64];
    float v[64];
};

const Centroids& centroidsOf(int level)
{
    static const auto kLevels = [] {
        std::array<Centroids, kFewLevel + 1> levels{};
        for (int n = 0; n <= kFewLevel; ++n) {
            const Level of(n);
            for (std::uint32_t k = 0; k < of.texelCount(); ++k) {
                const glm::dvec2 uv = centroid(of, texelAt(of, static_cast<TexelIndex>(k)));
                levels[static_cast<std::size_t>(n)].u[k] = static_cast<float>(uv.x);
                levels[static_cast<std::size_t>(n)].v[k] = static_cast<float>(uv.y);
            }
        }
        return levels;
    }();
    return kLevels[static_cast<std::size_t>(level)];
}

/// Weights of texel k of the faces.
HWY_INLINE hn::Vec<WideTag> weightsOf(const NarrowedFaces& faces,
                                      const Centroids& centroids,
                                      std::uint32_t k,
                                      hn::Mask<WideTag> valid,
                                      const WindowVectors& window,
                                      hn::Vec<WideTag> cut2,
                                      hn::Vec<WideTag> area,
                                      WindowSums& sums)
{
    constexpr WideTag d;
    const auto u = hn::Set(d, centroids.u[k]);
    const auto v = hn::Set(d, centroids.v[k]);
    const auto x = hn::MulAdd(u, faces.e1X, hn::MulAdd(v, faces.e2X, faces.originX));
    const auto y = hn::MulAdd(u, faces.e1Y, hn::MulAdd(v, faces.e2Y, faces.originY));
    const auto q = hn::MulAdd(x, x, hn::Mul(y, y));
    const auto near = hn::And(hn::Le(q, cut2), valid);
    sums.taps += hn::CountTrue(d, near);
    return hn::IfThenElseZero(near, hn::Mul(window.weight(d, q), area));
}

void addFewUnderWindow(const FewFaces& faces,
                       int level,
                       const GaussianWindow& window,
                       const GroupValue& reference,
                       WindowSums& sums)
{
    constexpr WideTag d;
    const auto lanes = static_cast<std::uint32_t>(hn::Lanes(d));
    const WindowVectors vectors(window);
    const Centroids& centroids = centroidsOf(level);
    const std::uint32_t texels = Level(level).texelCount();
    const auto cut2 = hn::Set(d, static_cast<float>(window.cut() * window.cut()));
    const auto perTexel = hn::Set(d, 1 / static_cast<float>(texels));
    ChannelSums channels(reference);
    auto weight = hn::Zero(d);
    HWY_ALIGN float weights[4 * 16];
    for (std::uint32_t first = 0; first < faces.count; first += lanes) {
        const NarrowedFaces narrowed(faces, first, static_cast<float>(1 / window.variance()));
        const auto valid = hn::FirstN(d, faces.count - first);
        const auto area = hn::Mul(narrowed.area, perTexel);
        const std::uint32_t here = std::min(lanes, faces.count - first);
        const auto weigh = [&](std::uint32_t k) HWY_ATTR {
            return weightsOf(narrowed, centroids, k, valid, vectors, cut2, area, sums);
        };
        if (texels == 1) {
            const auto w = weigh(0);
            weight = hn::Add(weight, w);
            hn::Store(w, d, weights);
            for (std::uint32_t f = 0; f < here; ++f) {
                if (weights[f] > 0) {
                    channels.addOne(weights[f], faces.texels[first + f]);
                }
            }
            continue;
        }
        for (std::uint32_t k = 0; k < texels; k += 4) {
            const auto w0 = weigh(k);
            const auto w1 = weigh(k + 1);
            const auto w2 = weigh(k + 2);
            const auto w3 = weigh(k + 3);
            weight = hn::Add(weight, hn::Add(hn::Add(w0, w1), hn::Add(w2, w3)));
            hn::StoreInterleaved4(w0, w1, w2, w3, d, weights);
            for (std::uint32_t f = 0; f < here; ++f) {
                const float* own = weights + 4 * std::size_t{f};
                const std::uint32_t stride = faces.stride[first + f];
                const float* texel = faces.texels[first + f] + std::size_t{k} * stride;
                if (stride != 0) {
                    channels.addFour(own, texel);
                } else if (own[0] + own[1] + own[2] + own[3] > 0) {
                    channels.addOne(own[0] + own[1] + own[2] + own[3], texel);
                }
            }
        }
    }
    sums.weight += static_cast<double>(hn::GetLane(hn::SumOfLanes(d, weight)));
    channels.addTo(sums, 1);
}

} // namespace HWY_NAMESPACE
} // namespace trixel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace trixel {

HWY_EXPORT(addUnderWindow);
HWY_EXPORT(addFewUnderWindow);

void addUnderWindow(const LevelTexels& texels,
                    Level base,
                    Level level,
                    const PlacedFace& place,
                    const GaussianWindow& window,
                    const GroupValue& reference,
                    WindowSums& sums)
{
    HWY_DYNAMIC_DISPATCH(addUnderWindow)(texels, base, level, place, window, reference, sums);
}

void addFewUnderWindow(const FewFaces& faces,
                       int level,
                       const GaussianWindow& window,
                       const GroupValue& reference,
                       WindowSums& sums)
{
    HWY_DYNAMIC_DISPATCH(addFewUnderWindow)(faces, level, window, reference, sums);
}

} // namespace trixel
#endif
