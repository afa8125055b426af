// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/value_range.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <unordered_set>
#include <vector>

namespace trixel {

namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();

/// One face of all that share their values: unpainted meshes and tiles have few.
std::vector<FaceId> distinctFaces(const FloatMips& mips)
{
    std::unordered_set<const float*> seen;
    std::vector<FaceId> faces;
    for (std::size_t f = 0; f < mips.faceCount(); ++f) {
        const bool isRun = f > 0 && mips.share(faceId(f), faceId(f - 1));
        if (!isRun && seen.insert(mips.average(faceId(f))).second) {
            faces.push_back(faceId(f));
        }
    }
    return faces;
}

} // namespace

ValueBounds ValueBounds::of(const FloatMips& mips, Threads threads)
{
    constexpr std::size_t kGrain = 64;
    const std::vector<FaceId> faces = distinctFaces(mips);
    ValueBounds all;
    std::mutex mutex;
    parallelFor(faces.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
        ValueBounds part;
        for (std::size_t k = begin; k < end; ++k) {
            part.add(mips, faces[k]);
        }
        const std::lock_guard lock(mutex);
        all.add(part.m_channels);
    });
    return all;
}

void ValueBounds::add(const FloatMips& mips, FaceId face)
{
    const auto width = static_cast<std::size_t>(kGroupChannels);
    m_channels.resize(static_cast<std::size_t>(mips.groups()) * width, {kNever, -kNever});
    const Level level = mips.level(face);
    const std::uint32_t count = mips.isConstant(face) ? 1 : level.texelCount();
    for (int group = 0; group < mips.groups(); ++group) {
        const LevelTexels texels = mips.texels(face, level, group);
        Span* channels = &m_channels[static_cast<std::size_t>(group) * width];
        for (std::uint32_t i = 0; i < count; ++i) {
            const float* texel = texels.texel(TexelIndex{i});
            for (std::size_t c = 0; c < width; ++c) {
                if (std::isfinite(texel[c])) {
                    channels[c].low = std::min(channels[c].low, texel[c]);
                    channels[c].high = std::max(channels[c].high, texel[c]);
                }
            }
        }
    }
}

void ValueBounds::add(std::span<const Span> others)
{
    m_channels.resize(std::max(m_channels.size(), others.size()), {kNever, -kNever});
    for (std::size_t c = 0; c < others.size(); ++c) {
        m_channels[c].low = std::min(m_channels[c].low, others[c].low);
        m_channels[c].high = std::max(m_channels[c].high, others[c].high);
    }
}

double ValueBounds::range() const
{
    double range = 0; // the span of channels never seen is negative
    for (const Span& channel : m_channels) {
        range = std::max(range, double{channel.high} - double{channel.low});
    }
    return range;
}

double valueRange(const FloatMips& mips, Threads threads)
{
    return ValueBounds::of(mips, threads).range();
}

} // namespace trixel
