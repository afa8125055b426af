// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/triangle_mesh.h"
#include "core/paint/stroke_dabs.h"
#include "core/texture/texel_store.h"
#include "render/display_conversion.h"
#include "render/paint_sheet.h"
#include "render/paint_speed.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace trixel::render {

/// What a stroke makes of texels before the store has it: squares of coverage for the faces under
/// it, which the surface's shader mixes with the texels on the card. Those must stay as they were
/// before the stroke for as long as their face has a square.
///
/// A face that finds no room in the sheet is left out: it shows the stroke when the store has it.
class PaintPreview
{
public:
    /// Fails where the card cannot draw coverage.
    static Result<std::unique_ptr<PaintPreview>> create(Gl& gl, GLenum coverage = GL_R32F);

    /// What a stroke does, wherever it goes.
    struct Paint
    {
        std::vector<float> target; ///< that it moves texels towards, a number per channel
        PaintSheet::Strength strength;
        bool isUnit = true; ///< texels cannot leave [0,1]: they are integers
    };

    /// Begins a stroke over a mesh of so many faces; the one before is given up.
    void begin(std::size_t faceCount, const Paint& paint);
    /// Draws dabs of the stroke. \param store  of the mesh's faces: it says their levels
    void add(const TriangleMesh& mesh, const TexelStore& store, std::span<const PlacedDab> dabs);
    /// Covers whole faces. All of them share a square of one texel.
    void fill(std::span<const FaceId> faces);

    /// Throws a picture onto faces, in place of dabs. Not all of it may find room.
    void project(const TriangleMesh& mesh,
                 const TexelStore& store,
                 std::span<const FaceId> faces,
                 const PictureProjection& picture);

    /// Whether some face has a square.
    bool isShown() const { return m_shown > 0; }
    bool hasSquare(FaceId face) const
    {
        return indexOf(face) < m_words.size() && m_words[indexOf(face)] != 0;
    }
    /// Faces given back: they show what lies on the card.
    void release(std::span<const FaceId> faces);
    /// Gives up all of it.
    void end();

    /// Makes all of it known to a program of the surface.
    /// \param squares, coverage  texture units to take
    void use(QOpenGLShaderProgram& program,
             const CardChannels& channels,
             GLuint squares,
             GLuint coverage);

    /// What card and processor take for a texel; see there. Nothing may be shown (checked).
    PaintSpeed measureSpeed(const TexelFormat& format, Threads threads);

    /// Bytes on the card.
    std::uint64_t bytes() const
    {
        return m_sheet->bytes() + m_cardWords.size() * sizeof(std::uint32_t);
    }
    PaintSheet& sheet() { return *m_sheet; }
    /// The word of a face's square; see `PaintSquare`.
    std::uint32_t word(FaceId face) const { return m_words[indexOf(face)]; }

private:
    PaintPreview(Gl& gl, std::unique_ptr<PaintSheet> sheet);
    bool giveSquare(FaceId face, Level level);
    void
    addBatch(const TriangleMesh& mesh, const TexelStore& store, std::span<const PlacedDab> dabs);
    void sendWords(std::vector<std::uint32_t> faces);

    Gl& m_gl;
    std::unique_ptr<PaintSheet> m_sheet;
    PaintSquares m_squares;
    TextureBuffer m_cardWords;
    Paint m_paint;
    bool m_isPicture = false;           ///< the sheet's pictures are shown instead of coverage
    std::vector<std::uint32_t> m_words; ///< by face
    std::vector<std::uint32_t> m_masks; ///< by face: the dabs of a batch; zero between batches
    std::size_t m_shown = 0;
};

} // namespace trixel::render
