// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/texel_format.h"
#include "ui/viewport/viewport_private.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace trixel::ui {

namespace {

constexpr double kSizePerPixel = 0.006; // e-folds of the radius a logical pixel
constexpr double kHardnessPerPixel = 0.004;
constexpr double kLineStep = 2.0; // device pixels between samples of a straight line
constexpr int kMostLineSteps = 4000;
/// A brush stays between these parts of the surface's size.
constexpr float kLeastRadius = 1e-4F;
constexpr float kMostRadius = 1.0F;

/// A texel's channels as a brush colour: grey for one channel, opaque where there is no fourth.
std::array<float, 4> brushColor(const std::vector<float>& values)
{
    std::array<float, 4> color{0, 0, 0, 1};
    for (std::size_t k = 0; k < color.size() && k < values.size(); ++k) {
        color[k] = values[k];
    }
    if (values.size() == 1) {
        color[1] = color[2] = values[0];
    }
    return color;
}

} // namespace

void Viewport::Private::press(const PointerEvent& event)
{
    if (interaction != Interaction::None) {
        return; // the button pressed first decides until it is let go
    }
    pressPosition = lastPosition = event.sample.position;
    hoverAt(event.sample.position);
    if (!shownSurface) {
        return;
    }
    heldButton = event.button;
    const bool control = event.modifiers.testFlag(Qt::ControlModifier);
    if (const auto drag = cameraDragFor(event.button, event.modifiers)) {
        interaction = Interaction::Camera;
        cameraDrag = *drag;
    } else if (event.button == Qt::RightButton && control) {
        interaction = Interaction::BrushDrag;
        brushDragPoint = hit(event.sample.position);
    } else if (event.button == Qt::LeftButton) {
        if (settings.tool() == Tool::Select) {
            beginSelecting(event);
        } else if (control || settings.tool() == Tool::Pick) {
            interaction = Interaction::Pick;
            pickAt(event.sample.position);
        } else if (settings.tool() == Tool::Inspect) {
            beginInspecting(event);
        } else if (settings.tool() == Tool::Fill && !event.eraserEnd) {
            fillAt(event.sample.position);
        } else if (event.modifiers.testFlag(Qt::ShiftModifier) && stroke.lastPoint()) {
            straightLine(event);
        } else {
            beginStroke(event);
        }
    }
    redraw();
}

void Viewport::Private::move(const PointerEvent& event)
{
    const glm::dvec2 position = event.sample.position;
    const glm::dvec2 moved = position - lastPosition;
    lastPosition = position;
    switch (interaction) {
    case Interaction::Camera:
        pointer = position;
        dragCamera(camera, cameraDrag, moved, pressPosition);
        emit q.cameraChanged();
        redraw();
        return;
    case Interaction::BrushDrag:
        dragBrush(moved);
        return;
    case Interaction::Stroke:
        addToStroke(event.sample);
        break;
    case Interaction::Pick:
        pickAt(position);
        break;
    case Interaction::Select:
        selectTo(position);
        break;
    case Interaction::Inspect:
        holdAt(position);
        break;
    case Interaction::None:
        break;
    }
    hoverAt(position);
}

void Viewport::Private::release(const PointerEvent& event)
{
    if (interaction == Interaction::None || event.button != heldButton) {
        return;
    }
    const Interaction ended = std::exchange(interaction, Interaction::None);
    heldButton = Qt::NoButton;
    brushDragPoint.reset();
    if (ended == Interaction::Stroke) {
        stroke.end();
    }
    hoverAt(event.sample.position);
    redraw();
}

bool Viewport::Private::cancel()
{
    if (interaction == Interaction::Select) {
        interaction = Interaction::None;
        selection->set(*std::exchange(selectionBefore, {}));
        return true;
    }
    if (interaction != Interaction::Stroke) {
        return false;
    }
    interaction = Interaction::None;
    stroke.cancel();
    refreshHover();
    redraw();
    return true;
}

void Viewport::Private::beginStroke(const PointerEvent& event)
{
    Brush brush = settings.brush();
    const bool erases = event.eraserEnd || settings.tool() == Tool::Eraser;
    brush.blend = erases ? BlendMode::Erase : BlendMode::Normal;
    if (showsLimit()) {
        stroke.begin(brush, event.sample.time, StrokePace::AtOnce, limitView.solid());
    } else {
        stroke.begin(brush, event.sample.time, paceAt(brush, event.sample.position));
    }
    interaction = stroke.isActive() ? Interaction::Stroke : Interaction::None;
    addToStroke(event.sample);
}

void Viewport::Private::addToStroke(const PointerSample& sample)
{
    const auto point = hit(sample.position);
    stroke.add(point, sample, point ? camera.worldPerPixel(point->position) : 0);
}

/// From where the last stroke ended to here, straight on the screen and following the surface.
void Viewport::Private::straightLine(const PointerEvent& event)
{
    const auto start = camera.project(stroke.lastPoint()->position);
    PointerEvent first = event;
    first.sample.position = start.value_or(event.sample.position);
    const glm::dvec2 way = event.sample.position - first.sample.position;
    const int steps =
        static_cast<int>(std::clamp(glm::length(way) / kLineStep, 1.0, double{kMostLineSteps}));
    const glm::dvec2 from = first.sample.position;
    beginStroke(first);
    for (int k = 1; k <= steps; ++k) {
        PointerSample sample = event.sample;
        sample.position = from + way * (static_cast<double>(k) / steps);
        addToStroke(sample);
    }
}

void Viewport::Private::fillAt(glm::dvec2 position)
{
    if (const auto point = hit(position)) {
        document.fillFaces(std::array{point->face}, settings.brush().color);
    }
}

void Viewport::Private::pickAt(glm::dvec2 position)
{
    const auto point = hit(position);
    if (!point) {
        return;
    }
    // The texel as shown: what is seen is what is taken.
    const TexelStore& store = texels();
    const Level level = store.face(point->face).level().coarser(shownView.mipDrop);
    const TexelIndex index = texelIndex(level, texelAt(level, glm::dvec2(point->uv)));
    emit q.colorPicked(
        brushColor(reading.shown().values(store, point->face, shownView.mipDrop, index)));
}

void Viewport::Private::dragBrush(glm::dvec2 pixels)
{
    const double ratio = q.devicePixelRatioF();
    const float size = shownSurface->size() > 0 ? shownSurface->size() : 1.0F;
    Brush brush = settings.brush();
    const auto grown = static_cast<float>(std::exp(kSizePerPixel * pixels.x / ratio));
    const auto harder = static_cast<float>(-kHardnessPerPixel * pixels.y / ratio);
    brush.radius = std::clamp(brush.radius * grown, kLeastRadius * size, kMostRadius * size);
    brush.hardness = std::clamp(brush.hardness + harder, 0.0F, 1.0F);
    settings.setBrush(brush);
}

} // namespace trixel::ui
