// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/paint/stroke_dabs.h"

#include "core/base/check.h"
#include "core/mesh/triangle_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace trixel {

namespace {

float cleanPressure(float pressure)
{
    return pressure > 0.0F ? std::min(pressure, 1.0F) : 0.0F; // NaN counts as none
}

bool isFinite(glm::vec3 v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

std::shared_ptr<const Surface> present(std::shared_ptr<const Surface> surface)
{
    check(surface != nullptr, "a surface to paint on");
    return surface;
}

} // namespace

StrokeDabs::StrokeDabs(std::shared_ptr<const Surface> surface,
                       const Brush& brush,
                       std::shared_ptr<const LimitMesh> limit)
    : m_surface(present(std::move(surface)))
    , m_limit(std::move(limit))
    , m_brush(brush)
    , m_path(brush)
    , m_reach(m_surface, brush.paintThrough, m_limit)
{
    check(validate(brush).has_value(), "a valid brush");
    check(!m_limit || m_limit->surface().faceCount() == m_surface->mesh().faceCount(),
          "the limit of this surface");
}

glm::vec3 StrokeDabs::positionOf(FaceId face, glm::vec2 uv) const
{
    return m_limit ? glm::vec3(m_limit->surface().at(face, glm::dvec2(uv)).position)
                   : pointAt(mesh().corners(face), uv.x, uv.y);
}

glm::vec3 StrokeDabs::limitNormal(FaceId face, glm::vec2 uv) const
{
    const glm::dvec3 normal = m_limit->surface().at(face, glm::dvec2(uv)).normal();
    return m_reach.turned(face, glm::vec3(normal));
}

void StrokeDabs::add(const StrokeSample& sample, const Place& place)
{
    const bool usable = indexOf(sample.face) < mesh().faceCount() && std::isfinite(sample.uv.x) &&
                        std::isfinite(sample.uv.y);
    if (!usable) {
        return;
    }
    const glm::vec2 uv = insideTriangle(sample.uv);
    const glm::vec3 position = positionOf(sample.face, uv);
    if (!isFinite(position)) {
        return;
    }
    m_path.moveTo(position, cleanPressure(sample.pressure), [&](const StrokePath::Point& point) {
        placeDab(sample, point, place);
    });
}

void StrokeDabs::placeDab(const StrokeSample& sample,
                          const StrokePath::Point& point,
                          const Place& place)
{
    Dab dab;
    dab.radius = m_brush.radius * sizeAt(m_brush, point.pressure);
    dab.cap = m_brush.opacity * (m_brush.pressureToOpacity ? point.pressure : 1.0F);
    if (!(dab.radius > 0.0F) || !(dab.cap > 0.0F)) {
        return;
    }
    // Between samples the straight way leaves a curved surface: back onto it.
    FaceId face = sample.face;
    glm::vec2 uv = insideTriangle(sample.uv);
    dab.centre = point.position;
    if (!point.isSample) {
        constexpr float kAnywhere = std::numeric_limits<float>::infinity();
        const auto nearest = m_limit ? m_limit->closestPoint(point.position, kAnywhere)
                                     : m_surface->bvh().closestPoint(point.position, kAnywhere);
        if (!nearest) {
            return;
        }
        face = nearest->face;
        uv = nearest->uv;
        dab.centre = nearest->position;
    }
    dab.normal = m_limit ? limitNormal(face, uv) : m_reach.normalOf(face);
    m_reach.facesOf(dab, m_faces);
    place(dab, m_faces);
}

std::vector<float>
strokeTarget(const Brush& brush, const TexelFormat& format, std::span<const std::byte> fill)
{
    std::vector<float> value(format.channels);
    if (brush.blend == BlendMode::Erase) {
        check(fill.size() == format.texelBytes(), "a fill of one texel");
        decode(format.type, fill, value);
        return value;
    }
    for (std::size_t k = 0; k < value.size(); ++k) {
        value[k] = brush.color[std::min(k, brush.color.size() - 1)];
    }
    return value;
}

TexelBlend strokeBlend(const Brush& brush, const TexelFormat& format, const Ground& ground)
{
    if (!ground.isLayer()) {
        return {format, strokeTarget(brush, format, ground.fill())};
    }
    check(format.channels > 1 && format.alpha == format.channels - 1, "texels of a layer");
    if (brush.blend == BlendMode::Erase) {
        return {format, std::vector<float>(format.channels), TexelMix::Uncover};
    }
    std::vector<float> value = strokeTarget(brush, format, {});
    value.back() = 1.0F; // covered
    return {format, value, TexelMix::Over};
}

} // namespace trixel
