// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/renderer.h"

#include "core/base/check.h"

#include <algorithm>
#include <limits>

namespace trixel::render {

Result<std::unique_ptr<Renderer>> Renderer::create()
{
    std::unique_ptr<Gl> gl = currentGl();
    if (!gl) {
        return contentsError("OpenGL 4.1 is not available.");
    }
    auto background =
        loadProgram(QStringLiteral("background.vert"), QStringLiteral("background.frag"));
    if (!background) {
        return tl::unexpected(background.error());
    }
    auto surface = SurfacePass::create(*gl);
    if (!surface) {
        return tl::unexpected(surface.error());
    }
    auto picture = PicturePass::create(*gl);
    if (!picture) {
        return tl::unexpected(picture.error());
    }
    auto overlay = OverlayPass::create(*gl);
    if (!overlay) {
        return tl::unexpected(overlay.error());
    }
    return std::unique_ptr<Renderer>(new Renderer(std::move(gl),
                                                  std::move(*background),
                                                  std::move(*surface),
                                                  std::move(*picture),
                                                  std::move(*overlay)));
}

Renderer::Renderer(std::unique_ptr<Gl> gl,
                   std::unique_ptr<QOpenGLShaderProgram> background,
                   std::unique_ptr<SurfacePass> surface,
                   std::unique_ptr<PicturePass> picture,
                   std::unique_ptr<OverlayPass> overlay)
    : m_gl(std::move(gl))
    , m_background(std::move(background))
    , m_surface(std::move(surface))
    , m_picture(std::move(picture))
    , m_overlay(std::move(overlay))
{
    m_gl->glGenVertexArrays(1, &m_vertexArray);
}

Renderer::~Renderer()
{
    m_gl->glDeleteVertexArrays(1, &m_vertexArray);
}

Status Renderer::setMesh(const TriangleMesh& mesh)
{
    clear();
    Status status = m_surface->setMesh(mesh);
    m_faceCount = status ? mesh.faceCount() : 0;
    return status;
}

void Renderer::clear()
{
    m_faceCount = 0;
    m_texels = {};
    (void)m_surface->setMesh({}); // an empty mesh always fits
}

void Renderer::setTexels(const TexelStore& store, int mipDrop)
{
    check(store.faceCount() == m_faceCount, "texels of this mesh");
    const std::size_t most = std::min<std::size_t>(TextureBuffer::maxElements(*m_gl),
                                                   std::numeric_limits<std::int32_t>::max());
    m_texels.reset(store, mipDrop, static_cast<std::uint32_t>(most));
    m_format = store.format();
    applyLook();
}

void Renderer::setLook(const Look& look)
{
    m_look = look;
    applyLook();
}

void Renderer::applyLook()
{
    m_cardLook.rule = LookRule::of(m_format, m_look);
    const CardChannels channels = channelsFor(m_format, m_cardLook.rule);
    m_texels.showChannels(channels);
    const auto number = std::ranges::find(channels, m_cardLook.rule.number);
    m_cardLook.component =
        number == channels.end() ? 0 : static_cast<int>(number - channels.begin());
}

void Renderer::touchTexels(const TexelStore& store, std::span<const TouchedRect> rects)
{
    m_texels.touch(store, rects);
}

std::size_t Renderer::uploadTexels(const TexelStore& store, std::size_t byteBudget)
{
    if (!m_texels.hasWork()) {
        return 0;
    }
    const DisplayUpdate update = m_texels.take(store, byteBudget);
    m_surface->upload(update, m_texels.records(), m_texels.format());
    return update.bytes.size();
}

void Renderer::drawBackground()
{
    m_gl->glDisable(GL_DEPTH_TEST);
    m_gl->glDisable(GL_BLEND);
    m_background->bind();
    m_gl->glDrawArrays(GL_TRIANGLES, 0, 3);
    m_background->release();
}

void Renderer::draw(const Scene& scene)
{
    const glm::ivec2 size = scene.camera.viewport();
    m_gl->glViewport(0, 0, size.x, size.y);
    m_gl->glDepthMask(GL_TRUE);
    m_gl->glClear(GL_DEPTH_BUFFER_BIT);
    m_gl->glBindVertexArray(m_vertexArray);
    drawBackground();
    m_surface->draw(scene.camera, scene.surface, m_cardLook);
    m_gl->glBindVertexArray(m_vertexArray);
    m_picture->draw();
    m_gl->glBindVertexArray(0);
    m_overlay->draw(scene.camera, scene.overlays, scene.surface.pixelRatio);
}

} // namespace trixel::render
