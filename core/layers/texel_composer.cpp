// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/texel_composer.h"

#include "core/base/check.h"
#include "core/layers/coverage.h"
#include "core/layers/known_blend.h"
#include "core/texture/texel_codec.h"

#include <algorithm>
#include <array>

namespace trixel {

namespace {

/// Values worked on at a time. Texels of the base lie in memory like those of layers while they are
/// worked on, with room for the coverage: then a layer meets what is below it value by value, in
/// one loop without a question in it.
constexpr std::size_t kChunkValues = 1024;
using Values = std::array<float, kChunkValues>;

/// Calls work(texel's values) with the number known beforehand where it is a usual one.
template <class Work>
void withChannels(std::size_t channels, Work&& work)
{
    switch (channels) {
    case 1:
        return work(std::integral_constant<std::size_t, 1>{});
    case 3:
        return work(std::integral_constant<std::size_t, 3>{});
    case 4:
        return work(std::integral_constant<std::size_t, 4>{});
    default:
        return work(channels);
    }
}

/// Some texels of a face as numbers, one texel after the other. \param channels  of the face
template <TexelType kType>
void load(const FaceTexels& face,
          std::size_t first,
          std::size_t count,
          std::size_t channels,
          float* values)
{
    using Codec = TexelCodec<kType>;
    using Stored = typename Codec::Stored;
    const bool isConstant = face.isConstant();
    const std::size_t size = (isConstant ? 1 : count) * channels;
    std::array<Stored, kChunkValues> stored;
    std::memcpy(stored.data(),
                face.bytes().data() + (isConstant ? 0 : first) * channels * sizeof(Stored),
                size * sizeof(Stored));
    for (std::size_t k = 0; k < size; ++k) {
        values[k] = Codec::decoded(stored[k]);
    }
    for (std::size_t k = size; k < count * channels; ++k) {
        values[k] = values[k - size];
    }
}

/// Makes room for a coverage behind each texel's values.
void spaceOut(const float* packed, std::size_t count, std::size_t channels, float* spaced)
{
    withChannels(channels, [&](auto known) {
        for (std::size_t k = 0; k < count; ++k) {
            for (std::size_t c = 0; c < known; ++c) {
                spaced[k * (known + 1) + c] = packed[k * known + c];
            }
            spaced[k * (known + 1) + known] = 0.0F;
        }
    });
}

void pack(const float* spaced, std::size_t count, std::size_t channels, float* packed)
{
    withChannels(channels, [&](auto known) {
        for (std::size_t k = 0; k < count; ++k) {
            for (std::size_t c = 0; c < known; ++c) {
                packed[k * known + c] = spaced[k * (known + 1) + c];
            }
        }
    });
}

/// Each texel's coverage times the opacity, once per value; false when it is none everywhere.
bool spreadCoverage(
    const float* layer, std::size_t count, std::size_t channels, float opacity, float* coverage)
{
    std::array<float, kChunkValues> each;
    int covers = 0;
    for (std::size_t k = 0; k < count; ++k) {
        each[k] = coverageOf(layer[k * (channels + 1) + channels]) * opacity;
        covers |= each[k] > 0.0F ? 1 : 0;
    }
    if (covers == 0) {
        return false;
    }
    withChannels(channels, [&](auto known) {
        for (std::size_t k = 0; k < count; ++k) {
            for (std::size_t c = 0; c <= known; ++c) {
                coverage[k * (known + 1) + c] = each[k];
            }
        }
    });
    return true;
}

template <LayerBlend kBlend>
void putOver(const float* layer, const float* coverage, std::size_t count, float* below)
{
    for (std::size_t k = 0; k < count; ++k) {
        const float before = below[k];
        const float value = blended<kBlend>(before, layer[k]);
        const float moved = before + coverage[k] * (value - before);
        const float inside = coverage[k] > 0.0F ? moved : before;
        below[k] = coverage[k] < 1.0F ? inside : value;
    }
}

template <TexelType kType>
void composeChunk(const FaceTexels& base,
                  std::span<const LayerFace> over,
                  std::size_t first,
                  std::size_t count,
                  std::size_t channels,
                  std::byte* shown)
{
    using Codec = TexelCodec<kType>;
    using Stored = typename Codec::Stored;
    Values packed;
    Values below;
    Values layer;
    Values coverage;
    load<kType>(base, first, count, channels, packed.data());
    spaceOut(packed.data(), count, channels, below.data());
    for (const LayerFace& face : over) {
        load<kType>(face.texels, first, count, channels + 1, layer.data());
        if (!spreadCoverage(layer.data(), count, channels, face.opacity, coverage.data())) {
            continue;
        }
        withLayerBlend(face.blend, [&](auto blend) {
            putOver<decltype(blend)::value>(
                layer.data(), coverage.data(), count * (channels + 1), below.data());
        });
    }
    pack(below.data(), count, channels, packed.data());
    std::array<Stored, kChunkValues> stored;
    const std::size_t size = count * channels;
    for (std::size_t k = 0; k < size; ++k) {
        stored[k] = Codec::encoded(packed[k]);
    }
    std::memcpy(shown, stored.data(), size * sizeof(Stored));
}

} // namespace

TexelComposer::TexelComposer(const TexelFormat& base)
    : m_format(base)
    , m_chunk(kChunkValues / (std::size_t{base.channels} + 1))
{
    check(m_chunk > 0, "channels of which layers can be made");
}

void TexelComposer::compose(const FaceTexels& base,
                            std::span<const LayerFace> over,
                            std::size_t first,
                            std::span<std::byte> shown) const
{
    const std::size_t texelBytes = m_format.texelBytes();
    const std::size_t count = shown.size() / texelBytes;
    check(shown.size() == count * texelBytes && first + count <= base.level().texelCount(),
          "whole texels of the face");
    for (const LayerFace& face : over) {
        check(face.texels.level() == base.level(), "layers of the base's levels");
    }
    withTexelType(m_format.type, [&](auto type) {
        for (std::size_t done = 0; done < count; done += m_chunk) {
            composeChunk<decltype(type)::value>(base,
                                                over,
                                                first + done,
                                                std::min(m_chunk, count - done),
                                                m_format.channels,
                                                shown.data() + done * texelBytes);
        }
    });
}

} // namespace trixel
