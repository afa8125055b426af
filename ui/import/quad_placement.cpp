// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/quad_placement.h"

#include <QImage>
#include <QOpenGLWidget>

#include "core/mapping/projection.h"
#include "ui/import/corner_handle.h"
#include "ui/import/quad_overlay.h"
#include "ui/viewport/viewport.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

namespace trixel::ui {

namespace {

/// Of the view, that the image takes at first.
constexpr double kShare = 0.7;

glm::dvec2& cornerOf(Quad& quad, std::size_t corner)
{
    glm::dvec2* const corners[] = {&quad.p00, &quad.p10, &quad.p11, &quad.p01};
    return *corners[corner];
}

glm::dvec3 bilinear(const std::array<glm::dvec3, 4>& quad, glm::dvec2 st)
{
    const glm::dvec3 lower = quad[0] + st.x * (quad[1] - quad[0]);
    const glm::dvec3 upper = quad[3] + st.x * (quad[2] - quad[3]);
    return lower + st.y * (upper - lower);
}

} // namespace

QuadPlacement::QuadPlacement(Viewport& viewport, QObject* parent)
    : QObject(parent)
    , m_viewport(viewport)
    , m_overlay(new QuadOverlay(&viewport))
{
    // Over the picture and under all that explains it.
    m_overlay->lower();
    if (auto* canvas = viewport.findChild<QOpenGLWidget*>()) {
        canvas->lower();
    }
    const QString names[] = {tr("Lower left corner of the image"),
                             tr("Lower right corner of the image"),
                             tr("Upper right corner of the image"),
                             tr("Upper left corner of the image")};
    for (std::size_t k = 0; k < 4; ++k) {
        m_handles[k] = new CornerHandle(
            names[k],
            tr("%1: drag it, or move it by the arrow keys, with Shift farther; Tab goes to the "
               "next corner")
                .arg(names[k]),
            &viewport);
        connect(
            m_handles[k], &CornerHandle::moved, this, [this, k](QPointF to) { moveCorner(k, to); });
    }
    for (std::size_t k = 0; k < 3; ++k) {
        QWidget::setTabOrder(m_handles[k], m_handles[k + 1]);
    }
    connect(&viewport, &Viewport::cameraChanged, this, [this] {
        show();
        emit viewMoved();
    });
}

void QuadPlacement::setKind(MapKind kind)
{
    m_kind = kind;
    if (!m_isByHand) {
        placeQuad();
        placeCamera();
    }
    show();
}

void QuadPlacement::setOn(bool on)
{
    m_isOn = on;
    show();
}

void QuadPlacement::takeSurface(const Surface& surface)
{
    m_middle = 0.5 * (glm::dvec3(surface.low()) + glm::dvec3(surface.high()));
    m_size = surface.size();
    m_isByHand = false;
    placeQuad();
    placeCamera();
    show();
}

void QuadPlacement::setImage(const QImage& small, double aspect)
{
    m_overlay->setImage(small);
    m_aspect = aspect;
    if (!m_isByHand) {
        placeQuad();
        placeCamera();
        show();
    }
}

void QuadPlacement::setImageOpacity(double opacity)
{
    m_overlay->setImageOpacity(opacity);
}

void QuadPlacement::placeInView()
{
    if (m_kind == MapKind::Camera) {
        placeCamera();
    } else {
        placeQuad();
    }
    m_isByHand = true;
    show();
    emit changed();
}

void QuadPlacement::placeCamera()
{
    m_camera.camera = m_viewport.view();
    const double view = static_cast<double>(m_camera.camera.width) / m_camera.camera.height;
    const double x = kShare * std::min(1.0, m_aspect / view);
    const double y = kShare * std::min(1.0, view / m_aspect);
    m_camera.corners = {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

/// Upright and facing the view, at the depth of the surface's middle.
void QuadPlacement::placeQuad()
{
    const ViewCamera camera = m_viewport.view();
    const glm::dvec3 forward = camera.forward();
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::dvec3 up = glm::cross(right, forward);
    const double depth = std::max(glm::dot(m_middle - camera.position, forward), 0.01 * m_size);
    const glm::dvec3 centre = camera.position + depth * forward;
    const double view = static_cast<double>(camera.width) / camera.height;
    const double height =
        kShare * camera.unitsPerPixel(centre) * camera.height * std::min(1.0, view / m_aspect);
    const glm::dvec3 across = 0.5 * height * m_aspect * right;
    const glm::dvec3 upward = 0.5 * height * up;
    m_quad = {centre - across - upward,
              centre + across - upward,
              centre + across + upward,
              centre - across + upward};
}

void QuadPlacement::lookFromThere()
{
    m_viewport.lookThrough(m_camera.camera);
}

bool QuadPlacement::isSeen() const
{
    if (m_kind != MapKind::Camera) {
        return m_kind == MapKind::Quad;
    }
    const glm::dvec3 moved = m_viewport.camera().eye() - m_camera.camera.position;
    return glm::length(moved) <= 1e-6 * m_size;
}

void QuadPlacement::focusCorner()
{
    m_handles[0]->setFocus(Qt::ShortcutFocusReason);
}

/// In the direction of a place of the view, of any length.
glm::dvec3 QuadPlacement::rayThrough(QPointF place) const
{
    const double ratio = m_viewport.devicePixelRatioF();
    return m_viewport.camera().pixelRay({place.x() * ratio, place.y() * ratio}).direction;
}

std::optional<QPointF> QuadPlacement::seenAt(glm::dvec3 point) const
{
    const auto at = m_viewport.camera().project(point);
    const double ratio = m_viewport.devicePixelRatioF();
    return at ? std::optional(QPointF(at->x / ratio, at->y / ratio)) : std::nullopt;
}

/// In the plane through the corner that faces the view.
std::optional<glm::dvec3> QuadPlacement::quadCornerAt(glm::dvec3 corner, QPointF to) const
{
    const glm::dvec3 eye = m_viewport.camera().eye();
    const glm::dvec3 forward = m_viewport.camera().forward();
    const glm::dvec3 ray = rayThrough(to);
    const double depth = glm::dot(corner - eye, forward);
    const double along = glm::dot(ray, forward);
    return depth > 0 && along > 0 ? std::optional(eye + depth / along * ray) : std::nullopt;
}

/// In the clip space of the camera, which the view looks from.
std::optional<glm::dvec2> QuadPlacement::cameraCornerAt(QPointF to) const
{
    const ViewCamera& camera = m_camera.camera;
    const auto at = camera.project(camera.position + rayThrough(to));
    return at ? std::optional(
                    glm::dvec2(2 * at->x / camera.width - 1, 1 - 2 * at->y / camera.height))
              : std::nullopt;
}

void QuadPlacement::moveCorner(std::size_t corner, QPointF to)
{
    if (m_kind == MapKind::Camera) {
        const auto moved = cameraCornerAt(to);
        if (!moved) {
            return;
        }
        cornerOf(m_camera.corners, corner) = *moved;
    } else {
        const auto moved = quadCornerAt(m_quad[corner], to);
        if (!moved) {
            return;
        }
        m_quad[corner] = *moved;
    }
    m_isByHand = true;
    show();
    emit changed();
}

std::optional<QPointF> QuadPlacement::placeOf(glm::dvec2 st) const
{
    if (m_kind == MapKind::Quad) {
        return seenAt(bilinear(m_quad, st));
    }
    const ViewCamera& camera = m_camera.camera;
    const glm::dvec2 clip = trixel::bilinear(m_camera.corners, st);
    const glm::dvec3 ray =
        camera.pixelRay(0.5 * (clip.x + 1) * camera.width, 0.5 * (1 - clip.y) * camera.height)
            .direction;
    return seenAt(camera.position + m_size * glm::normalize(ray));
}

bool QuadPlacement::isUsable() const
{
    return m_kind == MapKind::Camera ? checkQuad(m_camera.corners).has_value()
                                     : quadProjection(m_quad).has_value();
}

void QuadPlacement::show()
{
    const bool isShown = m_isOn && isSeen();
    m_overlay->setVisible(isShown);
    if (!isShown) {
        for (CornerHandle* handle : m_handles) {
            handle->hide();
        }
        return;
    }
    m_overlay->setGeometry(m_viewport.rect());
    constexpr glm::dvec2 kCorners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (std::size_t k = 0; k < 4; ++k) {
        const auto place = placeOf(kCorners[k]);
        m_handles[k]->setVisible(place.has_value());
        if (place) {
            m_handles[k]->setPlace(*place);
        }
    }
    std::vector<std::optional<QPointF>> points;
    for (int row = 0; row <= QuadOverlay::kCells; ++row) {
        for (int column = 0; column <= QuadOverlay::kCells; ++column) {
            points.push_back(placeOf(glm::dvec2(column, row) / double(QuadOverlay::kCells)));
        }
    }
    m_overlay->setPlaces(std::move(points), isUsable());
}

} // namespace trixel::ui
