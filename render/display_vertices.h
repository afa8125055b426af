// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which lattice vertices lie where on the graphics card and which have to be sent. Plain data, no
// OpenGL.
#pragma once

#include "core/texture/chain_cache.h"
#include "core/texture/face_vertices.h"
#include "core/texture/touched_vertices.h"
#include "render/display_texels.h"
#include "render/filter_mesh.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <unordered_set>
#include <vector>

namespace trixel::render {

/// Layout of the conforming pyramid of a store on the graphics card: for every face the vertices of
/// all its levels (`core/texture/vertex_block.h`), those of level 0 where the face and all about it
/// are one constant. What is sent is made when it is sent, from the store. Works as `DisplayTexels`.
class DisplayVertices
{
public:
    /// Starts over with a store.
    /// \param mesh         of the store's faces (checked)
    /// \param mipDrop      show every face this many levels coarser (>= 0)
    /// \param maxVertices  most vertices the buffer can have; levels are dropped further to fit
    void reset(std::shared_ptr<const FilterMesh> mesh,
               const TexelStore& store,
               int mipDrop,
               std::uint64_t maxVertices);
    /// Notes that texels changed. The store must be the one of `reset`, as it is now.
    /// \return  false where the layout does not fit them any more
    bool touch(const TexelStore& store, std::span<const TouchedRect> rects);
    /// The same where every texel may have changed. What is on the card stays until it is replaced.
    bool touchAll();
    /// Sends other channels from now on, and all vertices anew where they are others.
    void showChannels(const CardChannels& channels);

    /// Makes what is to be sent next: all that was touched, then faces not sent yet until
    /// `byteBudget` is reached (at least one face).
    DisplayUpdate take(const TexelStore& store, std::size_t byteBudget);
    /// Whether `take` has something to give.
    bool hasWork() const;

    DisplayFormat format() const { return m_format; }
    std::span<const FaceRecord> records() const { return m_records; }
    /// Levels dropped in fact: the drop asked for, more if the vertices would not fit.
    int levelsDropped() const { return m_drop; }
    std::uint32_t verticesUsed() const { return m_used; }

private:
    void layOut(const TexelStore& store);
    std::uint32_t sizeOf(const TexelStore& store, FaceId face, bool isConstant) const;
    bool place(const TexelStore& store, FaceId face, bool isConstant);
    /// Faces whose vertices depend on a face.
    void addAbout(FaceId face);
    void emitTouched(const TexelStore& store, DisplayUpdate& update);
    void emitPending(const TexelStore& store, std::size_t byteBudget, DisplayUpdate& update);
    void append(const FaceVertices& vertices, FaceId face, std::vector<std::byte>& bytes) const;
    bool emitFace(const TexelStore& store, FaceId face, DisplayUpdate& update);

    std::shared_ptr<const FilterMesh> m_mesh;
    DisplayFormat m_format = DisplayFormat::Rgba8;
    CardChannels m_channels{0, 1, 2, -1};
    int m_dropAsked = 0;
    int m_drop = 0;
    std::uint64_t m_maxVertices = 0;
    std::uint32_t m_capacity = 0;
    std::uint32_t m_used = 0;
    bool m_fresh = false;
    std::vector<FaceRecord> m_records;
    std::vector<Level> m_levels; ///< of the store's faces when they were placed
    std::size_t m_nextFace = 0;  ///< faces from here on have not been sent yet
    std::optional<ChainCache> m_chains;
    std::vector<std::unique_ptr<ChainCache>> m_spareChains; ///< of threads that fill pending faces
    std::vector<TouchedRect> m_touched;                     ///< of faces that keep their places
    std::unordered_set<std::uint32_t> m_whole;              ///< faces to be sent as a whole
};

} // namespace trixel::render
