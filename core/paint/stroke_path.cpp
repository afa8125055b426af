// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/paint/stroke_path.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace trixel {

namespace {

/// Dabs of hardly any pressure keep this part of the full distance, so that they stay countable.
constexpr float kLeastSpacing = 0.05F;

} // namespace

float sizeAt(const Brush& brush, float pressure)
{
    return brush.pressureToSize ? pressure : 1.0F;
}

StrokePath::StrokePath(const Brush& brush)
    : m_spacing(2.0 * brush.spacing * brush.radius)
    , m_pressureToSize(brush.pressureToSize)
{
}

double StrokePath::spacingAt(float pressure) const
{
    return m_pressureToSize ? m_spacing * std::max(pressure, kLeastSpacing) : m_spacing;
}

void StrokePath::moveTo(glm::vec3 position,
                        float pressure,
                        const std::function<void(const Point&)>& place)
{
    if (!m_started) {
        m_started = true;
        place({position, pressure, true});
        m_untilNext = spacingAt(pressure);
    } else {
        const glm::dvec3 way = glm::dvec3(position) - m_last;
        const double length = glm::length(way);
        const double leastStep = length / kMaxDabs;
        while (m_untilNext <= length && length > 0) {
            const double part = m_untilNext / length;
            const auto mixed = static_cast<float>(
                m_lastPressure + part * (static_cast<double>(pressure) - m_lastPressure));
            place({glm::vec3(m_last + part * way), mixed, false});
            m_untilNext += std::max(spacingAt(mixed), leastStep);
        }
        m_untilNext -= length;
    }
    m_last = position;
    m_lastPressure = pressure;
}

} // namespace trixel
