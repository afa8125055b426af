// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/viewport_private.h"

namespace trixel::ui {

namespace {

bool isInside(glm::dvec2 position, glm::ivec2 size)
{
    return position.x >= 0 && position.y >= 0 && position.x < size.x && position.y < size.y;
}

/// The ray through the middle of the device pixel at a position.
PixelRay rayAt(const render::Camera& camera, glm::dvec2 position)
{
    return camera.pixelRay(glm::floor(position) + 0.5);
}

} // namespace

glm::dvec2 Viewport::Private::devicePosition(QPointF position) const
{
    const double ratio = q.devicePixelRatioF();
    return {position.x() * ratio, position.y() * ratio};
}

std::optional<SurfacePoint> Viewport::Private::hit(glm::dvec2 position) const
{
    if (!shownSurface) {
        return std::nullopt;
    }
    const PixelRay ray = camera.pixelRay(position);
    return shownSurface->bvh().raycast({glm::vec3(ray.origin), glm::vec3(ray.direction)});
}

void Viewport::Private::hoverAt(glm::dvec2 position)
{
    pointer = position;
    refreshHover();
}

void Viewport::Private::refreshHover()
{
    const bool hadTexel = hoveredTexel.has_value();
    hoveredTexel.reset();
    const double ratio = q.devicePixelRatioF();
    emit q.pointerMoved(pointer ? std::optional(QPointF(pointer->x / ratio, pointer->y / ratio))
                                : std::nullopt);
    const auto point =
        pointer && isInside(*pointer, camera.viewport()) ? hit(*pointer) : std::nullopt;
    if (point) {
        hoveredTexel = describeTexel(shownSurface->mesh(),
                                     texels(),
                                     shownTexels,
                                     *point,
                                     rayAt(camera, *pointer),
                                     shownView.mipDrop);
    }
    if (hoveredTexel) {
        const PixelRay ray = rayAt(camera, *pointer);
        if (const auto middle = hit(glm::floor(*pointer) + 0.5)) {
            hoveredTexel->pixelQuery = {
                middle->face,
                middle->uv,
                screenFootprint(ray, shownSurface->mesh().corners(middle->face))};
        }
    }
    if (hoveredTexel || hadTexel) {
        emit q.hovered(hoveredTexel);
        redraw();
    }
}

void Viewport::Private::leave()
{
    pointer.reset();
    refreshHover();
}

void Viewport::Private::cameraMoved()
{
    emit q.cameraChanged();
    refreshHover();
    redraw();
}

std::vector<render::Polyline> Viewport::Private::overlays() const
{
    std::vector<render::Polyline> lines;
    if (const auto mark = edgeMark()) {
        lines.push_back(*mark);
    }
    lines.insert(lines.end(), selectionLines.begin(), selectionLines.end());
    if (!shownSurface || interaction == Interaction::Camera) {
        return lines;
    }
    const TriangleMesh& mesh = shownSurface->mesh();
    const bool idle = interaction == Interaction::None;
    if (hoveredTexel && shownView.footprint && idle) {
        for (render::Polyline& line : footprintLines(mesh, *hoveredTexel)) {
            lines.push_back(std::move(line));
        }
    }
    const bool paints = settings.tool() == Tool::Brush || settings.tool() == Tool::Eraser;
    if (hoveredTexel && (!paints || shownView.texelGrid) && idle) {
        lines.push_back(texelOutline(mesh, *hoveredTexel));
    }
    const auto ringPoint = brushDragPoint ? brushDragPoint
                           : hoveredTexel ? std::optional(hoveredTexel->point)
                                          : std::nullopt;
    if (ringPoint && paints) {
        for (render::Polyline& line : brushRing(*shownSurface, *ringPoint, settings.brush())) {
            lines.push_back(std::move(line));
        }
    }
    return lines;
}

} // namespace trixel::ui
