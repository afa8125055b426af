// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tests of layers share: stacks made on the spot, and what they look like by brute force
// in double, a texel and a channel at a time.
#pragma once

#include "core/layers/compose.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace trixel::test {

inline constexpr TexelType kTypes[]{
    TexelType::UInt8, TexelType::UInt16, TexelType::Half, TexelType::Float};

inline TexelFormat formatOf(TexelType type, int channels)
{
    return {type, static_cast<std::uint16_t>(channels), std::nullopt};
}

inline std::vector<std::byte> encoded(TexelType type, std::span<const float> values)
{
    std::vector<std::byte> bytes(values.size() * byteSize(type));
    encode(type, values, bytes);
    return bytes;
}

inline std::vector<float> decodedTexel(const TexelStore& store, FaceId face, std::size_t texel)
{
    std::vector<float> values(store.format().channels);
    decode(store.format().type, store.face(face).texel(texel), values);
    return values;
}

/// Values in [0,1]; of layers with a coverage that is often none and often all.
inline std::vector<float> randomTexel(std::mt19937& random, const TexelFormat& format)
{
    std::uniform_real_distribution<float> part(0, 1);
    std::vector<float> values(format.channels);
    std::ranges::generate(values, [&] { return part(random); });
    if (format.alpha) {
        const auto kind = random() % 4;
        values.back() = kind == 0 ? 0.0F : kind == 1 ? 1.0F : values.back();
    }
    return values;
}

inline FaceTexels randomFace(std::mt19937& random, const TexelFormat& format, Level level)
{
    if (random() % 4 == 0) {
        return FaceTexels::constant(level, encoded(format.type, randomTexel(random, format)));
    }
    std::vector<float> values;
    for (std::uint32_t k = 0; k < level.texelCount(); ++k) {
        const std::vector<float> texel = randomTexel(random, format);
        values.insert(values.end(), texel.begin(), texel.end());
    }
    return FaceTexels::full(level, format.texelBytes(), encoded(format.type, values));
}

/// \param untouched  one face in so many stays as it is
inline void paintAtRandom(std::mt19937& random, TexelStore& store, unsigned untouched)
{
    for (std::uint32_t f = 0; f < store.faceCount(); ++f) {
        if (random() % untouched != 0) {
            const Level level = store.face(faceId(f)).level();
            store.exchange(faceId(f), randomFace(random, store.format(), level));
        }
    }
}

inline LayerSettings randomSettings(std::mt19937& random)
{
    LayerSettings settings;
    settings.blend = kLayerBlends[random() % kLayerBlends.size()];
    settings.opacity = random() % 2 == 0 ? 1.0F : static_cast<float>(random() % 101) / 100.0F;
    settings.isVisible = random() % 4 != 0;
    return settings;
}

/// Faces of levels 0 to 4, some of one value; layers of every kind.
inline LayerStack
randomStack(std::mt19937& random, const TexelFormat& format, std::uint32_t faces, int layers)
{
    FaceMap<Level> levels(faces);
    for (Level& level : levels.values()) {
        level = Level(static_cast<int>(random() % 5));
    }
    TexelStore base(format, levels, std::vector<std::byte>(format.texelBytes()));
    paintAtRandom(random, base, 3);
    LayerStack stack(std::move(base));
    for (int k = 0; k < layers; ++k) {
        const LayerId id = stack.insert(static_cast<std::size_t>(k), randomSettings(random));
        paintAtRandom(random, stack.texels(id), 2);
    }
    return stack;
}

/// The formulas as documented, in double.
inline double blendedInDouble(LayerBlend blend, double below, double value)
{
    switch (blend) {
    case LayerBlend::Normal:
        return value;
    case LayerBlend::Multiply:
        return below * value;
    case LayerBlend::Screen:
        return 1 - (1 - below) * (1 - value);
    case LayerBlend::Overlay:
        return below <= 0.5 ? 2 * below * value : 1 - 2 * (1 - below) * (1 - value);
    case LayerBlend::Darken:
        return std::min(below, value);
    case LayerBlend::Lighten:
        return std::max(below, value);
    case LayerBlend::Add:
        return below + value;
    case LayerBlend::Subtract:
        return below - value;
    case LayerBlend::Difference:
        return std::abs(below - value);
    }
    return value;
}

inline double shownInDouble(const LayerStack& layers, FaceId face, std::size_t texel, std::size_t c)
{
    double below = static_cast<double>(decodedTexel(layers.base(), face, texel)[c]);
    for (const Layer& layer : layers.layers()) {
        const LayerSettings& settings = layer.settings;
        if (settings.isVisible) {
            const std::vector<float> values = decodedTexel(layer.texels, face, texel);
            const double coverage = static_cast<double>(values.back() * settings.opacity);
            const double value =
                blendedInDouble(settings.blend, below, static_cast<double>(values[c]));
            below += coverage * (value - below);
        }
    }
    const TexelType type = layers.base().format().type;
    const bool isInteger = type == TexelType::UInt8 || type == TexelType::UInt16;
    return isInteger ? std::clamp(below, 0.0, 1.0) : below;
}

/// What storing a number may lose, and some float arithmetic before it.
inline double stepOf(TexelType type, double value)
{
    switch (type) {
    case TexelType::UInt8:
        return 0.5 / 255 + 1e-5;
    case TexelType::UInt16:
        return 0.5 / 65535 + 2e-6;
    case TexelType::Half:
        return std::abs(value) / 2048 + 1e-5;
    case TexelType::Float:
        break;
    }
    return 1e-5;
}

inline void expectShows(const LayerStack& layers, const TexelStore& shown)
{
    const TexelFormat& format = layers.base().format();
    ASSERT_EQ(shown.format(), format);
    ASSERT_EQ(shown.faceCount(), layers.base().faceCount());
    for (std::uint32_t f = 0; f < shown.faceCount(); ++f) {
        ASSERT_EQ(shown.face(faceId(f)).level(), layers.base().face(faceId(f)).level());
        for (std::uint32_t k = 0; k < shown.face(faceId(f)).level().texelCount(); ++k) {
            const std::vector<float> values = decodedTexel(shown, faceId(f), k);
            for (std::size_t c = 0; c < format.channels; ++c) {
                const double expected = shownInDouble(layers, faceId(f), k, c);
                ASSERT_NEAR(static_cast<double>(values[c]), expected, stepOf(format.type, expected))
                    << nameOf(format.type) << ", face " << f << ", texel " << k << ", channel "
                    << c;
            }
        }
    }
}

inline Layered shownOf(const LayerStack& layers, unsigned threads = 2)
{
    NoProgress progress;
    return composed(layers, Threads{threads}, progress).value();
}

/// Texels alike to the bit, however they are kept.
inline bool sameTexels(const TexelStore& a, const TexelStore& b)
{
    for (std::uint32_t f = 0; f < a.faceCount(); ++f) {
        if (a.face(faceId(f)) != b.face(faceId(f))) {
            return false;
        }
    }
    return a.faceCount() == b.faceCount() && a.format() == b.format();
}

inline std::vector<FaceId> allFaces(const TexelStore& store)
{
    std::vector<FaceId> faces;
    for (std::uint32_t f = 0; f < store.faceCount(); ++f) {
        faces.push_back(faceId(f));
    }
    return faces;
}

} // namespace trixel::test
