// SPDX-License-Identifier: GPL-3.0-or-later
//
// An opening with all that takes long done to it, on any thread. Plain data, no OpenGL.
#pragma once

#include "render/block_making.h"
#include "render/card_blocks.h"
#include "render/residency.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace trixel::render {

/// Blocks for faces none of which is on the card yet.
struct FreshBlocks
{
    std::uint32_t maxElements = 0; ///< that the buffer may have
    CardBlocks blocks;             ///< every face with its base alone, as the opening tells of it
    CardRoom room;                 ///< in the buffer as it is
    std::vector<FaceOnCard> faces;

    static FreshBlocks of(BlockKind kind, const CardOpening& opening, std::uint32_t maxElements);
};

/// What `DisplayBlocks` opens with.
struct PreparedOpening
{
    CardOpening opening;
    std::optional<FreshBlocks> fresh; ///< where no blocks are kept from before
    std::vector<bool> hasNoMean;      ///< a face: whether its base is not its mean
    std::vector<FaceId> noMeans;      ///< the same

    /// \param maxElements  for blocks of its own; none where those that are there go on
    static PreparedOpening
    of(BlockKind kind, CardOpening opening, std::optional<std::uint32_t> maxElements);
};

} // namespace trixel::render
