// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/paint/stroke.h"

#include "core/base/check.h"
#include "core/mesh/triangle_geometry.h"
#include "core/paint/dab_painter.h"
#include "core/paint/dab_reach.h"
#include "core/paint/stroke_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
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

/// What the stroke moves texels towards, a number per channel.
std::vector<float>
targetOf(const Brush& brush, const TexelFormat& format, std::span<const std::byte> fill)
{
    std::vector<float> value(format.channels);
    if (brush.blend == BlendMode::Erase) {
        decode(format.type, fill, value);
        return value;
    }
    for (std::size_t k = 0; k < value.size(); ++k) {
        value[k] = brush.color[std::min(k, brush.color.size() - 1)];
    }
    return value;
}

} // namespace

class Stroke::State
{
public:
    State(std::shared_ptr<const Surface> surface,
          const Brush& brush,
          std::vector<std::byte> fill,
          Threads threads)
        : m_surface(std::move(surface))
        , m_brush(brush)
        , m_fill(std::move(fill))
        , m_threads(threads)
        , m_path(brush)
        , m_reach(m_surface, brush.paintThrough)
    {
    }

    std::vector<TouchedRect> add(const StrokeSample& sample, TexelStore& store)
    {
        const TriangleMesh& mesh = m_surface->mesh();
        check(store.faceCount() == mesh.faceCount(), "a store of the surface's faces");
        const bool usable = indexOf(sample.face) < mesh.faceCount() && std::isfinite(sample.uv.x) &&
                            std::isfinite(sample.uv.y);
        if (!usable) {
            return {};
        }
        const glm::vec2 uv = insideTriangle(sample.uv);
        const glm::vec3 position = pointAt(mesh.corners(sample.face), uv.x, uv.y);
        if (!isFinite(position)) {
            return {};
        }
        m_path.moveTo(position,
                      cleanPressure(sample.pressure),
                      [&](const StrokePath::Point& point) { placeDab(sample, point, store); });
        return m_painter ? m_painter->takeTouched() : std::vector<TouchedRect>();
    }

    void lift() { m_path.lift(); }

    TexelPatch finish(TexelStore& store)
    {
        if (!m_painter) {
            return {};
        }
        TexelPatch patch = m_painter->finish(store);
        patch.collapseFaces(store);
        return patch;
    }

private:
    void placeDab(const StrokeSample& sample, const StrokePath::Point& point, TexelStore& store)
    {
        Dab dab;
        dab.radius = m_brush.radius * sizeAt(m_brush, point.pressure);
        dab.cap = m_brush.opacity * (m_brush.pressureToOpacity ? point.pressure : 1.0F);
        if (!(dab.radius > 0.0F) || !(dab.cap > 0.0F)) {
            return;
        }
        // Between samples the straight way leaves a curved surface: back onto it.
        FaceId face = sample.face;
        dab.centre = point.position;
        if (!point.isSample) {
            const auto nearest = m_surface->bvh().closestPoint(
                point.position, std::numeric_limits<float>::infinity());
            if (!nearest) {
                return;
            }
            face = nearest->face;
            dab.centre = nearest->position;
        }
        dab.normal = m_reach.normalOf(face);
        m_reach.facesOf(dab, m_faces);
        painterFor(store).paint(dab, m_surface->mesh(), m_faces, store);
    }

    DabPainter& painterFor(const TexelStore& store)
    {
        if (!m_painter) {
            check(m_fill.size() == store.format().texelBytes(), "a fill of one texel");
            m_painter.emplace(store.format(),
                              targetOf(m_brush, store.format(), m_fill),
                              m_brush.hardness,
                              m_brush.flow,
                              m_threads);
        }
        return *m_painter;
    }

    std::shared_ptr<const Surface> m_surface;
    Brush m_brush;
    std::vector<std::byte> m_fill;
    Threads m_threads;
    StrokePath m_path;
    DabReach m_reach;
    std::optional<DabPainter> m_painter; ///< made for the format of the first store it sees
    std::vector<FaceId> m_faces;         ///< kept for its memory
};

Stroke::Stroke(std::shared_ptr<const Surface> surface,
               const Brush& brush,
               std::vector<std::byte> fill,
               Threads threads)
{
    check(surface != nullptr, "a surface to paint on");
    check(validate(brush).has_value(), "a valid brush");
    m_state = std::make_unique<State>(std::move(surface), brush, std::move(fill), threads);
}

Stroke::~Stroke() = default;
Stroke::Stroke(Stroke&&) noexcept = default;
Stroke& Stroke::operator=(Stroke&&) noexcept = default;

std::vector<TouchedRect> Stroke::add(const StrokeSample& sample, TexelStore& store)
{
    return m_state->add(sample, store);
}

void Stroke::lift()
{
    m_state->lift();
}

TexelPatch Stroke::finish(TexelStore& store)
{
    return m_state->finish(store);
}

} // namespace trixel
