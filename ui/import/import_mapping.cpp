// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/import_mapping.h"

#include "core/mapping/faces_in_reach.h"
#include "core/mapping/sphere_mapping.h"
#include "core/mapping/uv_mapping.h"
#include "core/study/views/camera_clip.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

namespace trixel::ui {

namespace {

PlaneAxes straightAxes(PlaneSide side)
{
    switch (side) {
    case PlaneSide::Front:
        break;
    case PlaneSide::Back:
        return {{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
    case PlaneSide::Right:
        return {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}};
    case PlaneSide::Left:
        return {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}};
    case PlaneSide::Top:
        return {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}};
    case PlaneSide::Bottom:
        return {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
    }
    return {};
}

Result<Projection> planeOf(const PlaneSettings& plane)
{
    const PlaneAxes axes = axesOf(plane);
    const glm::dvec3 right = plane.size.x * axes.right;
    const glm::dvec3 up = plane.size.y * axes.up;
    if (!(plane.size.x > 0) || !(plane.size.y > 0)) {
        return contentsError("the plane's width and height have to be above 0");
    }
    return planarProjection(plane.centre - 0.5 * (right + up), right, up);
}

Result<Projection> projectionOf(const ImportSettings& settings)
{
    if (settings.kind == MapKind::Plane) {
        return planeOf(settings.plane);
    }
    if (settings.kind == MapKind::Quad) {
        return quadProjection(settings.quad);
    }
    if (const Status usable = validate(settings.camera.camera); !usable) {
        return tl::unexpected(usable.error());
    }
    return cameraQuadProjection(toClip(settings.camera.camera), settings.camera.corners);
}

} // namespace

PlaneAxes axesOf(const PlaneSettings& plane)
{
    const PlaneAxes straight = straightAxes(plane.side);
    const double angle = plane.turn * std::numbers::pi / 180;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {
        c * straight.right + s * straight.up, c * straight.up - s * straight.right, straight.front};
}

Result<ImportMapping> makeImportMapping(const ImportSettings& settings,
                                        const std::shared_ptr<const Surface>& surface)
{
    ImportMapping made{surface, nullptr, std::nullopt};
    if (settings.kind == MapKind::Uvs) {
        if (!surface->mesh().hasUvs()) {
            return contentsError("the mesh has no uvs");
        }
        made.mapping = std::make_unique<const UvMapping>(surface->mesh());
        return made;
    }
    if (settings.kind == MapKind::Sphere) {
        const auto turned = sphereTurn(settings.sphere.axis, settings.sphere.turn);
        if (!turned) {
            return tl::unexpected(turned.error());
        }
        made.mapping =
            std::make_unique<const SphereMapping>(surface->mesh(), settings.sphere.centre, *turned);
        return made;
    }
    auto projection = projectionOf(settings);
    if (!projection) {
        return tl::unexpected(projection.error());
    }
    projection->frontOnly = settings.frontOnly;
    projection->visibleOnly = settings.visibleOnly;
    made.mapping =
        std::make_unique<const ProjectionMapping>(surface->mesh(), *projection, &surface->bvh());
    made.projection = std::move(*projection);
    return made;
}

std::vector<FaceId> facesToBake(const ImportMapping& mapping, std::span<const FaceId> faces)
{
    if (!mapping.projection) {
        return {faces.begin(), faces.end()};
    }
    return facesInReach(*mapping.projection, mapping.surface->mesh(), faces, Threads::all());
}

} // namespace trixel::ui
