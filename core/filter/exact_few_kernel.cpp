// SPDX-License-Identifier: GPL-3.0-or-later
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/filter/exact_few_kernel.cpp"
// clang-format off
#include <hwy/foreach_target.h> // before all others
// clang-format on

#include "core/filter/exact_kernel.h"
#include "core/filter/exact_sums-inl.h"

#include <array>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace trixel {
namespace HWY_NAMESPACE {

/// Of every texel of a level up to kFewExactLevel, in packed order.
struct ExactCentroids
{
    double u[64];
    double v[64];
};

const ExactCentroids& exactCentroidsOf(int level)
{
    static const auto kLevels = [] {
        std::array<ExactCentroids, kFewExactLevel + 1> levels{};
        for (int n = 0; n <= kFewExactLevel; ++n) {
            const Level of(n);
            for (std::uint32_t k = 0; k < of.texelCount(); ++k) {
                const glm::dvec2 uv = centroid(of, texelAt(of, static_cast<TexelIndex>(k)));
                levels[static_cast<std::size_t>(n)].u[k] = uv.x;
                levels[static_cast<std::size_t>(n)].v[k] = uv.y;
            }
        }
        return levels;
    }();
    return kLevels[static_cast<std::size_t>(level)];
}

void addFewExactly(
    const FewExactFaces& faces, int level, double cut, double offset, ExactSums& sums)
{
    constexpr WeightTag d;
    const auto lanes = static_cast<std::uint32_t>(hn::Lanes(d));
    const ExactCentroids& centroids = exactCentroidsOf(level);
    const std::uint32_t texels = Level(level).texelCount();
    const auto cut2 = hn::Set(d, cut * cut);
    ChannelSums channels;
    auto weight = hn::Zero(d);
    HWY_ALIGN double weights[8];
    for (std::uint32_t first = 0; first < faces.count; first += lanes) {
        const auto at = [&](const auto& values)
                            HWY_ATTR { return hn::LoadU(d, values.data() + first); };
        const auto e1X = at(faces.e1X);
        const auto e1Y = at(faces.e1Y);
        const auto e2X = at(faces.e2X);
        const auto e2Y = at(faces.e2Y);
        const auto area =
            hn::Mul(hn::MulSub(e1X, e2Y, hn::Mul(e1Y, e2X)), hn::Set(d, 1.0 / texels));
        const auto valid = hn::FirstN(d, faces.count - first);
        for (std::uint32_t k = 0; k < texels; ++k) {
            const auto u = hn::Set(d, centroids.u[k]);
            const auto v = hn::Set(d, centroids.v[k]);
            const auto x = hn::MulAdd(u, e1X, hn::MulAdd(v, e2X, at(faces.originX)));
            const auto y = hn::MulAdd(u, e1Y, hn::MulAdd(v, e2Y, at(faces.originY)));
            const auto q = hn::MulAdd(x, x, hn::Mul(y, y));
            const auto near = hn::And(hn::Le(q, cut2), valid);
            if (hn::AllFalse(d, near)) {
                continue;
            }
            const auto exponent = hn::Mul(hn::Sub(hn::Set(d, offset), q), hn::Set(d, 0.5));
            const auto w = hn::IfThenElseZero(near, hn::Mul(hn::Exp(d, exponent), area));
            weight = hn::Add(weight, w);
            hn::Store(w, d, weights);
            std::array<std::uint8_t, 8> bytes{};
            hn::StoreMaskBits(d, near, bytes.data());
            auto left = static_cast<std::uint32_t>(bytes[0]);
            sums.taps += static_cast<std::uint32_t>(std::popcount(left));
            for (; left != 0; left &= left - 1) {
                const auto f = static_cast<std::uint32_t>(std::countr_zero(left));
                channels.add(weights[f],
                             faces.texels[first + f] + std::size_t{faces.stride[first + f]} * k);
            }
        }
    }
    channels.addTo(sums.values, 1);
    sums.weight += hn::GetLane(hn::SumOfLanes(d, weight));
}

} // namespace HWY_NAMESPACE
} // namespace trixel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace trixel {

HWY_EXPORT(addFewExactly);

void addFewExactly(
    const FewExactFaces& faces, int level, double cut, double offset, ExactSums& sums)
{
    HWY_DYNAMIC_DISPATCH(addFewExactly)(faces, level, cut, offset, sums);
}

} // namespace trixel
#endif
