// SPDX-License-Identifier: GPL-3.0-or-later
//
// All faces of a texture packed into blocks, ready to be written.
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/ptx_layout.h"
#include "core/io/ptx_reductions.h"
#include "core/mesh/adjacency.h"
#include "core/texture/texel_store.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace trixel {

/// Blocks one after the other, and their headers.
struct PtxBlocks
{
    std::vector<std::byte> bytes;
    std::vector<PtxBlockHeader> headers;
};

/// The blocks of a stretch of faces.
struct PtxChunk
{
    PtxBlocks texels; ///< a header for every face, constant ones included
    /// [level of the faces][reductions - 1]: of the faces of one level, in the order of their ids.
    std::array<std::vector<PtxBlocks>, Level::kMax + 1> reductions;
};

struct PtxFaces
{
    std::vector<PtxChunk> chunks; ///< in the order of the faces
    std::vector<PtxFaceInfo> infos;
    std::vector<std::byte> constants; ///< one texel a face: its value or its average
    int levelCount = 1;

    /// Visits the blocks of one level in the order of the file: full resolution by face number,
    /// reductions from the largest faces to the smallest.
    template <class Visit>
    void forEachBlocks(int reduction, Visit visit) const
    {
        if (reduction == 0) {
            for (const PtxChunk& chunk : chunks) {
                visit(chunk.texels);
            }
            return;
        }
        const auto wanted = static_cast<std::size_t>(reduction);
        for (std::size_t level = Level::kMax; level > wanted; --level) {
            for (const PtxChunk& chunk : chunks) {
                if (chunk.reductions[level].size() >= wanted) {
                    visit(chunk.reductions[level][wanted - 1]);
                }
            }
        }
    }
};

/// Packs every face, in parallel; the result does not depend on the number of threads. Errors name
/// a face that is larger than the format can hold, or that could not be read from its own file.
/// \param adjacency  of as many faces as the store has (checked)
Result<PtxFaces> packPtxFaces(const TexelStore& store,
                              const Adjacency& adjacency,
                              bool mips,
                              Threads threads,
                              Progress& progress);

} // namespace trixel
