// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lattice/face_layout.h"

#include <glm/vec2.hpp>

namespace trixel::ui {

/// A rectangle of the plane.
struct PlaneBox
{
    glm::dvec2 low{0, 0};
    glm::dvec2 high{1, 1};

    glm::dvec2 middle() const { return 0.5 * (low + high); }
    glm::dvec2 size() const { return high - low; }
    /// The least one that holds this and a point.
    PlaneBox with(glm::dvec2 point) const;
    bool operator==(const PlaneBox&) const = default;
};

/// What a view shows of a plane, by pan and zoom. The plane's y runs upwards, the view's down.
/// Until something is moved the view shows all of its `home`, however large it is.
class PlaneSight
{
public:
    /// What there is to see, and how near one may go. A view at home stays there.
    /// \param nearest  most that `zoom` can be, at least 1
    void setHome(const PlaneBox& box, double nearest);
    /// The same for something else that takes the place of what is seen: it is shown as large, and
    /// at home if this was; whoever has a point to look at brings it into sight.
    void goHomeTo(const PlaneBox& box, double nearest);
    /// Of the view's part that the plane is drawn in, in its own units. \param size  more than 0
    void setView(glm::dvec2 topLeft, glm::dvec2 size);

    bool isHome() const { return m_isHome; }
    /// Keeps what the view shows while the home changes; `goHomeTo` still counts it as at home.
    void stay()
    {
        m_wasHome = m_wasHome || m_isHome;
        m_isHome = false;
    }
    void goHome();
    /// Times as large as at home.
    double zoom() const { return m_scale / homeScale(); }
    /// View units a unit of the plane.
    double scale() const { return m_scale; }

    /// \param factor  over 1 goes nearer
    /// \param at      point of the view that keeps showing what it shows
    void zoomBy(double factor, glm::dvec2 at);
    /// So that a unit of the plane becomes so many of the view.
    void setScale(double scale, glm::dvec2 at) { zoomBy(scale / m_scale, at); }
    void panBy(glm::dvec2 inView);
    /// Moves no more than it takes to have the point inside the view, a margin from its rim.
    /// \return  whether it moved
    bool bringIntoSight(glm::dvec2 point, double margin);
    void centreOn(glm::dvec2 point);

    glm::dvec2 middleOfView() const { return m_topLeft + 0.5 * m_size; }
    /// From the plane to the view.
    PlaneMap map() const;
    glm::dvec2 toView(glm::dvec2 point) const { return map().point(point); }
    glm::dvec2 toPlane(glm::dvec2 inView) const { return map().inverse().point(inView); }
    /// What the view shows.
    PlaneBox visible() const;

    bool operator==(const PlaneSight&) const = default;

private:
    double homeScale() const;
    void leaveHome();
    void keepNear();

    PlaneBox m_home;
    double m_nearest = 1;
    glm::dvec2 m_topLeft{0, 0};
    glm::dvec2 m_size{1, 1};
    glm::dvec2 m_centre{0.5, 0.5}; ///< the plane's point in the middle of the view
    double m_scale = 1;
    bool m_isHome = true;
    bool m_wasHome = false; ///< and nobody moved anything since
};

} // namespace trixel::ui
