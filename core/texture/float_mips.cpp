// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/float_mips.h"

#include "core/lattice/reduction.h"
#include "core/texture/texel_format.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace trixel {
namespace {

/// Interleaved channels of any number → groups of four, the missing ones 0.
void splitIntoGroups(std::span<const float> texels,
                     int channels,
                     std::size_t groupSize,
                     float* values)
{
    const std::size_t count = texels.size() / static_cast<std::size_t>(channels);
    for (std::size_t t = 0; t < count; ++t) {
        for (int c = 0; c < channels; ++c) {
            const auto group = static_cast<std::size_t>(c / kGroupChannels);
            values[group * groupSize + t * kGroupChannels + std::size_t(c % kGroupChannels)] =
                texels[t * static_cast<std::size_t>(channels) + static_cast<std::size_t>(c)];
        }
    }
}

/// One level coarser by the rule of `finerPixels`.
void reduceGroup(Level fine, const float* source, float* target)
{
    const std::uint32_t resolution = fine.coarser().resolution();
    for (std::uint32_t y = 0; y < resolution; ++y) {
        for (std::uint32_t x = 0; x < resolution; ++x) {
            const auto finer =
                finerPixels(fine, {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)});
            std::array<const float*, 4> from{};
            std::ranges::transform(finer, from.begin(), [&](PackedPixel pixel) {
                return source + kGroupChannels * indexOf(texelIndex(fine, pixel));
            });
            float* to = target + kGroupChannels * (std::size_t{y} * resolution + x);
            for (int c = 0; c < kGroupChannels; ++c) {
                to[c] = 0.25F * ((from[0][c] + from[1][c]) + (from[2][c] + from[3][c]));
            }
        }
    }
}

} // namespace

std::size_t FloatMips::chainBegin(Level base, Level level)
{
    // 4^base + ... + 4^(level + 1) texels come before.
    const std::size_t texels =
        (4 * std::size_t{base.texelCount()} - 4 * std::size_t{level.texelCount()}) / 3;
    return kGroupChannels * texels;
}

std::shared_ptr<const FloatMips::Chain> FloatMips::makeChain(const TexelFormat& format,
                                                             const FaceTexels& face)
{
    auto chain = std::make_shared<Chain>();
    chain->level = face.level();
    chain->constant = face.isConstant();
    chain->groupSize =
        chain->constant ? kGroupChannels : chainBegin(face.level(), Level(0)) + kGroupChannels;
    const int groups = (format.channels + kGroupChannels - 1) / kGroupChannels;
    chain->values = std::make_unique<float[]>(chain->groupSize * static_cast<std::size_t>(groups));

    std::vector<float> decoded(face.bytes().size() / byteSize(format.type));
    decode(format.type, face.bytes(), decoded);
    splitIntoGroups(decoded, format.channels, chain->groupSize, chain->values.get());
    for (int group = 0; group < groups && !chain->constant; ++group) {
        float* values = chain->values.get() + static_cast<std::size_t>(group) * chain->groupSize;
        for (Level level = face.level(); level > Level(0); level = level.coarser()) {
            reduceGroup(level,
                        values + chainBegin(face.level(), level),
                        values + chainBegin(face.level(), level.coarser()));
        }
    }
    return chain;
}

Result<FloatMips> FloatMips::build(const TexelStore& store, Threads threads, Progress& progress)
{
    FloatMips mips;
    mips.m_channels = store.format().channels;
    mips.m_chains = FaceMap<std::shared_ptr<const Chain>>(store.faceCount());

    // Faces that share their bytes are the same work; the level is part of the key because a
    // constant may be shared between levels.
    std::vector<FaceId> first;
    std::vector<std::uint32_t> original(store.faceCount());
    std::unordered_map<const std::byte*, std::vector<std::uint32_t>> known;
    for (std::uint32_t f = 0; f < store.faceCount(); ++f) {
        const FaceTexels& face = store.face(faceId(f));
        std::vector<std::uint32_t>& alike = known[face.bytes().data()];
        const auto same = std::ranges::find_if(alike, [&](std::uint32_t other) {
            return store.face(first[other]).level() == face.level();
        });
        original[f] = same != alike.end() ? *same : static_cast<std::uint32_t>(first.size());
        if (same == alike.end()) {
            alike.push_back(original[f]);
            first.push_back(faceId(f));
        }
    }

    constexpr std::size_t kFacesBetweenReports = 4096;
    std::vector<std::shared_ptr<const Chain>> chains(first.size());
    for (std::size_t begin = 0; begin < first.size(); begin += kFacesBetweenReports) {
        if (!progress.report(static_cast<double>(begin) / static_cast<double>(first.size()))) {
            return cancelled();
        }
        const std::size_t count = std::min(kFacesBetweenReports, first.size() - begin);
        parallelFor(count, 16, threads, [&](std::size_t from, std::size_t to) {
            for (std::size_t i = begin + from; i < begin + to; ++i) {
                chains[i] = makeChain(store.format(), store.face(first[i]));
            }
        });
    }
    for (std::uint32_t f = 0; f < store.faceCount(); ++f) {
        mips.m_chains[faceId(f)] = chains[original[f]];
    }
    return mips;
}

void FloatMips::update(const TexelStore& store, std::span<const TouchedRect> rects)
{
    std::unordered_set<std::uint32_t> done;
    for (const TouchedRect& rect : rects) {
        if (done.insert(static_cast<std::uint32_t>(rect.face)).second) {
            m_chains[rect.face] = makeChain(store.format(), store.face(rect.face));
        }
    }
}

std::size_t FloatMips::memoryBytes() const
{
    std::unordered_set<const Chain*> counted;
    std::size_t bytes = m_chains.size() * sizeof(std::shared_ptr<const Chain>);
    for (const auto& chain : m_chains.values()) {
        if (counted.insert(chain.get()).second) {
            bytes += sizeof(Chain) + chain->groupSize * static_cast<std::size_t>(groups()) * 4;
        }
    }
    return bytes;
}

} // namespace trixel
