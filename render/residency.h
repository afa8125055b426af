// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which faces are to be on the graphics card at which level. Plain data, no OpenGL; every function
// may run on any thread.
#pragma once

#include "core/base/parallel.h"
#include "core/mesh/triangle_mesh.h"
#include "render/camera.h"
#include "render/card_blocks.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace trixel::render {

/// A sphere around each face and its longest edge: 20 bytes a face, laid out for one loop.
struct FaceExtents
{
    std::vector<float> x, y, z, radius, edge;

    static FaceExtents of(const TriangleMesh& mesh, Threads threads);
    std::size_t size() const { return x.size(); }
};

/// The level a face needs in eighths, as if it were as fine as wished: 0 to `kMostWish`.
using Wish = std::uint8_t;
inline constexpr Wish kMostWish = 8 * Level::kMax;
inline constexpr Wish kUnseen = 0xff;

/// What each face needs: texels whose edges take at most a pixel where the face is nearest, so that
/// whatever is shown coarser than it is has texels smaller than a pixel. Faces outside of the view,
/// and of a tenth more around it, are `kUnseen`.
void wishesOf(const FaceExtents& faces,
              const Camera& camera,
              Threads threads,
              std::span<Wish> wishes);

/// Make a face's block anew at a level, or at level 0 its base.
struct BlockJob
{
    FaceId face{};
    std::uint8_t level = 0;

    bool operator==(const BlockJob&) const = default;
};

/// What of a face is on the card.
struct FaceOnCard
{
    static constexpr std::uint8_t kStale = 0x80; ///< what is there is not what it should be

    std::uint8_t own = 0;   ///< finest level worth a block; 0 where the base says all
    std::uint8_t shown = 0; ///< level of its block, and `kStale`

    int level() const { return shown & ~kStale; }
    bool isStale() const { return (shown & kStale) != 0; }
};

/// What there is room for.
struct CardRoom
{
    std::uint64_t elements = 0; ///< for blocks
    /// That a block takes, with its share of what is left over.
    std::array<std::uint32_t, Level::kMax + 1> perBlock{};

    /// Of blocks that may take a buffer of so many elements.
    static CardRoom of(const CardBlocks& blocks, std::uint64_t elements);
};

/// What to do, in this order, so that the card holds what a view needs.
struct ResidencyPlan
{
    /// Eighths of a level by which every wish is cut, because not all fit.
    int bias = 0;
    std::uint64_t elements = 0;       ///< in blocks once all is done, at least
    std::uint64_t facesInView = 0;    ///< or close to it
    std::vector<std::uint8_t> wanted; ///< level a face: the wish, cut; 0 out of view
    std::vector<FaceId> release;      ///< blocks that hold what must not be shown
    std::vector<BlockJob> make;       ///< coarse ones first, then the largest on the screen
    std::vector<BlockJob> spare; ///< what can become coarser where room is needed, in this order
};

/// \param wishes  one a face; those out of view need only their base
/// \param faces   the same number
ResidencyPlan planResidency(std::span<const Wish> wishes,
                            std::span<const FaceOnCard> faces,
                            const CardRoom& room);

} // namespace trixel::render
