// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/viewport.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QTabletEvent>
#include <QWheelEvent>

#include "render/camera_view.h"
#include "ui/viewport/viewport_private.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace trixel::ui {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

struct Box
{
    glm::vec3 low{0};
    glm::vec3 high{0};
};

/// Of a face and its neighbours.
Box boxAround(const Surface& surface, FaceId face)
{
    const glm::vec3 corner = surface.mesh().corners(face)[0];
    Box box{corner, corner};
    const auto include = [&](FaceId included) {
        for (const glm::vec3& position : surface.mesh().corners(included)) {
            box.low = glm::min(box.low, position);
            box.high = glm::max(box.high, position);
        }
    };
    include(face);
    for (const LocalEdge edge : kLocalEdges) {
        if (const auto next = surface.adjacency().neighbour(face, edge)) {
            include(next->face);
        }
    }
    return box;
}

template <class Event>
PointerEvent pointerEvent(const Event& event, glm::dvec2 position)
{
    PointerEvent result;
    result.sample.position = position;
    result.sample.time = static_cast<double>(event.timestamp()) / 1000.0;
    result.button = event.button();
    result.modifiers = event.modifiers();
    return result;
}

/// Whether a pen made this mouse event: its tablet event has been used already.
bool isEchoOfPen(const QMouseEvent& event)
{
    return event.pointerType() == QPointingDevice::PointerType::Pen ||
           event.pointerType() == QPointingDevice::PointerType::Eraser;
}

} // namespace

Viewport::Private::Private(Viewport& viewport, Document& theDocument, ViewSettings& theSettings)
    : q(viewport)
    , document(theDocument)
    , settings(theSettings)
    , shownView(theSettings.view())
    , ownInspection(std::make_unique<Inspection>(theDocument))
    , inspection(ownInspection.get())
    , stroke(theDocument)
{
}

Viewport::Viewport(Document& document, ViewSettings& settings, QWidget* parent)
    : QWidget(parent)
    , d(std::make_unique<Private>(*this, document, settings))
{
    setMouseTracking(true);
    setTabletTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::CrossCursor);
    setMinimumSize(160, 120);
    setAccessibleName(tr("3D view"));
    setAccessibleDescription(tr("Shows the surface and its texels; paints on them"));
    connect(&document, &Document::opened, this, [this] { d->takeSurface(); });
    connect(&document, &Document::changed, this, [this](const Change& c) { d->takeChange(c); });
    d->watchPainting();
    connect(&settings, &ViewSettings::viewChanged, this, [this] { d->takeView(); });
    connect(&settings, &ViewSettings::lookChanged, this, [this] { d->takeLook(); });
    connect(&settings, &ViewSettings::comparisonChanged, this, [this] { d->takeComparison(); });
    connect(&settings, &ViewSettings::brushChanged, this, [this] { d->redraw(); });
    connect(&settings, &ViewSettings::toolChanged, this, [this] { d->redraw(); });
    connect(&settings, &ViewSettings::lookChanged, this, [this] { d->showInspected(); });
    connect(&d->cornersWatcher, &QFutureWatcherBase::finished, this, [this] { d->cornersReady(); });
    connect(&d->streaming, &CardStreaming::ready, this, [this] { d->redraw(); });
    connect(&d->streaming, &CardStreaming::outOfMemory, this, [this] {
        emit notice(tr("There is not enough memory: some faces are shown coarser than they are."));
    });
    connect(
        &d->filterWatcher, &QFutureWatcherBase::finished, this, [this] { d->filterMeshReady(); });
    connect(&document, &Document::heldTexelsReleased, this, [this] { d->releaseHeldTexels(); });
    connect(&document, &Document::levelsChanged, this, [this] { d->forgetFilterMesh(); });
    d->watchInspection();
    d->watchLimit();
    d->makeCanvas();
    d->splitBar = new SplitBar(settings, this);
    if (document.isOpen()) {
        d->takeSurface();
    }
}

Viewport::~Viewport()
{
    d->cornersWatcher.disconnect(this);
    d->limitView.disconnect(this);
    d->filterWatcher.disconnect(this);
    d->outlineWatcher.disconnect(this);
    delete d->canvas; // while what it draws with is still there
}

void Viewport::frameAll()
{
    if (d->shownSurface) {
        d->camera.frame(d->shownSurface->low(), d->shownSurface->high());
    }
    d->cameraMoved();
}

void Viewport::frameHovered()
{
    if (!d->pointed && !d->hoveredTexel) {
        frameAll();
        return;
    }
    const FaceId face = d->pointed ? d->pointed->face : d->hoveredTexel->point.face;
    const auto [low, high] = boxAround(*d->shownSurface, face);
    d->camera.frame(low, high);
    d->cameraMoved();
}

void Viewport::frameFace(FaceId face)
{
    if (!d->shownSurface || indexOf(face) >= d->shownSurface->mesh().faceCount()) {
        return;
    }
    const auto corners = d->seen().tangentFace(face, glm::vec2(1.0F / 3));
    const glm::dvec3 normal =
        glm::cross(glm::dvec3(corners[1] - corners[0]), glm::dvec3(corners[2] - corners[0]));
    const double length = glm::length(normal);
    if (length > 0 && std::isfinite(length)) {
        render::CameraPose pose = d->camera.pose();
        pose.yaw = std::atan2(normal.x, normal.z);
        pose.pitch = std::asin(std::clamp(normal.y / length, -1.0, 1.0));
        d->camera.setPose(pose);
    }
    const auto [low, high] = boxAround(*d->shownSurface, face);
    d->camera.frame(low, high);
    d->cameraMoved();
}

