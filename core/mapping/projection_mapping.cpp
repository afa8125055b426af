// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/check.h"
#include "core/footprint/chain_rule.h"
#include "core/footprint/svd2.h"
#include "core/mapping/projection.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace trixel {

namespace {

/// A place in the plane and how it changes with the face's (u,v).
struct PlanePlace
{
    glm::dvec2 xy{0};
    TextureDerivatives per;
};

double cross(glm::dvec2 a, glm::dvec2 b)
{
    return differenceOfProducts(a.x, b.y, a.y, b.x);
}

/// Nothing behind the eye.
std::optional<PlanePlace>
planePlace(const glm::dmat4& toPlane, const std::array<glm::vec3, 3>& corners, glm::dvec2 uv)
{
    const glm::dvec3 origin(corners[0]);
    const glm::dvec4 perU = toPlane * glm::dvec4(glm::dvec3(corners[1]) - origin, 0);
    const glm::dvec4 perV = toPlane * glm::dvec4(glm::dvec3(corners[2]) - origin, 0);
    const glm::dvec4 at = toPlane * glm::dvec4(origin, 1) + uv.x * perU + uv.y * perV;
    if (!(at.w > 0)) {
        return std::nullopt;
    }
    const glm::dvec2 xy = glm::dvec2(at) / at.w;
    return PlanePlace{
        xy, {(glm::dvec2(perU) - xy * perU.w) / at.w, (glm::dvec2(perV) - xy * perV.w) / at.w}};
}

bool isInside(glm::dvec2 st)
{
    return st.x >= 0 && st.x <= 1 && st.y >= 0 && st.y <= 1;
}

/// The change of (s,t) for a change of the place in the plane: the inverse of the bilinear map's
/// derivative.
glm::dvec2 throughQuad(const Quad& quad, glm::dvec2 st, glm::dvec2 change)
{
    const glm::dvec2 d = (quad.p11 - quad.p01) - (quad.p10 - quad.p00);
    const glm::dvec2 perS = (quad.p10 - quad.p00) + st.y * d;
    const glm::dvec2 perT = (quad.p01 - quad.p00) + st.x * d;
    const double area = cross(perS, perT);
    return glm::dvec2(cross(change, perT), cross(perS, change)) / area;
}

} // namespace

ProjectionMapping::ProjectionMapping(const TriangleMesh& mesh,
                                     const Projection& projection,
                                     const Bvh* bvh)
    : m_mesh(mesh)
    , m_projection(projection)
    , m_bvh(bvh)
{
    check(!projection.visibleOnly || bvh != nullptr, "a hierarchy to see by");
    glm::vec3 low(INFINITY);
    glm::vec3 high(-INFINITY);
    for (const glm::vec3& position : mesh.positions) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    m_size = mesh.positions.empty() ? 1.0 : glm::length(glm::dvec3(high) - glm::dvec3(low));
}

bool ProjectionMapping::isSeen(FaceId face, const glm::dvec3& point) const
{
    const glm::dvec4& eye = m_projection.eye;
    const glm::dvec3 from = eye.w > 0 ? glm::dvec3(eye) : point + 2 * m_size * glm::dvec3(eye);
    const glm::dvec3 way = point - from;
    const auto hit = m_bvh->raycast({glm::vec3(from), glm::vec3(way)});
    if (!hit || hit->face == face) {
        return true;
    }
    // Neighbours meet the ray where the face does, but for rounding.
    constexpr double kRounding = 1e-4;
    return glm::length(glm::dvec3(hit->position) - point) < kRounding * m_size;
}

ImagePlace ProjectionMapping::at(FaceId face, glm::dvec2 uv, double step) const
{
    const auto corners = m_mesh.corners(face);
    const auto place = planePlace(m_projection.toPlane, corners, uv);
    if (!place || (m_projection.frontOnly && !(cross(place->per.perU, place->per.perV) > 0))) {
        return {};
    }
    ImagePlace image{true, place->xy, {}};
    TextureDerivatives map = place->per;
    if (!m_projection.isRectangle) {
        const auto st = inverseBilinear(m_projection.corners, place->xy);
        if (!st) {
            return {};
        }
        image.st = *st;
        map = {throughQuad(m_projection.corners, *st, place->per.perU),
               throughQuad(m_projection.corners, *st, place->per.perV)};
    }
    if (!isInside(image.st)) {
        return {};
    }
    if (m_projection.visibleOnly) {
        const glm::dvec3 origin(corners[0]);
        const glm::dvec3 point = origin + uv.x * (glm::dvec3(corners[1]) - origin) +
                                 uv.y * (glm::dvec3(corners[2]) - origin);
        if (!isSeen(face, point)) {
            return {};
        }
    }
    image.footprint = chained({{step, 0}, {0, step}}, map);
    return image;
}

} // namespace trixel
