// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is laid over the surface: a computed picture, colours of faces, and a marked edge.
#include <QOpenGLFramebufferObject>
#include <QScopedValueRollback>

#include "core/base/check.h"
#include "core/lattice/edge_transfer.h"
#include "ui/viewport/viewport_private.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

namespace trixel::ui {

namespace {

constexpr glm::vec4 kEdgeColor{1.0F, 0.85F, 0.2F, 1.0F};
constexpr float kEdgeWidth = 3.0F;
/// That the edge is drawn in on a limit surface.
constexpr int kCurvePieces = 16;

glm::dvec3 unitNormal(const TriangleMesh& mesh, FaceId face)
{
    const auto corners = mesh.corners(face);
    const glm::dvec3 normal =
        glm::cross(glm::dvec3(corners[1] - corners[0]), glm::dvec3(corners[2] - corners[0]));
    const double length = glm::length(normal);
    return length > 0 && std::isfinite(length) ? normal / length : glm::dvec3(0);
}

} // namespace

void Viewport::setPictureRows(std::span<const std::uint32_t> pixels,
                              QSize size,
                              int firstRow,
                              render::Side side)
{
    PictureOver& picture = d->pictures[static_cast<std::size_t>(side)];
    const glm::ivec2 wanted(size.width(), size.height());
    if (picture.size != wanted) {
        picture.size = wanted;
        picture.pixels.assign(
            static_cast<std::size_t>(wanted.x) * static_cast<std::size_t>(wanted.y), 0);
        picture.isNew = true;
    }
    const auto begin = static_cast<std::size_t>(firstRow) * static_cast<std::size_t>(wanted.x);
    check(begin + pixels.size() <= picture.pixels.size(), "rows of the picture");
    std::ranges::copy(pixels, picture.pixels.begin() + static_cast<std::ptrdiff_t>(begin));
    const int endRow = firstRow + static_cast<int>(pixels.size()) / std::max(1, wanted.x);
    picture.firstTouched = std::min(picture.firstTouched, firstRow);
    picture.endTouched = std::max(picture.endTouched, endRow);
    d->redraw();
}

void Viewport::clearPicture(render::Side side)
{
    PictureOver& picture = d->pictures[static_cast<std::size_t>(side)];
    if (picture.size != glm::ivec2(0)) {
        picture = {};
        d->redraw();
    }
}

bool Viewport::hasPicture() const
{
    return d->pictures[0].size != glm::ivec2(0);
}

void Viewport::setFaceColors(std::vector<std::uint32_t> colors)
{
    const std::size_t faces = d->document.texels().faceCount();
    check(colors.empty() || colors.size() == faces || colors.size() == 3 * faces,
          "a colour a face, or one a corner");
    if (colors != d->faceColors) {
        d->faceColors = std::move(colors);
        d->faceColorsDirty = true;
        d->redraw();
    }
}

bool Viewport::hasFaceColors() const
{
    return !d->faceColors.empty();
}

void Viewport::showOtherTexels(std::optional<TexelStore> texels)
{
    check(!texels || texels->faceCount() == d->document.texels().faceCount(),
          "texels of the document's surface");
    d->setOtherTexels(std::move(texels));
    d->refreshHover();
}

bool Viewport::showsOtherTexels() const
{
    return d->otherTexels.has_value();
}

QImage Viewport::picture(double density)
{
    const QSize pixels = (QSizeF(size()) * density).toSize();
    const bool isAsShown = !canDraw() || hasPicture() || density == devicePixelRatioF();
    // What is streamed, how finely limits are cut and where a split runs go by the camera's pixels.
    const QScopedValueRollback itself(d->camera);
    if (!isAsShown) {
        d->camera.setViewport(pixels.width(), pixels.height());
    }
    settle();
    if (isAsShown) {
        return grabFramebuffer();
    }
    d->canvas->makeCurrent();
    QImage drawn;
    {
        QOpenGLFramebufferObjectFormat format;
        format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
        format.setSamples(d->canvas->format().samples());
        QOpenGLFramebufferObject target(pixels, format);
        if (target.isValid() && target.bind()) {
            render::Scene scene = d->scene();
            scene.surface.pixelRatio = static_cast<float>(density);
            d->renderer->draw(scene);
            target.release();
            drawn = target.toImage().convertToFormat(QImage::Format_RGB32);
        }
    }
    d->canvas->doneCurrent();
    return drawn.isNull() ? grabFramebuffer() : drawn; // larger than the card can
}

/// Rows that are not on the card yet; the context is current.
void Viewport::Private::sendPicture(render::Side side)
{
    PictureOver& picture = pictures[static_cast<std::size_t>(side)];
    render::PicturePass& shown = renderer->picture(side);
    if (picture.size == glm::ivec2(0)) {
        shown.clear();
        return;
    }
    if (picture.isNew || shown.isEmpty()) {
        shown.set(picture.pixels, picture.size);
    } else if (picture.firstTouched < picture.endTouched) {
        const auto width = static_cast<std::size_t>(picture.size.x);
        const auto first = static_cast<std::size_t>(picture.firstTouched);
        const auto rows = static_cast<std::size_t>(picture.endTouched - picture.firstTouched);
        shown.setRows(std::span(picture.pixels).subspan(first * width, rows * width),
                      picture.firstTouched);
    }
    picture.isNew = false;
    picture.firstTouched = picture.size.y;
    picture.endTouched = 0;
}

/// The context is current.
void Viewport::Private::sendFaceColors()
{
    if (!shownSurface) {
        return; // a mesh that the card could not take has no faces to colour
    }
    if (std::exchange(faceColorsDirty, false)) {
        renderer->setFaceColors(faceColors);
    }
}

void Viewport::showFootprints(std::optional<std::vector<render::Polyline>> lines,
                              double magnification,
                              bool withFrozen)
{
    if (d->legend) {
        if (lines) {
            d->legend->tellOf(magnification, withFrozen);
        } else {
            d->legend->tellOfHovered();
        }
        d->legend->place();
    }
    d->givenFootprints = std::move(lines);
    d->redraw();
}

void Viewport::markEdge(std::optional<SurfaceEdge> edge)
{
    d->markedEdge = edge;
    d->redraw();
}

void Viewport::frameEdge(SurfaceEdge edge)
{
    if (!d->shownSurface || indexOf(edge.face) >= d->shownSurface->mesh().faceCount()) {
        return;
    }
    const TriangleMesh& mesh = d->shownSurface->mesh();
    const auto across = d->shownSurface->adjacency().neighbour(edge.face, edge.edge);
    glm::dvec3 normal = unitNormal(mesh, edge.face);
    auto corners = mesh.corners(edge.face);
    glm::vec3 low = glm::min(glm::min(corners[0], corners[1]), corners[2]);
    glm::vec3 high = glm::max(glm::max(corners[0], corners[1]), corners[2]);
    if (across) {
        normal += unitNormal(mesh, across->face);
        for (const glm::vec3& position : mesh.corners(across->face)) {
            low = glm::min(low, position);
            high = glm::max(high, position);
        }
    }
    if (const double length = glm::length(normal); length > 1e-6) {
        render::CameraPose pose = d->camera.pose();
        pose.yaw = std::atan2(normal.x, normal.z);
        pose.pitch = std::asin(std::clamp(normal.y / length, -1.0, 1.0));
        d->camera.setPose(pose);
    }
    d->camera.frame(low, high);
    d->cameraMoved();
}

/// A border edge is marked, too; nothing where the surface has no such face.
std::optional<render::Polyline> Viewport::Private::edgeMark() const
{
    if (!markedEdge || !shownSurface ||
        indexOf(markedEdge->face) >= shownSurface->mesh().faceCount()) {
        return std::nullopt;
    }
    render::Polyline line;
    const SeenSurface surface = seen();
    const int pieces = surface.isLimit() ? kCurvePieces : 1;
    for (int p = 0; p <= pieces; ++p) {
        const double t = static_cast<double>(p) / pieces;
        line.points.push_back(
            surface.position(markedEdge->face, glm::vec2(fromEdge(markedEdge->edge, {t, 0}))));
    }
    line.color = kEdgeColor;
    line.width = kEdgeWidth;
    line.hiddenOpacity = 0.35F;
    return line;
}

} // namespace trixel::ui
