// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/chain_cache.h"

#include "core/base/check.h"
#include "core/texture/pinned_face.h"
#include "core/texture/texel_codec.h"

#include <algorithm>

namespace trixel {
namespace {

/// Beside its values: nodes of the map and of the order.
constexpr std::size_t kEntryBytes = 112;

/// The chosen channels of consecutive texels.
void decodeChosen(const TexelFormat& format,
                  const ChosenChannels& channels,
                  std::span<const std::byte> texels,
                  float* values)
{
    const std::size_t stride = format.channels;
    const std::size_t count = texels.size() / format.texelBytes();
    withTexelType(format.type, [&](auto type) {
        using Codec = TexelCodec<decltype(type)::value>;
        using Stored = typename Codec::Stored;
        for (std::size_t c = 0; c < channels.size(); ++c) {
            if (channels[c] < 0) {
                for (std::size_t t = 0; t < count; ++t) {
                    values[t * kGroupChannels + c] = 1.0F;
                }
                continue;
            }
            const auto channel = static_cast<std::size_t>(channels[c]);
            for (std::size_t t = 0; t < count; ++t) {
                values[t * kGroupChannels + c] =
                    Codec::decoded(loadStored<Stored>(texels.data(), t * stride + channel));
            }
        }
    });
}

/// The face in memory, or the coarsest level that its file keeps which is fine enough.
FaceTexels readAtLeast(const FaceTexels& face, Level finest)
{
    if (!face.isLoaded()) {
        if (const auto mean = face.mean(); mean && finest == Level()) {
            return FaceTexels::constant(finest, *mean);
        }
        for (int k = finest.log2(); k < face.level().log2(); ++k) {
            if (auto kept = face.storedLevel(Level(k))) {
                return std::move(*kept);
            }
        }
    }
    return face.pinned();
}

} // namespace

void fillChain(const TexelFormat& format,
               const ChosenChannels& channels,
               const FaceTexels& face,
               float* values)
{
    check(!face.isStored() || face.isLoaded(), "texels in memory");
    decodeChosen(format, channels, face.bytes(), values);
    if (!face.isConstant()) {
        fillCoarser(face.level(), values);
    }
}

ChainCache::ChainCache(const ChosenChannels& channels, std::size_t mostBytes)
    : m_channels(channels)
    , m_mostBytes(mostBytes)
{
}

LevelTexels ChainCache::texels(const TexelStore& store, FaceId face, Level level)
{
    const auto number = static_cast<std::uint32_t>(face);
    Recent& recent = m_recent[number % m_recent.size()];
    if (recent.chain == nullptr || recent.face != number) {
        recent = {number, &chain(store, number)};
    }
    if (level > recent.chain->level) {
        check(level <= store.face(face).level(), "a level that the face has");
        Chain& coarse = m_chains.at(number);
        m_replaced.push_back(std::move(coarse.values));
        fill(store, number, level, coarse);
    }
    const Chain& known = *recent.chain;
    return known.constant ? LevelTexels{known.values.get(), 0}
                          : LevelTexels{known.values.get() + chainBegin(known.level, level)};
}

ChainCache::Chain& ChainCache::chain(const TexelStore& store, std::uint32_t face)
{
    const auto [at, isNew] = m_chains.try_emplace(face);
    Chain& chain = at->second;
    if (isNew) {
        chain.order = m_order.insert(m_order.begin(), face);
        fill(store, face, m_finest, chain);
    } else {
        m_order.splice(m_order.begin(), m_order, chain.order);
    }
    return chain;
}

void ChainCache::fill(const TexelStore& store, std::uint32_t face, Level finest, Chain& chain)
{
    const FaceTexels& whole = store.face(faceId(face));
    const FaceTexels read = whole.isStored() ? readAtLeast(whole, finest) : FaceTexels();
    const FaceTexels& texels = whole.isStored() ? read : whole;
    const std::size_t size = chainSize(texels.level(), texels.isConstant());
    if (!chain.values || chain.bytes != size * sizeof(float) + kEntryBytes) {
        chain.values = std::make_unique_for_overwrite<float[]>(size);
        m_bytes += size * sizeof(float) + kEntryBytes - chain.bytes;
        chain.bytes = size * sizeof(float) + kEntryBytes;
    }
    chain.level = whole.isConstant() ? whole.level() : texels.level();
    chain.constant = texels.isConstant();
    fillChain(store.format(), m_channels, texels, chain.values.get());
}

void ChainCache::update(const TexelStore& store, std::span<const TouchedRect> rects)
{
    for (const TouchedRect& rect : rects) {
        const auto at = m_chains.find(static_cast<std::uint32_t>(rect.face));
        if (at == m_chains.end()) {
            continue;
        }
        Chain& chain = at->second;
        const FaceTexels& face = store.face(rect.face);
        const bool follows =
            !rect.wholeFace && face.level() == chain.level && !chain.constant && !face.isConstant();
        if (!follows) {
            fill(store, at->first, m_finest, chain);
            continue;
        }
        const std::size_t r = chain.level.resolution();
        const std::size_t x0 = std::min<std::size_t>(rect.x, r);
        const std::size_t width = std::min<std::size_t>(rect.width, r - x0);
        const std::size_t end = std::min<std::size_t>(std::size_t{rect.y} + rect.height, r);
        const std::size_t bytes = store.format().texelBytes();
        for (std::size_t y = rect.y; y < end && width > 0; ++y) {
            const std::size_t first = x0 + y * r;
            decodeChosen(store.format(),
                         m_channels,
                         face.bytes().subspan(first * bytes, width * bytes),
                         chain.values.get() + first * kGroupChannels);
        }
        updateCoarser(chain.level, rect, chain.values.get());
    }
}

void ChainCache::trim()
{
    m_replaced.clear();
    while (m_bytes > m_mostBytes && !m_order.empty()) {
        give(m_order.back());
    }
}

void ChainCache::forget()
{
    while (!m_order.empty()) {
        give(m_order.back());
    }
}

void ChainCache::give(std::uint32_t face)
{
    Recent& recent = m_recent[face % m_recent.size()];
    if (recent.face == face) {
        recent.chain = nullptr;
    }
    const auto at = m_chains.find(face);
    m_bytes -= at->second.bytes;
    m_order.erase(at->second.order);
    m_chains.erase(at);
}

} // namespace trixel
