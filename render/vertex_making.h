// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vertices of the conforming pyramid on their way to the graphics card: made on any thread from a
// snapshot of the store.
#pragma once

#include "core/texture/chain_cache.h"
#include "render/block_making.h"
#include "render/filter_mesh.h"

#include <cstddef>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace trixel::render {

/// Mips of faces that threads make vertices of, kept from one batch of jobs to the next: neighbours
/// need each other's. Of one store as it is.
class SharedChains
{
public:
    explicit SharedChains(const CardChannels& channels)
        : m_channels(channels)
    {
    }

    /// A cache for one thread, to be given back.
    std::unique_ptr<ChainCache> take();
    void giveBack(std::unique_ptr<ChainCache> chains);

private:
    CardChannels m_channels;
    std::mutex m_mutex;
    std::vector<std::unique_ptr<ChainCache>> m_spare;
};

/// The vertices of level 0 of every face, three each: means over the faces that meet at a corner of
/// these faces' means, for which faces in memory are read as a whole.
CardOpening openVertices(const TexelStore& store,
                         const CardForm& form,
                         const FilterMesh& mesh,
                         Threads threads);

/// The vertices of all levels up to that of each job. A face that is coarser by now, or one
/// constant with all about it, cannot be done at a finer level. Of faces still in their file
/// coarser levels are those that the file keeps.
MadeBlocks makeVertexBlocks(const TexelStore& store,
                            const CardForm& form,
                            const FilterMesh& mesh,
                            std::span<const BlockJob> jobs,
                            SharedChains& chains);

/// What vertices are needed for: as `FaceExtents::of`, with edges so long that `wishesOf` asks for
/// every level that filtering over vertices may look at anywhere in a face. There levels go by what
/// is interpolated between mesh vertices, which may be finer than a face's own edges suggest.
FaceExtents vertexExtents(const TriangleMesh& mesh, const FilterMesh& filterMesh, Threads threads);

} // namespace trixel::render
