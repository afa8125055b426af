// SPDX-License-Identifier: GPL-3.0-or-later
//
// The texel that the view and others look at: described, drawn, held and stepped from.
#include <QKeyEvent>

#include "ui/viewport/inspect_keys.h"
#include "ui/viewport/viewport_private.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace trixel::ui {

namespace {

/// A face that spans fewer device pixels is not seen as one.
constexpr double kLeastFacePixels = 6.0;

/// The ray through the middle of the device pixel at a position.
PixelRay rayAt(const render::Camera& camera, glm::dvec2 position)
{
    return camera.pixelRay(glm::floor(position) + 0.5);
}

/// Device pixels between the outermost corners of a face; nothing where one is behind the camera.
std::optional<double> spanOnScreen(const render::Camera& camera,
                                   const std::array<glm::vec3, 3>& corners)
{
    std::array<glm::dvec2, 3> seen{};
    for (std::size_t k = 0; k < seen.size(); ++k) {
        const auto position = camera.project(corners[k]);
        if (!position) {
            return std::nullopt;
        }
        seen[k] = *position;
    }
    return std::max({glm::distance(seen[0], seen[1]),
                     glm::distance(seen[1], seen[2]),
                     glm::distance(seen[2], seen[0])});
}

/// Whether a face shows its front; one without area shows whatever it has.
bool showsFront(const render::Camera& camera, const std::array<glm::vec3, 3>& corners)
{
    const glm::dvec3 first(corners[0]);
    const glm::dvec3 normal =
        glm::cross(glm::dvec3(corners[1]) - first, glm::dvec3(corners[2]) - first);
    return glm::dot(normal, camera.eye() - first) >= 0;
}

} // namespace

void Viewport::useInspection(Inspection& inspection)
{
    d->inspection->disconnect(this);
    d->inspection = &inspection;
    d->ownInspection.reset();
    d->watchInspection();
}

std::optional<HoveredTexel> Viewport::inspectedTexel() const
{
    return d->describedTexel();
}

void Viewport::askForTexel()
{
    if (!d->shownSurface) {
        return;
    }
    if (!d->goTo) {
        d->goTo = new GoToBar(*this);
    }
    d->goTo->ask(*d->inspection);
}

void Viewport::Private::watchInspection()
{
    inspection->setLevelsDropped(shownView.mipDrop);
    QObject::connect(inspection, &Inspection::changed, &q, [this] {
        if (!pointsItself) {
            reading.forget(); // what changed may be the texels, of which this hears first
            showInspected();
        }
    });
    QObject::connect(inspection, &Inspection::heldChanged, &q, [this](bool held) {
        if (!held && pointer && interaction == Interaction::None) {
            refreshHover(); // what is under the pointer was not said meanwhile
        }
    });
    QObject::connect(inspection, &Inspection::wentTo, &q, [this] { bringIntoSight(); });
    QObject::disconnect(&reading, nullptr, &q, nullptr); // of the inspection before
    QObject::connect(&reading, &TexelReading::read, &q, [this] {
        showInspected();
        emit q.inspectedRead();
    });
    showInspected();
}

std::optional<HoveredTexel> Viewport::Private::describedTexel()
{
    const auto& texel = inspection->texel();
    if (!texel || !shownSurface || indexOf(texel->place.face) >= texels().faceCount()) {
        return std::nullopt;
    }
    const SeenSurface surface = seen();
    const SurfacePoint point{
        texel->place.face, texel->uv, surface.position(texel->place.face, texel->uv)};
    reading.want(texels(), point.face, shownView.mipDrop);
    HoveredTexel described =
        describeTexel(*shownSurface, texels(), reading.shown(), point, shownView.mipDrop);
    described.isHeld = inspection->isHeld();
    if (!described.values.empty()) {
        described.report.display = displayOf(texels().format(), described.values, settings.look());
    }
    const bool underPointer =
        !described.isHeld && pointed && pointed->face == point.face && pointed->uv == point.uv;
    if (underPointer) {
        const PixelRay ray = rayAt(camera, *pointer);
        addFootprint(described, surface.tangentFace(point.face, point.uv), ray);
        if (const auto middle = hit(glm::floor(*pointer) + 0.5)) {
            described.pixelQuery = {
                middle->face,
                middle->uv,
                screenFootprint(ray, surface.tangentFace(middle->face, middle->uv))};
        }
    } else if (const auto position = camera.project(point.position)) {
        addFootprint(
            described, surface.tangentFace(point.face, point.uv), camera.pixelRay(*position));
        described.pixelQuery = {point.face, point.uv, described.footprint};
    }
    return described;
}

void Viewport::Private::showInspected()
{
    const bool hadTexel = hoveredTexel.has_value();
    hoveredTexel = inspection->isPointedAt() ? describedTexel() : std::nullopt;
    if (hoveredTexel || hadTexel) {
        emit q.hovered(hoveredTexel);
        redraw();
    }
}

/// Frames the face of a texel that was gone to, unless it is seen already.
void Viewport::Private::bringIntoSight()
{
    if (!hoveredTexel) {
        return;
    }
    const FaceId face = hoveredTexel->point.face;
    const auto corners = seen().tangentFace(face, hoveredTexel->point.uv);
    const auto span = spanOnScreen(camera, corners);
    const bool isSmall = span && *span < kLeastFacePixels * q.devicePixelRatioF();
    if (isSmall || !showsFront(camera, corners) || !q.widgetPosition(hoveredTexel->point)) {
        q.frameFace(face);
    }
}

void Viewport::Private::beginInspecting(const PointerEvent& event)
{
    const auto point = hit(event.sample.position);
    if (!point) {
        return; // what is held stays
    }
    const auto& held = inspection->texel();
    const bool isOnHeld = inspection->isHeld() && held->place.face == point->face &&
                          held->place.texel == texelAt(held->level, glm::dvec2(point->uv));
    if (isOnHeld) {
        inspection->letGo();
        return;
    }
    interaction = Interaction::Inspect;
    inspection->hold(point->face, point->uv);
}

void Viewport::Private::holdAt(glm::dvec2 position)
{
    if (const auto point = hit(position)) {
        inspection->hold(point->face, point->uv);
    }
}

bool Viewport::Private::inspectKey(const QKeyEvent& event)
{
    const bool steps = inspection->isHeld() || (settings.tool() == Tool::Inspect && hoveredTexel);
    return interaction == Interaction::None && steps && takeInspectKey(*inspection, event);
}

/// The held texel, twice outlined and pointed at from outside, so that it is found however small.
std::vector<render::Polyline> Viewport::Private::heldMark() const
{
    const double ratio = q.devicePixelRatioF();
    const auto perPixel =
        static_cast<float>(camera.worldPerPixel(hoveredTexel->point.position) * ratio);
    return heldTexelLines(seen(), *hoveredTexel, perPixel);
}

} // namespace trixel::ui
