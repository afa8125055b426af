// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/prepared_opening.h"

#include <algorithm>
#include <utility>

namespace trixel::render {

namespace {

/// Elements of blocks that a buffer is made for at first; it grows where a view needs more.
constexpr std::uint64_t kUsualElements = 1U << 24U;
/// Room to spare, so that painting unpainted faces seldom needs a larger buffer.
constexpr std::uint64_t kLeastSpare = 1U << 18U;

} // namespace

FreshBlocks FreshBlocks::of(BlockKind kind, const CardOpening& opening, std::uint32_t maxElements)
{
    const std::size_t count = opening.faces.size();
    std::uint64_t elements = 0;
    for (const std::uint8_t face : opening.faces) {
        const bool isConstant = (face & CardOpening::kConstant) != 0;
        elements += isConstant ? 0 : elementsOf(kind, Level(CardOpening::level(face)));
    }
    elements = std::min(elements, kUsualElements);
    const std::uint64_t bases = count * elementsOf(kind, Level());
    const std::uint64_t capacity = bases + elements + std::max(elements / 4, kLeastSpare);
    FreshBlocks fresh;
    fresh.maxElements = maxElements;
    fresh.blocks = CardBlocks(
        kind, count, static_cast<std::uint32_t>(std::min<std::uint64_t>(capacity, maxElements)));
    fresh.room = CardRoom::of(fresh.blocks, fresh.blocks.heapElements());
    fresh.faces.resize(count);
    for (std::size_t f = 0; f < count; ++f) {
        fresh.faces[f].own = opening.ownLevel(f);
        fresh.blocks.mark(faceId(f), opening.recordBits(f));
    }
    (void)fresh.blocks.takeChanged(); // all records are sent
    return fresh;
}

PreparedOpening
PreparedOpening::of(BlockKind kind, CardOpening opening, std::optional<std::uint32_t> maxElements)
{
    PreparedOpening prepared;
    if (maxElements) {
        prepared.fresh = FreshBlocks::of(kind, opening, *maxElements);
    }
    prepared.hasNoMean.resize(opening.faces.size());
    for (std::size_t f = 0; f < opening.faces.size(); ++f) {
        if ((opening.faces[f] & CardOpening::kMean) == 0) {
            prepared.hasNoMean[f] = true;
            prepared.noMeans.push_back(faceId(f));
        }
    }
    prepared.opening = std::move(opening);
    return prepared;
}

} // namespace trixel::render
