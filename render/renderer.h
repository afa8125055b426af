// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "render/camera.h"
#include "render/display_vertices.h"
#include "render/filter_layer.h"
#include "render/frame_figures.h"
#include "render/frame_timer.h"
#include "render/overlay_pass.h"
#include "render/picture_pass.h"
#include "render/split.h"
#include "render/surface_pass.h"
#include "render/surface_texels.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace trixel::render {

/// Everything that one picture shows.
struct Scene
{
    Camera camera;
    SurfaceStyle surface;
    std::vector<Polyline> overlays;
    std::optional<Split> split;
};

/// Owns all OpenGL objects. Made, used and destroyed with one context current. Holds nothing that
/// cannot be made again from the mesh and the texel store: when a context is lost, destroy it, with
/// any context current or none, and make another.
class Renderer
{
public:
    /// Fails when the current context is older than 4.1 core or a shader does not compile.
    static Result<std::unique_ptr<Renderer>> create();
    ~Renderer();

    /// The mesh to draw; texels of the one before are forgotten.
    Status setMesh(const TriangleMesh& mesh);
    /// See `SurfacePass::setCorners`.
    void setCorners(const SharedCorners& corners) { m_surface->setCorners(corners); }
    /// See `SurfacePass::setFaceColors`.
    void setFaceColors(std::span<const std::uint32_t> colors) { m_surface->setFaceColors(colors); }
    /// The limit surface that `SurfaceStyle::limit` shows; sent by `LimitBuffers::send`.
    LimitBuffers& limit() { return m_surface->limit(); }
    /// No mesh at all.
    void clear();

    /// Shows a store of the mesh's faces from the beginning. Side B has texels of its own only
    /// where `Split` says so.
    void setTexels(const TexelStore& store, int mipDrop, Side side = Side::A);
    /// Most bytes on the card of texels, of what is made of them for ways of filtering, and of
    /// strokes shown over them, both sides together; 512 MiB unless told otherwise. What shows each
    /// face at all is there even where that is more.
    void setCardBudget(std::uint64_t bytes);
    std::uint64_t cardBudget() const { return m_cardBudget; }
    /// What is on the card of a side, to be planned for and worked on.
    DisplayTexels& display(Side side) { return layer(side).display; }
    /// The same of what ways of filtering over vertices show, which begins with the store when it
    /// is first asked for. \return  null where none is wanted (`wantFilterings`), or could be
    DisplayVertices* vertices(const TexelStore& store, Side side);
    /// Sends what is ready; see `DisplayBlocks::takeReady`. \return bytes of texels sent
    std::size_t sendReady(const TexelStore& store, std::size_t mostRead, Side side = Side::A);
    /// The same of vertices.
    std::size_t sendReadyVertices(const TexelStore& store, std::size_t mostRead, Side side);
    /// Gives up what B shows.
    void clearOtherTexels();
    void
    touchTexels(const TexelStore& store, std::span<const TouchedRect> rects, Side side = Side::A);
    /// Every texel may have changed; what is shown stays until it is replaced.
    void touchAllTexels(Side side = Side::A);
    /// Sends touched texels and, up to a budget of bytes, texels that have not been sent yet.
    /// \return bytes of texels sent
    std::size_t uploadTexels(const TexelStore& store, std::size_t byteBudget, Side side = Side::A);
    const DisplayTexels& texels(Side side = Side::A) const
    {
        return m_layers[static_cast<std::size_t>(side)].display;
    }

    /// What filtering over vertices and in the packed atlas needs; until then such ways of
    /// filtering show texels. To be set again when faces get other levels.
    void setFilterMesh(std::shared_ptr<const FilterMesh> mesh);
    /// The ways of filtering that frames to come show. What others need is given up.
    void wantFilterings(std::span<const Filtering> filterings);
    /// Makes and sends up to a budget of bytes of what they need beside texels; the atlas is made
    /// in the background. \return bytes sent
    std::size_t uploadFilters(const TexelStore& store, std::size_t byteBudget, Side side = Side::A);
    /// Whether `uploadFilters` will have something to send, now or later.
    bool hasFilterWork(Side side = Side::A) const;
    /// The same of the atlas alone, where vertices are streamed.
    std::size_t uploadAtlas(const TexelStore& store, std::size_t byteBudget, Side side = Side::A);
    bool hasAtlasWork(Side side = Side::A) const;
    /// Whether there turned out to be no memory for an atlas, since this was asked last.
    bool takeAtlasFailure();
    /// Whether a way of filtering is shown: of the atlas all of it, of others something of every
    /// face is on the card. Until then texels are.
    bool isFilterReady(Filtering filtering, Side side = Side::A) const;

