// SPDX-License-Identifier: GPL-3.0-or-later
//
// Textures to write and read back, made up deterministically.
#pragma once

#include "core/io/ptx.h"
#include "core/texture/texel_format.h"

#include <cstdint>
#include <random>
#include <span>
#include <vector>

namespace trixel::samples {

/// Faces in a strip, each sharing an edge with the next.
inline Adjacency strip(std::uint32_t faceCount)
{
    Adjacency adjacency(faceCount);
    for (std::uint32_t k = 0; k + 1 < faceCount; ++k) {
        adjacency.connect(faceId(k), LocalEdge::E1, faceId(k + 1), LocalEdge::E0);
    }
    return adjacency;
}

/// Any bytes; of half and float, no NaN and no infinity.
inline std::vector<std::byte> randomTexels(const TexelFormat& format, Level level, unsigned seed)
{
    std::mt19937 random(seed);
    std::vector<float> values(std::size_t{level.texelCount()} * format.channels);
    for (float& value : values) {
        value = static_cast<float>(random() % 65536) / 65535.0F;
    }
    std::vector<std::byte> bytes(values.size() * byteSize(format.type));
    encode(format.type, values, bytes);
    return bytes;
}

/// One face of each level given; every fourth is constant.
inline PtxContents mixed(const TexelFormat& format, std::span<const int> levels)
{
    const auto count = static_cast<std::uint32_t>(levels.size());
    const auto grey = randomTexels(format, Level(), 99);
    PtxContents contents;
    contents.texels = TexelStore(count, format, Level(), grey);
    contents.adjacency = strip(count);
    for (std::uint32_t k = 0; k < count; ++k) {
        const Level level(levels[k]);
        contents.texels.exchange(
            faceId(k),
            k % 4 == 3
                ? FaceTexels::constant(level, randomTexels(format, Level(), k))
                : FaceTexels::full(level, format.texelBytes(), randomTexels(format, level, k)));
    }
    return contents;
}

} // namespace trixel::samples
