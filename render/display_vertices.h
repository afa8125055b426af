// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which lattice vertices lie where on the graphics card and which have to be sent. Plain data, no
// OpenGL.
#pragma once

#include "core/texture/face_vertices.h"
#include "render/display_blocks.h"
#include "render/vertex_making.h"

#include <memory>
#include <optional>
#include <span>
#include <unordered_set>
#include <vector>

namespace trixel::render {

/// The conforming pyramid of a store on the graphics card, within a bound: for a face the vertices
/// of levels 0 to that of its block (`core/texture/vertex_block.h`), those of level 0 where the
/// face and all about it are one constant. The base of a face is its three vertices of level 0.
class DisplayVertices : public DisplayBlocks
{
public:
    /// \param generation  see `DisplayBlocks`
    explicit DisplayVertices(std::uint32_t generation = 0)
        : DisplayBlocks(BlockKind::Vertices, generation)
    {
    }

    /// Shows a store from now on, with its usual channels.
    /// \param mesh         of the store's faces (checked)
    /// \param mipDrop      show every face this many levels coarser (>= 0)
    /// \param maxVertices  most vertices the buffer can have; less is shown to fit, but for the
    /// bases
    void reset(std::shared_ptr<const FilterMesh> mesh,
               const TexelStore& store,
               int mipDrop,
               std::uint32_t maxVertices);

    void touch(const TexelStore& store, std::span<const TouchedRect> rects) override;

    Opener opener() const override;
    Maker maker() const override;
    std::uint32_t verticesUsed() const { return elementsUsed(); }

private:
    CardOpening openNow(const TexelStore& store) const override;
    void touched(FaceId face) override;
    void sendTouched(const TexelStore& store, std::size_t mostRead) override;

    /// What is to be done for touched faces.
    struct Work
    {
        std::vector<TouchedRect> parts;          ///< of faces that stay what they are
        std::unordered_set<std::uint32_t> whole; ///< faces that may be something else now
        std::unordered_set<std::uint32_t> later; ///< faces that take too long for a frame
    };
    Work takeTouched(const TexelStore& store, std::size_t mostRead);
    std::size_t costOf(const TexelStore& store, FaceId face) const;
    void sendWhole(const FaceVertices& vertices, FaceId face);
    void sendParts(const TexelStore& store, const FaceVertices& vertices, const Work& work);
    void sendLater(FaceId face);
    void append(const FaceVertices& vertices, FaceId face, Level level);
    ChainCache& chains();
    template <class Visit>
    void forFacesAbout(FaceId face, Visit visit) const;

    std::shared_ptr<const FilterMesh> m_mesh;
    std::optional<ChainCache> m_chains; ///< of faces that strokes touch
    std::uint32_t m_chainsOpening = 0;  ///< the need of an opening when they were begun
};

} // namespace trixel::render
