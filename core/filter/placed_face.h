// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ids.h"
#include "core/filter/query_ellipse.h"

#include <array>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace trixel {

/// The ellipse of a query as the unit circle: offsets from the centre, in standard deviations along
/// its major and minor axis.
class EllipseFrame
{
public:
    explicit EllipseFrame(const QueryEllipse& ellipse)
        : EllipseFrame(ellipse.majorAxis, ellipse.majorSigma, ellipse.minorSigma)
    {
    }
    /// \param majorAxis  of unit length
    /// \param majorSigma, minorSigma  positive
    EllipseFrame(glm::dvec2 majorAxis, double majorSigma, double minorSigma)
        : m_major(majorAxis / majorSigma)
        , m_minor(glm::dvec2(-majorAxis.y, majorAxis.x) / minorSigma)
        , m_perMajor(majorAxis * majorSigma)
        , m_perMinor(glm::dvec2(-majorAxis.y, majorAxis.x) * minorSigma)
    {
    }

    /// Length 1 is one standard deviation. Turns left where the plane does.
    glm::dvec2 toUnit(glm::dvec2 offset) const
    {
        return {glm::dot(m_major, offset), glm::dot(m_minor, offset)};
    }
    glm::dvec2 toPlane(glm::dvec2 unit) const { return unit.x * m_perMajor + unit.y * m_perMinor; }

private:
    glm::dvec2 m_major, m_minor;
    glm::dvec2 m_perMajor, m_perMinor;
};

/// A face laid into the plane of the hit face, in the frame of the ellipse: the query's centre at
/// the origin, lengths in standard deviations. Turns left.
struct PlacedFace
{
    FaceId face{};
    std::array<glm::dvec2, 3> corners{};

    glm::dvec2 origin() const { return corners[0]; }
    glm::dvec2 e1() const { return corners[1] - corners[0]; } ///< what one u makes
    glm::dvec2 e2() const { return corners[2] - corners[0]; } ///< what one v makes
    /// Twice the area.
    double doubleArea() const { return e1().x * e2().y - e1().y * e2().x; }
};

} // namespace trixel
