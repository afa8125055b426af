// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ids.h"
#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <functional>

namespace trixel {

/// Some of the items that there are of a face: texels, samples, points along edges.
struct FacePiece
{
    FaceId face{};
    std::uint64_t first = 0;
    std::uint64_t count = 0; ///< at least 1
};

/// Items that one thread works on between two looks at the progress.
inline constexpr std::uint64_t kItemsAtOnce = 4096;

/// Calls `work` on pieces that cover all items of faces 0 to `faces` - 1 once, from several
/// threads: small faces many at a time, large ones in pieces of at most `kItemsAtOnce`, so that a
/// mesh of two large faces keeps every core busy, tells how far it is and can be cancelled all the
/// same. \param itemsOf  of a face; may be 0 \param work     its result may not depend on how faces
/// are cut; may throw std::bad_alloc Fails when cancelled and when memory runs out; some pieces are
/// done then, others not.
Status forFacePieces(std::size_t faces,
                     const std::function<std::uint64_t(FaceId)>& itemsOf,
                     Threads threads,
                     Progress& progress,
                     const std::function<void(const FacePiece&)>& work);

/// The same for work that takes a face whole: large faces one at a time.
/// \param itemsOf  what a face costs, in items
Status forWholeFaces(std::size_t faces,
                     const std::function<std::uint64_t(FaceId)>& itemsOf,
                     Threads threads,
                     Progress& progress,
                     const std::function<void(FaceId)>& work);

} // namespace trixel
