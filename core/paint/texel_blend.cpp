// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/paint/texel_blend.h"

#include "core/base/check.h"
#include "core/layers/coverage.h"
#include "core/texture/texel_codec.h"

#include <algorithm>
#include <array>

namespace trixel {

namespace {

/// Values worked on at a time; at least the channels of one texel.
constexpr std::size_t kChunkValues = TexelFormat::kMaxChannels;

/// Blends a chunk of values. Everything lies in arrays of its own, so that the loop has nothing to
/// suspect and runs several values at a time.
template <TexelType kType>
void blendValues(const std::byte* before,
                 const float* coverage,
                 const float* value,
                 std::size_t count,
                 std::byte* texels)
{
    using Codec = TexelCodec<kType>;
    using Stored = typename Codec::Stored;
    std::array<Stored, kChunkValues> from;
    std::array<Stored, kChunkValues> to;
    std::array<float, kChunkValues> mixed;
    std::memcpy(from.data(), before, count * sizeof(Stored));
    for (std::size_t k = 0; k < count; ++k) {
        mixed[k] = Codec::decoded(from[k]);
    }
    for (std::size_t k = 0; k < count; ++k) {
        const float moved = mixed[k] + coverage[k] * (value[k] - mixed[k]);
        const float inside = coverage[k] > 0.0F ? moved : mixed[k];
        mixed[k] = coverage[k] < 1.0F ? inside : value[k];
    }
    for (std::size_t k = 0; k < count; ++k) {
        to[k] = Codec::encoded(mixed[k]);
    }
    if constexpr (kType == TexelType::Half) {
        // The only type whose values need not survive the way through float and back: a NaN.
        for (std::size_t k = 0; k < count; ++k) {
            to[k] = coverage[k] > 0.0F ? to[k] : from[k];
        }
    }
    std::memcpy(texels, to.data(), count * sizeof(Stored));
}

/// Each texel's coverage once per channel, for a number of channels known beforehand.
template <std::size_t kChannels>
void spreadOver(const float* coverage, std::size_t texels, float* values)
{
    for (std::size_t k = 0; k < texels; ++k) {
        for (std::size_t channel = 0; channel < kChannels; ++channel) {
            values[k * kChannels + channel] = coverage[k];
        }
    }
}

void spreadOverChannels(const float* coverage,
                        std::size_t texels,
                        std::size_t channels,
                        float* values)
{
    switch (channels) {
    case 1:
        return spreadOver<1>(coverage, texels, values);
    case 3:
        return spreadOver<3>(coverage, texels, values);
    case 4:
        return spreadOver<4>(coverage, texels, values);
    default:
        for (std::size_t k = 0; k < texels; ++k) {
            std::fill_n(values + k * channels, channels, coverage[k]);
        }
    }
}

/// How far each value of a layer's texels moves: the coverage as the stroke covers the texel, the
/// channels as the stroke's part in what is covered then.
template <TexelType kType>
void spreadOverLayer(const std::byte* before,
                     const float* coverage,
                     std::size_t texels,
                     std::size_t channels,
                     float* values)
{
    using Codec = TexelCodec<kType>;
    using Stored = typename Codec::Stored;
    const std::size_t last = channels - 1;
    for (std::size_t k = 0; k < texels; ++k) {
        const float own =
            coverageOf(Codec::decoded(loadStored<Stored>(before, k * channels + last)));
        const float added = coverage[k];
        const float part = added > 0.0F ? added / (own + added * (1.0F - own)) : 0.0F;
        std::fill_n(values + k * channels, last, part);
        values[k * channels + last] = added;
    }
}

/// Channels stay, coverage moves.
void spreadOverCoverage(const float* coverage,
                        std::size_t texels,
                        std::size_t channels,
                        float* values)
{
    for (std::size_t k = 0; k < texels; ++k) {
        std::fill_n(values + k * channels, channels - 1, 0.0F);
        values[k * channels + channels - 1] = coverage[k];
    }
}

} // namespace

TexelBlend::TexelBlend(const TexelFormat& format, std::span<const float> value, TexelMix mix)
    : m_format(format)
    , m_mix(mix)
    , m_chunk(std::min<std::size_t>(64, kChunkValues / format.channels))
{
    check(value.size() == format.channels, "a value per channel");
    for (std::size_t k = 0; k < m_chunk; ++k) {
        m_value.insert(m_value.end(), value.begin(), value.end());
    }
}

void TexelBlend::blend(std::span<const std::byte> before,
                       std::span<const float> coverage,
                       std::span<std::byte> texels) const
{
    const std::size_t texelBytes = m_format.texelBytes();
    check(before.size() == coverage.size() * texelBytes && texels.size() == before.size(),
          "a coverage per texel");
    withTexelType(m_format.type, [&](auto type) {
        std::array<float, kChunkValues> spread;
        for (std::size_t done = 0; done < coverage.size(); done += m_chunk) {
            const std::size_t some = std::min(m_chunk, coverage.size() - done);
            const float* covers = coverage.data() + done;
            switch (m_mix) {
            case TexelMix::Towards:
                spreadOverChannels(covers, some, m_format.channels, spread.data());
                break;
            case TexelMix::Over:
                spreadOverLayer<decltype(type)::value>(before.data() + done * texelBytes,
                                                       covers,
                                                       some,
                                                       m_format.channels,
                                                       spread.data());
                break;
            case TexelMix::Uncover:
                spreadOverCoverage(covers, some, m_format.channels, spread.data());
                break;
            }
            blendValues<decltype(type)::value>(before.data() + done * texelBytes,
                                               spread.data(),
                                               m_value.data(),
                                               some * m_format.channels,
                                               texels.data() + done * texelBytes);
        }
    });
}

} // namespace trixel
