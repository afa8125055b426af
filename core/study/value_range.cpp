// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/value_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <vector>

namespace trixel {
namespace {

/// Least and greatest of every channel of a group.
struct Bounds
{
    std::array<float, kGroupChannels> low;
    std::array<float, kGroupChannels> high;

    Bounds()
    {
        low.fill(std::numeric_limits<float>::infinity());
        high.fill(-std::numeric_limits<float>::infinity());
    }
    void add(const float* texel)
    {
        for (std::size_t c = 0; c < low.size(); ++c) {
            if (std::isfinite(texel[c])) {
                low[c] = std::min(low[c], texel[c]);
                high[c] = std::max(high[c], texel[c]);
            }
        }
    }
    void add(const Bounds& other)
    {
        for (std::size_t c = 0; c < low.size(); ++c) {
            low[c] = std::min(low[c], other.low[c]);
            high[c] = std::max(high[c], other.high[c]);
        }
    }
};

void addFace(const FloatMips& mips, FaceId face, std::vector<Bounds>& groups)
{
    const Level level = mips.level(face);
    const std::uint32_t count = mips.isConstant(face) ? 1 : level.texelCount();
    for (int group = 0; group < mips.groups(); ++group) {
        const LevelTexels texels = mips.texels(face, level, group);
        Bounds& bounds = groups[static_cast<std::size_t>(group)];
        for (std::uint32_t i = 0; i < count; ++i) {
            bounds.add(texels.texel(TexelIndex{i}));
        }
    }
}

} // namespace

double valueRange(const FloatMips& mips, Threads threads)
{
    constexpr std::size_t kGrain = 256;
    std::vector<Bounds> all(static_cast<std::size_t>(mips.groups()));
    std::mutex mutex;
    parallelFor(mips.faceCount(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
        std::vector<Bounds> part(all.size());
        for (std::size_t f = begin; f < end; ++f) {
            // Unpainted meshes are long runs of one value.
            if (f == begin || !mips.share(faceId(f), faceId(f - 1))) {
                addFace(mips, faceId(f), part);
            }
        }
        const std::lock_guard lock(mutex);
        for (std::size_t g = 0; g < all.size(); ++g) {
            all[g].add(part[g]);
        }
    });
    double range = 0;
    for (const Bounds& bounds : all) {
        for (std::size_t c = 0; c < bounds.low.size(); ++c) {
            range = std::max(range, double{bounds.high[c]} - double{bounds.low[c]});
        }
    }
    return range; // spans of no texel at all are -infinity
}

} // namespace trixel
