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
    std::array<std::unique_ptr<PicturePass>, 2> pictures;
    for (std::unique_ptr<PicturePass>& picture : pictures) {
        auto made = PicturePass::create(*gl);
        if (!made) {
            return tl::unexpected(made.error());
        }
        picture = std::move(*made);
    }
    auto overlay = OverlayPass::create(*gl);
    if (!overlay) {
        return tl::unexpected(overlay.error());
    }
    return std::unique_ptr<Renderer>(new Renderer(std::move(gl),
                                                  std::move(*background),
                                                  std::move(*surface),
                                                  std::move(pictures),
                                                  std::move(*overlay)));
}

Renderer::Renderer(std::unique_ptr<Gl> gl,
                   std::unique_ptr<QOpenGLShaderProgram> background,
                   std::unique_ptr<SurfacePass> surface,
                   std::array<std::unique_ptr<PicturePass>, 2> pictures,
                   std::unique_ptr<OverlayPass> overlay)
    : m_gl(std::move(gl))
    , m_background(std::move(background))
    , m_surface(std::move(surface))
    , m_pictures(std::move(pictures))
    , m_overlay(std::move(overlay))
    , m_layers{Layer(*m_gl), Layer(*m_gl)}
    , m_timer(*m_gl)
{
    m_gl->glGenVertexArrays(1, &m_vertexArray);
}

Renderer::~Renderer()
{
    if (m_gl->isCurrent()) {
        m_gl->glDeleteVertexArrays(1, &m_vertexArray);
    }
}

Status Renderer::setMesh(const TriangleMesh& mesh)
{
    clear();
    Status status = m_surface->setMesh(mesh);
    m_faceCount = status ? mesh.faceCount() : 0;
    for (Layer& layer : m_layers) {
        layer.card.clear();
    }
    return status;
}

void Renderer::clear()
{
    m_faceCount = 0;
    m_preview.reset();
    m_hasOtherTexels = false;
    m_filterMesh.reset();
    for (Layer& layer : m_layers) {
        forgetDisplay(layer);
        layer.card.clear();
        clearFilters(layer);
    }
    (void)m_surface->setMesh({}); // an empty mesh always fits
}

void Renderer::setTexels(const TexelStore& store, int mipDrop, Side side)
{
    check(store.faceCount() == m_faceCount, "texels of this mesh");
    m_hasOtherTexels = m_hasOtherTexels || side == Side::B;
    layer(side).display.reset(
        store, mipDrop, mostTexels(texelBytes(displayFormat(store.format().type))));
    m_format = store.format();
    layer(side).mipDrop = mipDrop;
    clearFilters(layer(side));
    applyLook();
    shareBudget();
}

void Renderer::forgetDisplay(Layer& layer)
{
    layer.display = DisplayTexels(++m_displays << 16U);
}

void Renderer::setCardBudget(std::uint64_t bytes)
{
    m_cardBudget = bytes;
    shareBudget();
    if (m_preview && previewShare() > 0) {
        m_preview->sheet().setMost(previewShare());
    }
}

/// Set aside for strokes shown over texels, whether there is one or not: texels would have to be
/// sent anew for the first. None where that would leave texels little.
std::uint64_t Renderer::previewShare() const
{
    constexpr std::uint64_t kLeast = PaintSheet::kFewestBytes;
    const std::uint64_t words = m_faceCount * sizeof(std::uint32_t);
    return m_cardBudget / 2 < kLeast + words ? 0 : std::max(m_cardBudget / 8, kLeast);
}

