// SPDX-License-Identifier: GPL-3.0-or-later
#include <QScopedValueRollback>

#include "ui/viewport/viewport_private.h"

#include <algorithm>
#include <iterator>

namespace trixel::ui {

namespace {

bool isInside(glm::dvec2 position, glm::ivec2 size)
{
    return position.x >= 0 && position.y >= 0 && position.x < size.x && position.y < size.y;
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
    return seen().raycast({glm::vec3(ray.origin), glm::vec3(ray.direction)});
}

void Viewport::Private::hoverAt(glm::dvec2 position)
{
    pointer = position;
    refreshHover();
}

void Viewport::Private::refreshHover()
{
    const double ratio = q.devicePixelRatioF();
    emit q.pointerMoved(pointer ? std::optional(QPointF(pointer->x / ratio, pointer->y / ratio))
                                : std::nullopt);
    const bool wasOnSurface = pointed.has_value();
    pointed = pointer && isInside(*pointer, camera.viewport()) ? hit(*pointer) : std::nullopt;
    {
        const QScopedValueRollback itself(pointsItself, true);
        if (pointed) {
            inspection->pointAt(pointed->face, pointed->uv);
        } else if (wasOnSurface) {
            inspection->pointAway();
        }
    }
    showInspected(); // the same texel may be seen from elsewhere now
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
    if (!shownSurface) {
        return lines;
    }
    if (givenFootprints && shownView.footprint) { // while the view turns, too
        lines.insert(lines.end(), givenFootprints->begin(), givenFootprints->end());
    }
    const SeenSurface surface = seen();
    const bool idle = interaction == Interaction::None || interaction == Interaction::Inspect;
    const bool paints = settings.tool() == Tool::Brush || settings.tool() == Tool::Eraser;
    const auto draw = [&lines](std::vector<render::Polyline>&& more) {
        std::ranges::move(more, std::back_inserter(lines));
    };
    if (hoveredTexel && shownView.footprint && hoveredTexel->hasFootprint && idle &&
        !givenFootprints) {
        draw(footprintLines(surface, *hoveredTexel));
    }
    if (hoveredTexel && hoveredTexel->isHeld) {
        draw(heldMark());
    } else if (hoveredTexel && idle && (!paints || shownView.texelGrid || !pointed)) {
        lines.push_back(texelOutline(surface, *hoveredTexel));
    }
    if (interaction == Interaction::Camera) {
        return lines;
    }
    const auto ringPoint = brushDragPoint ? brushDragPoint : pointed;
    if (ringPoint && paints) {
        draw(brushRing(surface, *ringPoint, settings.brush()));
    }
    return lines;
}

} // namespace trixel::ui
