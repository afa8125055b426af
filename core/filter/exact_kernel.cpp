// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/exact_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/filter/exact_kernel.cpp"
#include <hwy/foreach_target.h> // includes this file once for each target
// After it:
#include "core/filter/exact_sums-inl.h"
#include "core/filter/lattice_rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace trixel {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::uint32_t kChunk = 64; ///< weights at a time

void addExactly(const LevelTexels& texels,
                const HalfLattice& lattice,
                double cut,
                double offset,
                double area,
                ExactSums& sums)
{
    constexpr WeightTag d;
    const auto lanes = static_cast<std::uint32_t>(hn::Lanes(d));
    const double step2 = glm::dot(lattice.alongRow, lattice.alongRow);
    // A product cannot come back from 0: weights that may get there are each an exp of their own.
    const bool far = cut * cut - offset > 1000;
    // From one vector to the next a Gaussian changes by a factor that itself changes by a constant
    // factor. Started anew for every chunk, the error stays below 1e-13.
    const double jump = lanes;
    const auto change = hn::Set(d, std::exp(-jump * jump * step2));
    const std::size_t stride = texels.stride;
    HWY_ALIGN double weights[kChunk];
    // Two chains of sums, for one waits for its own last addition.
    ChannelSums even;
    ChannelSums odd;
    auto weight = hn::Zero(d);
    forRunsInCircle(lattice, cut, [&](const TexelRun& run) HWY_ATTR {
        const auto height2 = hn::Set(d, run.height * run.height - offset);
        for (std::uint32_t begin = 0; begin < run.count; begin += kChunk) {
            const std::uint32_t count = std::min(kChunk, run.count - begin);
            const auto at = hn::Sub(hn::Iota(d, 0), hn::Set(d, run.foot - begin));
            const auto q = hn::MulAdd(hn::Mul(at, at), hn::Set(d, step2), height2);
            auto w = hn::Exp(d, hn::Mul(q, hn::Set(d, -0.5)));
            // q of the next vector is jump (2 at + jump) step² larger.
            const auto growth = hn::MulAdd(at, hn::Set(d, jump), hn::Set(d, jump * jump / 2));
            auto ratio = w;
            if (count > lanes) {
                ratio = hn::Exp(d, hn::Mul(growth, hn::Set(d, -step2)));
            }
            for (std::uint32_t k = 0; k < count; k += lanes) {
                const auto inRun = hn::FirstN(d, count - k);
                weight = hn::Add(weight, hn::IfThenElseZero(inRun, w));
                hn::Store(w, d, weights + k);
                if (far) {
                    const auto next = hn::Add(at, hn::Set(d, k + jump));
                    const auto nextQ = hn::MulAdd(hn::Mul(next, next), hn::Set(d, step2), height2);
                    w = hn::Exp(d, hn::Mul(nextQ, hn::Set(d, -0.5)));
                } else {
                    w = hn::Mul(w, ratio);
                    ratio = hn::Mul(ratio, change);
                }
            }
            const float* texel = texels.values + stride * (run.first + begin);
            std::uint32_t k = 0;
            for (; k + 1 < count; k += 2, texel += 2 * stride) {
                even.add(weights[k], texel);
                odd.add(weights[k + 1], texel + stride);
            }
            if (k < count) {
                even.add(weights[k], texel);
            }
        }
        sums.taps += run.count;
    });
    even.addTo(sums.values, area);
    odd.addTo(sums.values, area);
    sums.weight += area * hn::GetLane(hn::SumOfLanes(d, weight));
}

} // namespace HWY_NAMESPACE
} // namespace trixel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace trixel {

HWY_EXPORT(addExactly);

void addExactly(const LevelTexels& texels,
                const HalfLattice& lattice,
                double cut,
                double offset,
                double area,
                ExactSums& sums)
{
    HWY_DYNAMIC_DISPATCH(addExactly)(texels, lattice, cut, offset, area, sums);
}

} // namespace trixel
#endif