    /// How texels are looked at from now on. A channel that is not on the card is sent over the
    /// frames to come; see `uploadTexels`.
    void setLook(const Look& look);

    /// What a stroke in progress makes of side A's texels, shown over them; made at the first call.
    /// Fails where the card cannot draw it, or its part of the budget is too small for it.
    Result<PaintPreview*> preview();
    /// The same if it has been made; else null.
    PaintPreview* shownPreview() { return m_preview.get(); }
    /// What the preview draws from now on, for tests: a format that the card may not be able to.
    void setCoverageFormat(GLenum format)
    {
        m_preview.reset();
        m_coverageFormat = format;
    }

    /// A picture laid over the surface and under the lines; see `PicturePass`.
    PicturePass& picture(Side side = Side::A)
    {
        return *m_pictures[static_cast<std::size_t>(side)];
    }

    /// Compiles every program at once instead of when it is first used; for tests.
    Status makeAllPrograms() { return m_surface->makeAllPrograms(); }

    /// Draws into the framebuffer that is bound, over all of it.
    void draw(const Scene& scene);

    /// Of the latest frame; the caller knows the processor's time.
    const FrameFigures& figures() const { return m_figures; }

private:
    Renderer(std::unique_ptr<Gl> gl,
             std::unique_ptr<QOpenGLShaderProgram> background,
             std::unique_ptr<SurfacePass> surface,
             std::array<std::unique_ptr<PicturePass>, 2> pictures,
             std::unique_ptr<OverlayPass> overlay);

    /// The texels of one side.
    struct Layer
    {
        explicit Layer(Gl& gl)
            : card(gl)
            , vertexCard(gl)
            , atlas(gl)
        {
        }

        DisplayTexels display;
        SurfaceTexels card;
        DisplayVertices vertices;
        SurfaceTexels vertexCard;
        AtlasForm atlas;
        int mipDrop = 0;
        bool hasVertices = false; ///< begun
    };
    bool wants(FilterSource source) const { return m_wanted[static_cast<std::size_t>(source)]; }
    Layer& layer(Side side) { return m_layers[static_cast<std::size_t>(side)]; }
    void drawFrame(const Scene& scene);
    void drawBackground();
    void drawSide(const Scene& scene, Filtering filtering, Side texels, Side picture);
    void applyLook();
    std::uint32_t mostTexels(std::size_t bytesEach) const;
    std::uint64_t previewShare() const;
    void shareBudget();
    void forgetDisplay(Layer& layer);
    std::uint64_t residentBytes() const;
    void clearVertices(Layer& layer);
    void clearFilters(Layer& layer);

    std::unique_ptr<Gl> m_gl;
    std::unique_ptr<QOpenGLShaderProgram> m_background;
    std::unique_ptr<SurfacePass> m_surface;
    std::array<std::unique_ptr<PicturePass>, 2> m_pictures;
    std::unique_ptr<OverlayPass> m_overlay;
    GLuint m_vertexArray = 0; ///< of no attributes: core profile draws with none bound are errors
    std::array<Layer, 2> m_layers;
    std::unique_ptr<PaintPreview> m_preview; ///< none before it was asked for
    GLenum m_coverageFormat = GL_R32F;
    TexelFormat m_format;
    Look m_look;
    CardLook m_cardLook;
    std::size_t m_faceCount = 0;
    std::uint64_t m_cardBudget = std::uint64_t{512} << 20U;
    bool m_hasOtherTexels = false;
    std::shared_ptr<const FilterMesh> m_filterMesh;
    std::array<bool, 3> m_wanted{}; ///< by `FilterSource`
    std::uint32_t m_displays = 0;   ///< made so far
    FrameTimer m_timer;
    FrameFigures m_figures;
};

} // namespace trixel::render
