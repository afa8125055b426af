// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/footprint_probe.h"

#include "core/footprint/projected_face.h"
#include "core/footprint/tilted_view.h"
#include "ui/document/document.h"
#include "ui/document/inspection.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace trixel::ui {

namespace {

constexpr double kMostDegrees = 89.0;

/// World → homogeneous pixels of the camera's picture.
glm::dmat4 toPixels(const render::Camera& camera)
{
    const glm::dvec2 half = glm::dvec2(camera.viewport()) / 2.0;
    glm::dmat4 screen(1.0);
    screen[0][0] = half.x;
    screen[1][1] = -half.y;
    screen[3][0] = half.x;
    screen[3][1] = half.y;
    return screen * glm::dmat4(camera.projection()) * glm::dmat4(camera.view());
}

/// Where a direction of the world points in (u,v) of a face; along u where it is the normal's.
glm::dvec2 leanOf(const std::array<glm::vec3, 3>& corners, glm::dvec3 direction)
{
    const glm::dvec3 e1(corners[1] - corners[0]);
    const glm::dvec3 e2(corners[2] - corners[0]);
    const double a = glm::dot(e1, e1);
    const double b = glm::dot(e1, e2);
    const double c = glm::dot(e2, e2);
    const double x = glm::dot(e1, direction);
    const double y = glm::dot(e2, direction);
    const double det = a * c - b * b;
    const glm::dvec2 lean(c * x - b * y, a * y - b * x);
    const double least = 1e-3 * det * glm::length(direction);
    const double along = glm::length(lean.x * e1 + lean.y * e2);
    return along > least ? lean / det : glm::dvec2(1, 0);
}

} // namespace

FootprintProbe::FootprintProbe(Document& document, Inspection& inspection, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_inspection(inspection)
{
    connect(&inspection, &Inspection::changed, this, &FootprintProbe::update);
    connect(&document, &Document::opened, this, [this] {
        m_limit.reset(); // of another surface
        thaw();
        update();
    });
}

void FootprintProbe::setActive(bool active)
{
    if (std::exchange(m_isActive, active) != active && active) {
        update();
    }
}

void FootprintProbe::setCamera(const render::Camera& camera)
{
    m_camera = camera;
    if (m_source == FootprintSource::Screen || m_source == FootprintSource::Tilted) {
        update();
    }
}

void FootprintProbe::setLimit(std::shared_ptr<const LimitMesh> limit)
{
    m_limit = std::move(limit);
    if (m_source == FootprintSource::Screen || m_source == FootprintSource::Tilted) {
        update();
    }
}

SeenSurface FootprintProbe::seen() const
{
    return SeenSurface(*m_document.surface(), m_limit.get());
}

void FootprintProbe::setSource(FootprintSource source)
{
    if (m_source == source) {
        return;
    }
    if (source == FootprintSource::ByHand && m_live) {
        const double r = m_document.texels().face(m_live->placed.face).level().resolution();
        m_first = r * m_live->placed.footprint.w1;
        m_second = r * m_live->placed.footprint.w2;
    } else if (source == FootprintSource::TextureAligned) {
        const auto usable = [](double width) { return width > 0 ? width : 4.0; };
        m_first = {usable(std::abs(m_first.x)), 0};
        m_second = {0, usable(std::abs(m_second.y))};
    }
    m_source = source;
    emit sourceChanged();
    update();
}

void FootprintProbe::setVectors(glm::dvec2 w1, glm::dvec2 w2)
{
    if (!m_live) {
        return;
    }
    const double r = m_document.texels().face(m_live->placed.face).level().resolution();
    m_first = r * w1;
    m_second = r * w2;
    const bool aligned = w1.y == 0 && w2.x == 0;
    const bool stays = m_source == FootprintSource::TextureAligned && aligned;
    if (!stays && std::exchange(m_source, FootprintSource::ByHand) != FootprintSource::ByHand) {
        emit sourceChanged();
    }
    update();
}

void FootprintProbe::setDegrees(double degrees)
{
    const double usable = std::clamp(degrees, 0.0, kMostDegrees);
    if (std::exchange(m_degrees, usable) != usable && m_source == FootprintSource::Tilted) {
        update();
    }
}

void FootprintProbe::freeze()
{
    m_frozen = m_live;
    emit frozenChanged();
}

void FootprintProbe::thaw()
{
    if (std::exchange(m_frozen, std::nullopt)) {
        emit frozenChanged();
    }
}

void FootprintProbe::update()
{
    if (!m_isActive) {
        return;
    }
    const bool was = m_live.has_value();
    m_live = made();
    if (m_live || was) {
        emit changed();
    }
}

std::optional<ProbedFootprint> FootprintProbe::made() const
{
    const auto& texel = m_inspection.texel();
    if (!texel || !m_document.isOpen()) {
        return std::nullopt;
    }
    const FaceId face = texel->place.face;
    const glm::dvec2 uv(texel->uv);
    switch (m_source) {
    case FootprintSource::Screen:
        return fromScreen(face, uv);
    case FootprintSource::Tilted:
        return tilted(m_degrees);
    case FootprintSource::TextureAligned:
    case FootprintSource::ByHand:
        break;
    }
    const double r = m_document.texels().face(face).level().resolution();
    ProbedFootprint probed;
    probed.placed = {face, uv, {m_first / r, m_second / r}};
    probed.source = m_source;
    return probed;
}

std::optional<ProbedFootprint> FootprintProbe::fromScreen(FaceId face, glm::dvec2 uv) const
{
    const SeenSurface surface = seen();
    const auto corners = surface.tangentFace(face, glm::vec2(uv));
    const auto pixel = m_camera.project(glm::dvec3(surface.position(face, glm::vec2(uv))));
    if (!pixel) {
        return std::nullopt;
    }
    ProbedFootprint probed;
    probed.placed = {face, uv, screenFootprint(m_camera.pixelRay(*pixel), corners)};
    probed.source = FootprintSource::Screen;
    probed.derivatives = screenDerivatives(projectedFace(toPixels(m_camera), corners), uv);
    return probed;
}

std::optional<ProbedFootprint> FootprintProbe::tilted(double degrees) const
{
    const auto& texel = m_inspection.texel();
    if (!texel || !m_document.isOpen()) {
        return std::nullopt;
    }
    const SeenSurface surface = seen();
    const auto corners = surface.tangentFace(texel->place.face, texel->uv);
    const glm::dvec2 uv(texel->uv);
    const glm::dvec3 point(surface.position(texel->place.face, texel->uv));
    // As far away as the view is, so that it begins with the pixels that are seen now.
    const glm::dvec3 toEye = m_camera.eye() - point;
    TiltedView view;
    view.distance = std::max(glm::length(toEye), 1e-12);
    view.radiansPerPixel = m_camera.worldPerPixel(point) / view.distance;
    view.towards = leanOf(corners, toEye);
    ProbedFootprint probed;
    probed.placed = {
        texel->place.face, uv, screenFootprint(tiltedRay(view, corners, uv, degrees), corners)};
    probed.source = FootprintSource::Tilted;
    probed.degrees = degrees;
    return probed;
}

} // namespace trixel::ui
