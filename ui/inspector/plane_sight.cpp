// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/plane_sight.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace trixel::ui {

namespace {

/// Smaller than home there is nothing to see but room around it.
constexpr double kFarthest = 0.5;

} // namespace

PlaneBox PlaneBox::with(glm::dvec2 point) const
{
    return {glm::min(low, point), glm::max(high, point)};
}

void PlaneSight::setHome(const PlaneBox& box, double nearest)
{
    m_home = box;
    m_nearest = std::max(nearest, 1.0);
    if (m_isHome) {
        goHome();
    } else {
        keepNear();
    }
}

void PlaneSight::goHomeTo(const PlaneBox& box, double nearest)
{
    const double times = zoom();
    const bool wasHome = m_isHome || m_wasHome;
    m_home = box;
    m_nearest = std::max(nearest, 1.0);
    goHome();
    if (!wasHome) {
        leaveHome();
        m_scale *= times;
        keepNear();
    }
}

void PlaneSight::setView(glm::dvec2 topLeft, glm::dvec2 size)
{
    const double times = zoom();
    m_topLeft = topLeft;
    m_size = glm::max(size, glm::dvec2(1));
    if (m_isHome) {
        goHome();
    } else {
        m_scale = times * homeScale();
        keepNear();
    }
}

void PlaneSight::goHome()
{
    m_isHome = true;
    m_wasHome = false;
    m_scale = homeScale();
    m_centre = m_home.middle();
}

void PlaneSight::zoomBy(double factor, glm::dvec2 at)
{
    if (!(factor > 0) || !std::isfinite(factor)) {
        return;
    }
    const glm::dvec2 kept = toPlane(at);
    const double home = homeScale();
    const double scale =
        std::clamp(m_scale * factor, kFarthest * home, std::max(m_nearest, zoom()) * home);
    if (scale == m_scale) {
        return;
    }
    m_scale = scale;
    leaveHome();
    m_centre += kept - toPlane(at);
    keepNear();
}

void PlaneSight::panBy(glm::dvec2 inView)
{
    if (inView == glm::dvec2(0)) {
        return;
    }
    leaveHome();
    m_centre -= glm::dvec2(inView.x, -inView.y) / m_scale;
    keepNear();
}

bool PlaneSight::bringIntoSight(glm::dvec2 point, double margin)
{
    const glm::dvec2 there = toView(point);
    const glm::dvec2 room = glm::min(glm::dvec2(margin), 0.5 * m_size);
    const glm::dvec2 inside = glm::clamp(there, m_topLeft + room, m_topLeft + m_size - room);
    constexpr double kNothing = 1e-6;
    if (!(glm::length(inside - there) > kNothing)) {
        return false;
    }
    // What is far away comes to the middle: there is no way to follow with the eye.
    const glm::dvec2 beyond = glm::abs(inside - there);
    if (beyond.x > m_size.x || beyond.y > m_size.y) {
        centreOn(point);
    } else {
        panBy(inside - there);
    }
    return true;
}

void PlaneSight::centreOn(glm::dvec2 point)
{
    leaveHome();
    m_centre = point;
    keepNear();
}

PlaneMap PlaneSight::map() const
{
    PlaneMap map{{0, 0}, {m_scale, 0}, {0, -m_scale}};
    map.origin = middleOfView() - map.vector(m_centre);
    return map;
}

PlaneBox PlaneSight::visible() const
{
    const glm::dvec2 half = 0.5 * m_size / m_scale;
    return {m_centre - half, m_centre + half};
}

void PlaneSight::leaveHome()
{
    m_isHome = false;
    m_wasHome = false;
}

double PlaneSight::homeScale() const
{
    const glm::dvec2 box =
        glm::max(m_home.size(), glm::dvec2(std::numeric_limits<double>::min() * 1e10));
    return std::min(m_size.x / box.x, m_size.y / box.y);
}

/// Something of the home stays in sight.
void PlaneSight::keepNear()
{
    m_centre = glm::clamp(m_centre, m_home.low, m_home.high);
}

} // namespace trixel::ui
