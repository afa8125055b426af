// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/float_mips.h"

#include "core/texture/pinned_face.h"
#include "core/texture/texel_format.h"
#include "core/texture/touched_cells.h"

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
    const auto all = static_cast<std::size_t>(channels);
    const std::size_t count = texels.size() / all;
    for (std::size_t first = 0; first < all; first += kGroupChannels) {
        float* group = values + first / kGroupChannels * groupSize;
        const std::size_t some = std::min<std::size_t>(kGroupChannels, all - first);
        for (std::size_t t = 0; t < count; ++t) {
            for (std::size_t c = 0; c < kGroupChannels; ++c) {
                group[t * kGroupChannels + c] = c < some ? texels[t * all + first + c] : 0.0F;
            }
        }
    }
}

/// Everything of one face, from its texels.
void fillChain(const TexelFormat& format, const FaceTexels& face, std::size_t group, float* values)
{
    const PinnedFace pin(face);
    std::vector<float> decoded(face.byteCount() / byteSize(format.type));
    decode(format.type, pin->bytes(), decoded);
    splitIntoGroups(decoded, format.channels, group, values);
    if (face.isConstant()) {
        return;
    }
    for (int first = 0; first < format.channels; first += kGroupChannels, values += group) {
        fillCoarser(face.level(), values);
    }
}

} // namespace

float* FloatMips::renew(const TexelStore& store, FaceId face)
{
    const FaceTexels& texels = store.face(face);
    const std::size_t size = chainSize(texels.level(), texels.isConstant());
    return m_chains.renew(
        face, texels.level(), texels.isConstant(), size * static_cast<std::size_t>(groups()));
}

Result<FloatMips> FloatMips::build(const TexelStore& store, Threads threads, Progress& progress)
{
    FloatMips mips;
    mips.m_channels = store.format().channels;
    mips.m_chains = SharedBlocks(store.faceCount());

    // Faces that share their bytes are the same work; the level is part of the key because a
    // constant may be shared between levels.
    std::vector<FaceId> first;
    std::vector<float*> chains;
    std::unordered_map<const std::byte*, std::vector<FaceId>> known;
    std::size_t texels = 0;
    FaceId last{};
    for (std::uint32_t f = 0; f < store.faceCount(); ++f) {
        const FaceTexels& face = store.face(faceId(f));
        const auto same = [&](FaceId other) {
            const FaceTexels& there = store.face(other);
            return there.sharesBytesWith(face) && there.level() == face.level();
        };
        if (f > 0 && same(last)) {
            mips.m_chains.share(faceId(f), last);
            continue;
        }
        // Stored faces are each their own, and their texels need not be there yet.
        std::vector<FaceId>& alike = known[face.isStored() ? nullptr : face.bytes().data()];
        if (face.isStored()) {
            alike.clear();
        }
        const auto found = std::ranges::find_if(alike, same);
        if (found != alike.end()) {
            mips.m_chains.share(faceId(f), *found);
            last = *found;
            continue;
        }
        alike.push_back(faceId(f));
        first.push_back(faceId(f));
        chains.push_back(mips.renew(store, faceId(f)));
        texels += face.isConstant() ? 1 : face.level().texelCount();
        last = faceId(f);
    }

    constexpr std::size_t kTexelsBetweenReports = 1U << 20U;
    const std::size_t mean = texels / std::max<std::size_t>(first.size(), 1) + 1;
    const std::size_t step = std::clamp<std::size_t>(kTexelsBetweenReports / mean, 1, 4096);
    const std::size_t grain = std::clamp<std::size_t>(4096 / mean, 1, 64);
    for (std::size_t begin = 0; begin < first.size(); begin += step) {
        if (!progress.report(static_cast<double>(begin) / static_cast<double>(first.size()))) {
            return cancelled();
        }
        const std::size_t count = std::min(step, first.size() - begin);
        parallelFor(count, grain, threads, [&](std::size_t from, std::size_t to) {
            for (std::size_t i = begin + from; i < begin + to; ++i) {
                const FaceTexels& face = store.face(first[i]);
                const std::size_t size = chainSize(face.level(), face.isConstant());
                fillChain(store.format(), face, size, chains[i]);
            }
        });
    }
    return mips;
}

std::size_t FloatMips::update(const TexelStore& store, std::span<const TouchedRect> rects)
{
    std::unordered_set<std::uint32_t> renewed;
    std::size_t count = 0;
    for (const TouchedRect& rect : rects) {
        const FaceTexels& face = store.face(rect.face);
        const auto number = static_cast<std::uint32_t>(rect.face);
        const SharedBlocks::Block& chain = m_chains.block(rect.face);
        const bool alike = chain.level == face.level() && !chain.constant && !face.isConstant();
        if (renewed.contains(number)) {
            continue;
        }
        if (alike && !rect.wholeFace) {
            count += updateRect(store, rect);
            continue;
        }
        renewed.insert(number);
        const std::size_t size = chainSize(face.level(), face.isConstant());
        fillChain(store.format(), face, size, renew(store, rect.face));
        count += m_chains.block(rect.face).size / kGroupChannels;
    }
    return count;
}

std::size_t FloatMips::updateRect(const TexelStore& store, const TouchedRect& rect)
{
    const TexelFormat& format = store.format();
    const FaceTexels& face = store.face(rect.face);
    const Level base = face.level();
    const std::size_t size = chainSize(base, false);
    const std::size_t r = base.resolution();
    const std::size_t width =
        std::min<std::size_t>(rect.width, r - std::min<std::size_t>(rect.x, r));
    const std::size_t end = std::min<std::size_t>(std::size_t{rect.y} + rect.height, r);
    float* values = m_chains.writable(rect.face);
    std::vector<float> row(width * format.channels);
    std::size_t count = 0;
    for (std::size_t y = rect.y; y < end && width > 0; ++y) {
        const std::size_t first = rect.x + y * r;
        const auto bytes =
            face.bytes().subspan(first * format.texelBytes(), width * format.texelBytes());
        decode(format.type, bytes, row);
        splitIntoGroups(row, format.channels, size, values + first * kGroupChannels);
        count += width * static_cast<std::size_t>(groups());
    }
    for (int group = 0; group < groups(); ++group, values += size) {
        count += updateCoarser(base, rect, values);
    }
    return count;
}

} // namespace trixel