const render::Camera& Viewport::camera() const
{
    return d->camera;
}

void Viewport::setCamera(const render::CameraPose& pose)
{
    d->camera.setPose(pose);
    d->cameraMoved();
}

ViewCamera Viewport::view() const
{
    return render::viewOf(d->camera);
}

void Viewport::lookThrough(const ViewCamera& view)
{
    if (validate(view)) {
        d->fitCamera();
        render::lookThrough(d->camera, view);
        d->cameraMoved();
    }
}

void Viewport::lookFrom(double yaw, double pitch, double closeness)
{
    render::CameraPose pose = d->camera.pose();
    pose.yaw = yaw * kDegree;
    pose.pitch = pitch * kDegree;
    d->camera.setPose(pose);
    frameAll();
    if (closeness > 0) {
        d->camera.zoom(1 / closeness);
    }
    d->cameraMoved();
}

std::optional<QPointF> Viewport::widgetPosition(const SurfacePoint& point) const
{
    const auto position = d->camera.project(point.position);
    if (!d->shownSurface || !position) {
        return std::nullopt;
    }
    const double ratio = devicePixelRatioF();
    const QPointF inWidget(position->x / ratio, position->y / ratio);
    const auto seen = d->hit(*position);
    // Nearer by more than rounding is in front.
    const glm::dvec3 eye = d->camera.eye();
    const double distance = glm::length(glm::dvec3(point.position) - eye);
    const bool hidden =
        seen && glm::length(glm::dvec3(seen->position) - eye) < distance * (1 - 1e-4);
    return hidden || !QRectF(rect()).contains(inWidget) ? std::nullopt : std::optional(inWidget);
}

std::optional<SurfacePoint> Viewport::surfacePointAt(QPointF position) const
{
    return d->hit(d->devicePosition(position));
}

bool Viewport::canDraw() const
{
    return d->canvas && d->canvas->isValid() && d->renderer;
}

render::FrameFigures Viewport::figures() const
{
    return d->renderer ? d->renderer->figures() : render::FrameFigures();
}

QImage Viewport::grabFramebuffer()
{
    settle();
    return canDraw() ? d->canvas->grabFramebuffer() : QImage();
}

void Viewport::settle()
{
    d->waitForCorners();
    d->settleLimit();
    if (!canDraw()) {
        return;
    }
    d->canvas->makeCurrent();
    d->sendMesh();
    d->sendLimit(std::numeric_limits<std::size_t>::max());
    d->waitForFilterMesh();
    d->finishTexels();
    while (d->painting.isGivingBack() && d->shownSurface) {
        d->drawPreview();
        d->finishTexels();
        d->previewDrawn();
    }
    d->finishAtlas();
    d->canvas->doneCurrent();
    d->redraw();
}

void Viewport::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    d->fitCamera();
    for (QWidget* whole : {static_cast<QWidget*>(d->canvas), static_cast<QWidget*>(d->message)}) {
        if (whole) {
            whole->setGeometry(rect());
        }
    }
    if (d->legend) {
        d->legend->place();
        d->hud->place();
    }
    if (d->goTo) {
        d->goTo->place();
    }
    if (d->creases) {
        d->creases->place();
    }
    d->splitBar->place();
}

void Viewport::mousePressEvent(QMouseEvent* event)
{
    if (!d->penStroke && !isEchoOfPen(*event)) {
        d->press(pointerEvent(*event, d->devicePosition(event->position())));
    }
}

void Viewport::mouseMoveEvent(QMouseEvent* event)
{
    if (!d->penStroke && !isEchoOfPen(*event)) {
        d->move(pointerEvent(*event, d->devicePosition(event->position())));
    }
}

void Viewport::mouseReleaseEvent(QMouseEvent* event)
{
    if (!d->penStroke && !isEchoOfPen(*event)) {
        d->release(pointerEvent(*event, d->devicePosition(event->position())));
    }
}

void Viewport::tabletEvent(QTabletEvent* event)
{
    PointerEvent pointer = pointerEvent(*event, d->devicePosition(event->position()));
    pointer.sample.pressure = static_cast<float>(event->pressure());
    pointer.eraserEnd = event->pointerType() == QPointingDevice::PointerType::Eraser;
    switch (event->type()) {
    case QEvent::TabletPress:
        setFocus(Qt::MouseFocusReason);
        d->penStroke = true;
        d->press(pointer);
        break;
    case QEvent::TabletMove:
        d->move(pointer);
        break;
    case QEvent::TabletRelease:
        d->release(pointer);
        d->penStroke = event->buttons() != Qt::NoButton;
        break;
    default:
        break;
    }
    event->accept(); // no mouse events are made from it
}

void Viewport::wheelEvent(QWheelEvent* event)
{
    constexpr double kUnitsPerNotch = 120.0;
    if (d->interaction != Interaction::Stroke && d->shownSurface) {
        const glm::dvec2 position = d->devicePosition(event->position());
        d->pointer = position;
        wheelCamera(d->camera, event->angleDelta().y() / kUnitsPerNotch, position);
        d->cameraMoved();
    }
    event->accept();
}

void Viewport::keyPressEvent(QKeyEvent* event)
{
    if ((event->key() == Qt::Key_Escape && d->cancel()) || d->inspectKey(*event)) {
        event->accept();
        return;
    }
    QWidget::keyPressEvent(event);
}

void Viewport::leaveEvent(QEvent* event)
{
    QWidget::leaveEvent(event);
    if (d->interaction == Interaction::None) {
        d->leave();
    }
}

} // namespace trixel::ui
