// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/float_mips.h"

#include "core/lattice/reduction.h"
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

/// One texel of the coarser level by the rule of `finerPixels`.
void reduceTexel(Level fine, const float* source, std::uint32_t x, std::uint32_t y, float* target)
{
    const auto finer =
        finerPixels(fine, {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)});
    std::array<const float*, 4> from{};
    std::ranges::transform(finer, from.begin(), [&](PackedPixel pixel) {
        return source + kGroupChannels * indexOf(texelIndex(fine, pixel));
    });
    float* to = target + kGroupChannels * (std::size_t{y} * (fine.resolution() / 2) + x);
    for (int c = 0; c < kGroupChannels; ++c) {
        to[c] = 0.25F * ((from[0][c] + from[1][c]) + (from[2][c] + from[3][c]));
    }
}

void reduceGroup(Level fine, const float* source, float* target)
{
    const std::uint32_t resolution = fine.coarser().resolution();
    for (std::uint32_t y = 0; y < resolution; ++y) {
        for (std::uint32_t x = 0; x < resolution; ++x) {
            reduceTexel(fine, source, x, y, target);
        }
    }
}

/// Both texels of the cells; how many.
std::size_t reduceCells(Level fine, const float* source, const CellRect& cells, float* target)
{
    const std::uint32_t r = fine.coarser().resolution();
    std::size_t count = 0;
    for (std::uint32_t j = cells.j0; j <= cells.j1; ++j) {
        for (std::uint32_t i = cells.i0; i <= cells.i1 && i + j < r; ++i) {
            reduceTexel(fine, source, i, j, target);
            ++count;
            if (i + j + 1 < r) {
                reduceTexel(fine, source, r - 1 - j, r - 1 - i, target);
                ++count;
            }
        }
    }
    return count;
}

/// Everything of one face, from its texels.
void fillChain(const TexelFormat& format, const FaceTexels& face, std::size_t group, float* values)
{
    std::vector<float> decoded(face.bytes().size() / byteSize(format.type));
    decode(format.type, face.bytes(), decoded);
    splitIntoGroups(decoded, format.channels, group, values);
    if (face.isConstant()) {
        return;
    }
    for (int first = 0; first < format.channels; first += kGroupChannels, values += group) {
        float* source = values;
        for (Level level = face.level(); level > Level(0); level = level.coarser()) {
            float* target = source + kGroupChannels * std::size_t{level.texelCount()};
            reduceGroup(level, source, target);
            source = target;
        }
    }
}

} // namespace

float* FloatMips::renew(const TexelStore& store, FaceId face)
{
    const FaceTexels& texels = store.face(face);
    const std::size_t size = groupSize(texels.level(), texels.isConstant());
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
        std::vector<FaceId>& alike = known[face.bytes().data()];
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
                const std::size_t size = groupSize(face.level(), face.isConstant());
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
        const std::size_t size = groupSize(face.level(), face.isConstant());
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
    const std::size_t size = groupSize(base, false);
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
        TouchedCells cells(base, rect);
        for (Level level = base; level > Level(0); level = level.coarser()) {
            cells = cells.coarser();
            for (std::size_t k = 0; k < cells.count; ++k) {
                count += reduceCells(level,
                                     values + chainBegin(base, level),
                                     cells.rects[k],
                                     values + chainBegin(base, level.coarser()));
            }
        }
    }
    return count;
}

} // namespace trixel
