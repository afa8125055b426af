// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/mesh/triangle_mesh.h"
#include "render/camera.h"
#include "render/corner_buffers.h"
#include "render/filter_mesh.h"
#include "render/filtering.h"
#include "render/gl.h"
#include "render/limit_buffers.h"
#include "render/look.h"
#include "render/paint_preview.h"
#include "render/program.h"
#include "render/surface_atlas.h"
#include "render/surface_texels.h"
#include "render/texture_buffer.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>

namespace trixel::render {

/// How the surface is drawn.
struct SurfaceStyle
{
    bool lit = true;
    bool wireframe = false;
    bool texelGrid = false;
    bool hasAlpha = false;    ///< texels lie over a checker
    bool faceColors = false;  ///< each face in its one colour, in place of its texels
    bool limit = false;       ///< as the limit surface's tessellation, where there is one
    bool pixelLevels = false; ///< levels found a pixel even where faces are small, for tests
    Filtering filtering = Filtering::Texels;
    float levelCut = 0;      ///< by which filtering over vertices shows all coarser than it would
    int levelsDropped = 0;   ///< by which filtering over vertices takes texels to be coarser
    float pixelRatio = 1.0F; ///< device pixels of one line width
};

/// How the texels on the card are looked at.
struct CardLook
{
    LookRule rule;
    int component = 0; ///< of the four on the card, where the rule's number is one channel
    CardChannels channels{0, 1, 2, -1}; ///< that the four on the card hold
};

/// Draws a mesh with texels, in one call. Memory on the card: 12 bytes a mesh vertex and 12 a face,
/// what `CornerBuffers` takes (about 24 a face where it is smooth), and what `SurfaceTexels` takes.
class SurfacePass
{
public:
    static Result<std::unique_ptr<SurfacePass>> create(Gl& gl);

    /// Fails where the mesh is larger than texture buffers may be here. Corners are forgotten.
    Status setMesh(const TriangleMesh& mesh);
    /// Of the mesh (checked), with its normals; until they come faces look flat and take longer.
    void setCorners(const SharedCorners& corners);

    /// What `SurfaceStyle::faceColors` shows: R G B A a face, or three a face, one at each corner
    /// and blended between them (checked); or nothing.
    void setFaceColors(std::span<const std::uint32_t> colors);

    /// What ways of filtering over vertices read of the mesh (checked to be of it), or nothing.
    void setFilterMesh(std::shared_ptr<const FilterMesh> mesh);

    /// What `SurfaceStyle::limit` shows, of the mesh; forgotten with it.
    LimitBuffers& limit() { return m_limit; }

    /// \param texels   of the mesh, or vertices where the style filters over these; nothing is
    /// drawn
    ///                 while they are empty
    /// \param preview  of a stroke that they do not hold yet, if any
    /// \param atlas    of the mesh, where the style filters in it; `texels` are not read then
    void draw(const Camera& camera,
              const SurfaceStyle& style,
              SurfaceTexels& texels,
              const CardLook& look,
              PaintPreview* preview = nullptr,
              SurfaceAtlas* atlas = nullptr,
              SurfaceTexels* own = nullptr);

    /// Compiles the programs of every style, for tests; otherwise each waits for its first use.
    Status makeAllPrograms();

private:
    static constexpr std::size_t kVariants = 5 * 320; ///< of each `Filtering`
    using Program = std::unique_ptr<QOpenGLShaderProgram>;

    explicit SurfacePass(Gl& gl);
    /// What is drawn of the mesh.
    enum class Drawn {
        Faces,      ///< of the cage
        SmallFaces, ///< the same, none of them more than a few pixels wide
        Limit,      ///< pieces of its limit surface
    };
    Drawn drawnOf(const Camera& camera, const SurfaceStyle& style) const;
    Status makeProgram(std::size_t variant, Drawn drawn);
    void setFilter(QOpenGLShaderProgram& program, const Camera& camera, const SurfaceStyle& style);
    static void setLook(QOpenGLShaderProgram& program, const CardLook& look);

    Gl& m_gl;
    /// One a way of drawing, made when first used, by `Drawn`.
    std::array<std::array<Program, kVariants>, 3> m_programs;
    LimitBuffers m_limit;
    CornerBuffers m_corners;
    TextureBuffer m_positions;
    TextureBuffer m_triangles;
    TextureBuffer m_faceColors;
    int m_colorsPerFace = 1; ///< or 3
    TextureBuffer m_scale;   ///< the colours of `mapColor`
    TextureBuffer m_scales;  ///< of `VertexScale`
    TextureBuffer m_across;  ///< sent when it is first needed
    std::shared_ptr<const FilterMesh> m_filterMesh;
    std::size_t m_vertexCount = 0;
    std::size_t m_faceCount = 0;
};

} // namespace trixel::render