/// Of one side's texels, or of one other form of them.
std::uint32_t Renderer::mostTexels(std::size_t bytesEach) const
{
    const std::uint64_t forms =
        1U + (wants(FilterSource::Vertices) ? 1U : 0U) + (wants(FilterSource::Atlas) ? 1U : 0U);
    const std::uint64_t words =
        previewShare() > 0 ? m_faceCount * sizeof(std::uint32_t) : std::uint64_t{0};
    const std::uint64_t share =
        (m_cardBudget - previewShare() - words) / (forms * (m_hasOtherTexels ? 2U : 1U));
    const std::uint64_t records = m_faceCount * sizeof(FaceRecord);
    const std::uint64_t bytes = share > records ? share - records : 0;
    return static_cast<std::uint32_t>(
        std::min<std::uint64_t>({bytes / bytesEach,
                                 TextureBuffer::maxElements(*m_gl),
                                 std::numeric_limits<std::int32_t>::max()}));
}

void Renderer::shareBudget()
{
    for (Layer& layer : m_layers) {
        layer.display.setMost(mostTexels(texelBytes(layer.display.format())));
        if (layer.hasVertices) {
            layer.vertices.setMost(mostTexels(texelBytes(layer.vertices.format())));
        }
        layer.atlas.setMost(mostTexels(1));
    }
}

void Renderer::clearOtherTexels()
{
    forgetDisplay(layer(Side::B));
    layer(Side::B).card.clear();
    m_hasOtherTexels = false;
    shareBudget();
    clearFilters(layer(Side::B));
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
    for (Layer& layer : m_layers) {
        layer.display.showChannels(channels);
        if (layer.hasVertices) {
            layer.vertices.showChannels(channels);
        }
        layer.atlas.showChannels(channels);
    }
    m_cardLook.channels = channels;
    const auto number = std::ranges::find(channels, m_cardLook.rule.number);
    m_cardLook.component =
        number == channels.end() ? 0 : static_cast<int>(number - channels.begin());
}

void Renderer::touchTexels(const TexelStore& store, std::span<const TouchedRect> rects, Side side)
{
    layer(side).display.touch(store, rects);
    if (layer(side).hasVertices) {
        layer(side).vertices.touch(store, rects);
    }
    layer(side).atlas.touch(store, rects);
}

void Renderer::touchAllTexels(Side side)
{
    layer(side).display.touchAll();
    if (layer(side).hasVertices) {
        layer(side).vertices.touchAll();
    }
    layer(side).atlas.touchAll();
}

namespace {

/// \return  bytes sent
std::size_t send(SurfaceTexels& card, const DisplayUpdate& update, const DisplayBlocks& display)
{
    card.upload(update, display.records(), display.format());
    return update.bytes.size();
}

} // namespace

std::size_t Renderer::uploadTexels(const TexelStore& store, std::size_t byteBudget, Side side)
{
    Layer& sent = layer(side);
    if (!sent.display.hasWork()) {
        return 0;
    }
    return send(sent.card, sent.display.take(store, byteBudget), sent.display);
}

std::size_t Renderer::sendReady(const TexelStore& store, std::size_t mostRead, Side side)
{
    Layer& sent = layer(side);
    return sent.display.hasReady()
               ? send(sent.card, sent.display.takeReady(store, mostRead), sent.display)
               : 0;
}

std::size_t Renderer::sendReadyVertices(const TexelStore& store, std::size_t mostRead, Side side)
{
    Layer& sent = layer(side);
    return sent.hasVertices && sent.vertices.hasReady()
               ? send(sent.vertexCard, sent.vertices.takeReady(store, mostRead), sent.vertices)
               : 0;
}

Result<PaintPreview*> Renderer::preview()
{
    if (previewShare() == 0) {
        return contentsError("Texels may take too little of the graphics card to show strokes on.");
    }
    if (!m_preview) {
        auto made = PaintPreview::create(*m_gl, m_coverageFormat);
        if (!made) {
            return tl::unexpected(made.error());
        }
        m_preview = std::move(*made);
        m_preview->sheet().setMost(previewShare());
    }
    return m_preview.get();
}

void Renderer::drawBackground()
{
    m_gl->glDisable(GL_DEPTH_TEST);
    m_gl->glDisable(GL_BLEND);
    m_background->bind();
    m_gl->glDrawArrays(GL_TRIANGLES, 0, 3);
    m_background->release();
}

