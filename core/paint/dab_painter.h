// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/paint/dab_raster.h"
#include "core/paint/limit_texels.h"
#include "core/paint/stroke.h"
#include "core/paint/stroke_buffer.h"
#include "core/paint/texel_blend.h"

#include <deque>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace trixel {

/// Paints the dabs of one stroke into a store, and remembers what the stroke has covered and what
/// was there before.
///
/// A dab goes through three steps. Coverage grows, in parallel over rows of tiles; then the faces
/// that really change are made writable, one after the other; then the texels are blended, in
/// parallel again. A constant face is spread out only once a texel of it takes another value.
class DabPainter
{
public:
    /// \param blend  what the stroke makes of texels, as `strokeBlend` gives it
    DabPainter(TexelBlend blend,
               float hardness,
               float flow,
               Threads threads,
               std::optional<LimitTexels> limit = {});
    /// Texels that move towards a value.
    DabPainter(const TexelFormat& format,
               std::span<const float> value,
               float hardness,
               float flow,
               Threads threads,
               std::optional<LimitTexels> limit = {});

    /// \param faces  faces to paint, each once
    void paint(const Dab& dab,
               const TriangleMesh& mesh,
               std::span<const FaceId> faces,
               TexelStore& store);

    /// What changed since the last call, each face once, in ascending order. Of a face that was
    /// constant (`wholeFace`) the rectangle is what was painted.
    std::vector<TouchedRect> takeTouched();

    /// What all dabs changed; the painter begins anew.
    TexelPatch finish(const TexelStore& store);

private:
    /// Texels that follow each other both in a tile and in their face, some of which are newly
    /// covered. Others may be among them: blending those once more leaves them as they are.
    struct Segment
    {
        const StrokeTile* tile = nullptr;
        std::uint32_t firstOfTile = 0;
        std::uint32_t firstOfFace = 0;
        std::uint32_t count = 0;
    };

    /// One row of tiles of one face under the dab: a piece of work for one thread.
    struct Piece
    {
        StrokeFace* face = nullptr;
        const FaceTexels* now = nullptr;
        std::span<std::byte> texels;      ///< all of the face, once it is writable
        LimitFaceTexels* limit = nullptr; ///< where the texels lie, if not on the cage
        HalfRaster lower;
        HalfRaster upper;
        RowRange lowerRows;
        RowRange upperRows;
        std::uint32_t tileY = 0;
        std::vector<Segment> segments;
        TouchedRect touched;  ///< around the texels newly covered
        bool changes = false; ///< some texel takes another value than before the stroke
    };

    StrokeFace& strokeFace(FaceId face, const TexelStore& store);
    void addPieces(FaceId face, const Dab& dab, const TriangleMesh& mesh, const TexelStore& store);
    Piece& nextPiece();
    void addLimitPieces(FaceId face, const Dab& dab, const TexelStore& store);
    double expectedTexels(const Piece& piece, const Dab& dab) const;
    void cover(Piece& piece, const Dab& dab) const;
    void coverLimit(Piece& piece, const Dab& dab) const;
    void coverTile(Piece& piece,
                   std::uint32_t tileX,
                   std::span<const LimitTexel> texels,
                   const Dab& dab) const;
    void coverRow(Piece& piece, const HalfRaster& half, std::uint32_t row, const Dab& dab) const;
    static void note(Piece& piece,
                     const StrokeTile& tile,
                     std::uint32_t x,
                     std::uint32_t row,
                     std::uint32_t count);
    bool changesAnything(const Piece& piece) const;
    void blend(const Piece& piece) const;
    template <class Work>
    void forEachRun(const Piece& piece, Work&& work) const;
    void makeWritable(TexelStore& store);
    void touch(const Piece& piece, bool isSpreadNow);
    Threads threadsFor(double texels) const;

    TexelBlend m_blend;
    Falloff m_falloff;
    float m_flow;
    Threads m_threads;
    std::optional<LimitTexels> m_limit; ///< where texels lie, if not on the cage

    std::deque<StrokeFace> m_faces;                           ///< in the order they were reached
    std::unordered_map<std::uint32_t, std::size_t> m_placeOf; ///< of a face in m_faces
    std::vector<Piece> m_pieces;                              ///< kept for their memory
    std::size_t m_pieceCount = 0;
    std::vector<StrokeFace*> m_touched; ///< faces whose `touched` is not empty
};

} // namespace trixel
