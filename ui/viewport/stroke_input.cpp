// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/stroke_input.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

namespace trixel::ui {

namespace {

/// On a steep surface a pixel spans more than one that faces the eye, but hardly more than this.
constexpr double kSteepest = 8.0;
/// A step this long, in radii, is bridged in any case.
constexpr double kAlwaysBridged = 2.0;

} // namespace

void StrokeInput::begin(const Brush& brush,
                        double time,
                        StrokePace pace,
                        std::shared_ptr<const LimitMesh> limit)
{
    m_brush = brush;
    m_startTime = time;
    m_onSurface = false;
    m_hasSamples = false;
    m_document.beginStroke(brush, pace, std::move(limit));
    m_active = m_document.isTakingSamples();
}

/// Whether the pointer came to another part of the surface (over a silhouette, or from outside),
/// where a bridge of dabs through the air would be wrong.
bool StrokeInput::jumped(const SurfacePoint& to, glm::dvec2 position, double worldPerPixel) const
{
    const double distance = glm::length(glm::dvec3(to.position) - glm::dvec3(m_last->position));
    const double seen =
        m_onSurface ? kSteepest * worldPerPixel * glm::length(position - m_lastPosition) : 0.0;
    return distance > kAlwaysBridged * m_brush.radius + seen;
}

void StrokeInput::add(const std::optional<SurfacePoint>& hit,
                      const PointerSample& sample,
                      double worldPerPixel)
{
    if (!m_active || !m_document.isTakingSamples()) {
        m_active = false; // taken back meanwhile, by an undo for instance
        return;
    }
    if (!hit) {
        m_onSurface = false;
        return;
    }
    if (m_hasSamples && jumped(*hit, sample.position, worldPerPixel)) {
        m_document.liftStroke();
    }
    m_document.extendStroke(
        {hit->face, hit->uv, sample.pressure, std::max(sample.time - m_startTime, 0.0)});
    m_onSurface = true;
    m_hasSamples = true;
    m_lastPosition = sample.position;
    m_last = hit;
}

void StrokeInput::end()
{
    if (m_active) {
        m_active = false;
        m_document.endStroke();
    }
}

void StrokeInput::cancel()
{
    if (m_active) {
        m_active = false;
        m_document.cancelStroke();
    }
}

} // namespace trixel::ui
