// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sum of what probes read, four channels at a time. Included once per instruction set (see
// Highway).
#include "core/filter/probe_reads.h"
#include "core/texture/float_mips.h"

#include <hwy/highway.h>

#if defined(TRIXEL_PROBE_SUM_SIMD) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIXEL_PROBE_SUM_SIMD
#undef TRIXEL_PROBE_SUM_SIMD
#else
#define TRIXEL_PROBE_SUM_SIMD
#endif

HWY_BEFORE_NAMESPACE();
namespace trixel::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Four channels: one register, or four where registers hold one value.
struct Channels
{
    using D4 = hn::CappedTag<float, kGroupChannels>;
    using V4 = hn::Vec<D4>;
    static constexpr std::size_t kParts = HWY_TARGET == HWY_SCALAR ? kGroupChannels : 1;

    V4 parts[kParts];

    template <class Of>
    HWY_INLINE void each(const Of& of)
    {
        for (std::size_t p = 0; p < kParts; ++p) {
            parts[p] = of(p, p * hn::Lanes(D4()));
        }
    }
};

/// Sums differences from one of the values that are averaged, so that a constant comes out to the
/// bit.
class ChannelSum
{
public:
    /// \param origin  four channels of a value that is averaged
    explicit HWY_INLINE ChannelSum(const float* origin)
    {
        const D4 d;
        m_origin.each([&](std::size_t, std::size_t c)
                          HWY_ATTR { return hn::LoadU(d, origin + c); });
        const auto zero = [](std::size_t, std::size_t) HWY_ATTR { return hn::Zero(D4()); };
        m_first.each(zero);
        m_second.each(zero);
        m_third.each(zero);
    }

    /// Adds the vertices of one probe.
    HWY_INLINE void add(const float* values, const LevelReads& reads, std::size_t k)
    {
        const float* pair = values + reads.pair[k];
        const float* single = values + reads.single[k];
        addTo(m_first, pair, reads.first[k]);
        addTo(m_second, pair + kGroupChannels, reads.second[k]);
        addTo(m_third, single, reads.third[k]);
    }

    /// Adds the texels of one probe.
    HWY_INLINE void add(const LevelTexels& texels, const TexelReads& reads, std::size_t k)
    {
        addTo(m_first, texelOf(texels, reads.own[k]), reads.ownWeight[k]);
        addTo(m_second, texelOf(texels, reads.other[k]), reads.otherWeight[k]);
    }

    /// Adds another sum of the same origin.
    HWY_INLINE void addSum(const ChannelSum& other, float weight)
    {
        const D4 d;
        const V4 by = hn::Set(d, weight);
        m_first.each([&](std::size_t p, std::size_t) HWY_ATTR {
            const V4 pair = hn::Add(other.m_first.parts[p], other.m_second.parts[p]);
            return hn::MulAdd(by, hn::Add(pair, other.m_third.parts[p]), m_first.parts[p]);
        });
    }

    /// origin + what was added by `addSum`
    HWY_INLINE void store(float* value) const
    {
        const D4 d;
        for (std::size_t p = 0; p < Channels::kParts; ++p) {
            const V4 mean = hn::Add(m_first.parts[p], m_origin.parts[p]);
            hn::StoreU(mean, d, value + p * hn::Lanes(d));
        }
    }

private:
    using D4 = Channels::D4;
    using V4 = Channels::V4;

    static HWY_INLINE const float* texelOf(const LevelTexels& texels, std::int32_t index)
    {
        return texels.texel(TexelIndex{static_cast<std::uint32_t>(index)});
    }

    HWY_INLINE void addTo(Channels& sum, const float* value, float weight)
    {
        const D4 d;
        const V4 by = hn::Set(d, weight);
        sum.each([&](std::size_t p, std::size_t c) HWY_ATTR {
            return hn::MulAdd(
                by, hn::Sub(hn::LoadU(d, value + c), m_origin.parts[p]), sum.parts[p]);
        });
    }

    // Vertices of a probe are summed apart: none waits for another.
    Channels m_origin, m_first, m_second, m_third;
};

} // namespace trixel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
