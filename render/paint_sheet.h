// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/paint/project_picture.h"
#include "render/gl.h"
#include "render/paint_batch.h"
#include "render/program.h"
#include "render/texture_buffer.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace trixel::render {

/// A texture that can be drawn into.
class PaintTarget
{
public:
    explicit PaintTarget(Gl& gl);
    ~PaintTarget();
    PaintTarget(const PaintTarget&) = delete;
    PaintTarget& operator=(const PaintTarget&) = delete;

    /// Room for so many rows of `PaintSquares::kWidth`; what was there is lost. False where the
    /// card has no room or cannot draw into such a texture.
    bool allocate(GLenum format, std::uint32_t rows);

    GLuint texture() const { return m_texture; }
    GLuint framebuffer() const { return m_framebuffer; }

private:
    Gl& m_gl;
    GLuint m_texture = 0;
    GLuint m_framebuffer = 0;
};

/// How far a stroke covers each texel, on the card: both halves of each face rasterised into the
/// face's square, exactly the texels whose centroids they hold. It keeps coverage alone, in single
/// precision: what texels were before lies on the card already, and what a stroke makes of them is
/// a mix of the two that is made when they are looked at.
///
/// Coverage after a dab depends on coverage before it (`covered`), which no blending of OpenGL 4.1
/// can say for caps that vary. So dabs are drawn into a second texture from the first and what was
/// drawn is copied back; up to 32 dabs at a time cost one such round.
///
/// Everything needs the context it was made in to be current; the framebuffer, viewport and vertex
/// array that were bound stay so.
class PaintSheet
{
public:
    /// Fails where the card cannot draw such coverage. \param coverage  its format
    static Result<std::unique_ptr<PaintSheet>> create(Gl& gl, GLenum coverage = GL_R32F);
    ~PaintSheet();

    /// How dabs fall off, and what each adds.
    struct Strength
    {
        float hardness = 0.5F; ///< [0,1]
        float flow = 1.0F;     ///< [0,1]
    };

    /// Most rows that `reserve` can be asked for.
    std::uint32_t mostRows() const { return m_mostRows; }
    /// Takes at most so many bytes from now on, but not less than at first (`kFewestBytes`).
    void setMost(std::uint64_t bytes);
    /// Bytes on the card of a row, once pictures are thrown, too.
    static constexpr std::uint64_t kRowBytes = std::uint64_t{PaintSquares::kWidth} * (4 + 4 + 8);
    static constexpr std::uint32_t kFewestRows = 512;
    static constexpr std::uint64_t kFewestBytes = kFewestRows * kRowBytes;
    /// Makes room for so many rows and keeps what is there; false where there is none.
    bool reserve(std::uint32_t rows);
    /// Draws dabs over the squares of a batch, which lie in rows reserved.
    void draw(const PaintBatch& batch, const Strength& strength);
    /// Draws what of a picture lands on the texels of a batch's squares, its dabs aside: colours
    /// and how far they cover, in a texture of its own with squares at the same places. False where
    /// the card is not able to.
    bool drawPicture(const PaintBatch& batch, const PictureProjection& picture);
    /// Gives up all memory but a little.
    void shrink();

    /// Makes coverage readable at a texture unit.
    void bind(GLuint unit);
    /// The same of what `drawPicture` drew.
    void bindPicture(GLuint unit);
    /// Coverage of a square's texels in packed order, for tests: it waits for the card.
    std::vector<float> read(const PaintSquare& square);
    /// Red, green, blue and coverage a texel of what `drawPicture` drew.
    std::vector<float> readPicture(const PaintSquare& square);
    /// Bytes on the card.
    std::uint64_t bytes() const;

private:
    using Program = std::unique_ptr<QOpenGLShaderProgram>;

    PaintSheet(Gl& gl, GLenum coverage, Program dabs, Program copy);
    /// Calls `work` with all set to draw a batch.
    void withBatch(const PaintBatch& batch, const std::function<void()>& work);
    std::vector<float> read(const PaintTarget& target, const PaintSquare& square, GLenum format);
    void drawInto(const PaintTarget& target,
                  GLuint from,
                  QOpenGLShaderProgram& program,
                  std::size_t entries);

    Gl& m_gl;
    GLenum m_coverage;
    Program m_dabsProgram;
    Program m_copyProgram;
    std::unique_ptr<PaintTarget> m_sheet;
    PaintTarget m_scratch;
    Program m_pictureProgram; ///< none before it was asked for, as are:
    std::unique_ptr<PaintTarget> m_pictures;
    std::uint32_t m_pictureRows = 0;
    TextureBuffer m_entries;
    TextureBuffer m_dabs;
    GLuint m_vertexArray = 0;
    std::uint32_t m_rows = 0;
    std::uint32_t m_ableRows = 0; ///< of the card
    std::uint32_t m_mostRows = 0; ///< of these, by `setMost`
};

} // namespace trixel::render