void Renderer::drawSide(const Scene& scene, Filtering filtering, Side texels, Side picture)
{
    m_gl->glBindVertexArray(m_vertexArray);
    PaintPreview* preview = texels == Side::A ? m_preview.get() : nullptr;
    SurfaceStyle style = scene.surface;
    style.filtering = isFilterReady(filtering, texels) ? filtering : Filtering::Texels;
    const FilterSource source = sourceOf(style.filtering);
    Layer& shown = layer(texels);
    style.levelCut = source == FilterSource::Vertices ? shown.vertices.viewCut() : 0.0F;
    style.levelsDropped = shown.mipDrop;
    m_surface->draw(scene.camera,
                    style,
                    source == FilterSource::Vertices ? shown.vertexCard : shown.card,
                    m_cardLook,
                    preview,
                    source == FilterSource::Atlas ? &shown.atlas.card() : nullptr,
                    &shown.card);
    m_gl->glBindVertexArray(m_vertexArray);
    this->picture(picture).draw();
    m_gl->glBindVertexArray(0);
}

void Renderer::draw(const Scene& scene)
{
    m_timer.begin();
    drawFrame(scene);
    m_timer.end();
    const Layer& layer = m_layers[static_cast<std::size_t>(Side::A)];
    const bool showsVertices = sourceOf(scene.surface.filtering) == FilterSource::Vertices &&
                               isFilterReady(scene.surface.filtering);
    const DisplayBlocks& shown = showsVertices ? static_cast<const DisplayBlocks&>(layer.vertices)
                                               : static_cast<const DisplayBlocks&>(layer.display);
    m_figures = {};
    m_figures.cardMs = m_timer.milliseconds();
    m_figures.filtering = scene.surface.filtering;
    m_figures.levelsDropped = shown.levelsDropped();
    m_figures.faces = shown.facesInView().value_or(m_faceCount);
    m_figures.triangles = m_faceCount;
    if (const auto& limit = m_surface->limit().shown(); scene.surface.limit && limit) {
        m_figures.triangles = limit->triangles().size();
        m_figures.surfaceError = limit->error();
    }
    m_figures.texels = layer.display.texelsUsed();
    m_figures.budgetBytes = m_cardBudget;
    m_figures.residentBytes = residentBytes();
}

std::uint64_t Renderer::residentBytes() const
{
    std::uint64_t bytes = m_preview ? m_preview->bytes() : 0;
    for (const Layer& layer : m_layers) {
        bytes += layer.display.cardBytes() + layer.vertices.cardBytes() + layer.atlas.bytes();
    }
    return bytes;
}

void Renderer::drawFrame(const Scene& scene)
{
    const glm::ivec2 size = scene.camera.viewport();
    m_gl->glViewport(0, 0, size.x, size.y);
    m_gl->glDepthMask(GL_TRUE);
    m_gl->glClear(GL_DEPTH_BUFFER_BIT);
    m_gl->glBindVertexArray(m_vertexArray);
    drawBackground();
    const Filtering own = scene.surface.filtering;
    if (scene.split) {
        const Split& split = *scene.split;
        const int column = std::clamp(split.column, 0, size.x);
        m_gl->glEnable(GL_SCISSOR_TEST);
        m_gl->glScissor(0, 0, column, size.y);
        drawSide(scene, own, Side::A, Side::A);
        m_gl->glScissor(column, 0, size.x - column, size.y);
        drawSide(scene,
                 split.otherFiltering.value_or(own),
                 split.ownTexels ? Side::B : Side::A,
                 split.ownPicture ? Side::B : Side::A);
        m_gl->glDisable(GL_SCISSOR_TEST);
    } else {
        drawSide(scene, own, Side::A, Side::A);
    }
    m_overlay->draw(scene.camera, scene.overlays, scene.surface.pixelRatio);
}

} // namespace trixel::render
