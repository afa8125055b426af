// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/face_pieces.h"

#include "core/mesh/shared_progress.h"

#include <algorithm>
#include <atomic>
#include <new>
#include <span>
#include <vector>

namespace trixel {

namespace {

tl::unexpected<Error> outOfMemory()
{
    return contentsError("what is made of the faces does not fit into memory");
}

/// Items numbered through: those of face 0 first.
std::vector<std::uint64_t> endsOf(std::size_t faces,
                                  const std::function<std::uint64_t(FaceId)>& itemsOf)
{
    std::vector<std::uint64_t> ends(faces);
    std::uint64_t end = 0;
    for (std::size_t f = 0; f < faces; ++f) {
        end += itemsOf(faceId(f));
        ends[f] = end;
    }
    return ends;
}

/// The pieces that items [begin, end) are.
void workOn(std::span<const std::uint64_t> ends,
            std::uint64_t begin,
            std::uint64_t end,
            const std::function<void(const FacePiece&)>& work)
{
    auto face = static_cast<std::size_t>(std::ranges::upper_bound(ends, begin) - ends.begin());
    while (begin < end) {
        const std::uint64_t first = face == 0 ? 0 : ends[face - 1];
        const std::uint64_t last = std::min(end, ends[face]);
        if (last > begin) {
            work({faceId(face), begin - first, last - begin});
            begin = last;
        }
        ++face;
    }
}

} // namespace

Status forFacePieces(std::size_t faces,
                     const std::function<std::uint64_t(FaceId)>& itemsOf,
                     Threads threads,
                     Progress& progress,
                     const std::function<void(const FacePiece&)>& work)
{
    const std::vector<std::uint64_t> ends = endsOf(faces, itemsOf);
    const std::uint64_t items = ends.empty() ? 0 : ends.back();
    const auto runs = static_cast<std::size_t>((items + kItemsAtOnce - 1) / kItemsAtOnce);
    if (!progress.report(0)) {
        return cancelled();
    }
    SharedProgress shared(progress, std::max<std::size_t>(runs, 1));
    std::atomic<bool> isOutOfMemory{false};
    parallelFor(runs, 1, threads, [&](std::size_t begin, std::size_t end) {
        try {
            for (std::size_t r = begin; r < end && shared.goesOn() && !isOutOfMemory; ++r) {
                workOn(ends, r * kItemsAtOnce, std::min(items, (r + 1) * kItemsAtOnce), work);
                shared.step();
            }
        } catch (const std::bad_alloc&) { // must not leave its thread
            isOutOfMemory = true;
        }
    });
    if (isOutOfMemory) {
        return outOfMemory();
    }
    return shared.goesOn() ? Status() : cancelled();
}

Status forWholeFaces(std::size_t faces,
                     const std::function<std::uint64_t(FaceId)>& itemsOf,
                     Threads threads,
                     Progress& progress,
                     const std::function<void(FaceId)>& work)
{
    // The piece that a face begins with stands for all of it.
    const auto atLeastOne = [&](FaceId face) { return std::max<std::uint64_t>(1, itemsOf(face)); };
    return forFacePieces(faces, atLeastOne, threads, progress, [&](const FacePiece& piece) {
        if (piece.first == 0) {
            work(piece.face);
        }
    });
}

} // namespace trixel
