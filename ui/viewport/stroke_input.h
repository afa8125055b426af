// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/bvh.h"
#include "core/paint/brush.h"
#include "ui/document/document.h"

#include <glm/vec2.hpp>
#include <memory>
#include <optional>

namespace trixel {
class LimitMesh;
}

namespace trixel::ui {

/// Where mouse or pen was, and how hard it pressed.
struct PointerSample
{
    glm::dvec2 position{0}; ///< device pixels
    float pressure = 1.0F;  ///< [0,1]; 1 for a mouse
    double time = 0;        ///< seconds, from any start
};

/// Passes what the pointer does on to the document as a stroke.
class StrokeInput
{
public:
    explicit StrokeInput(Document& document)
        : m_document(document)
    {
    }

    /// \param limit  to paint on instead of the cage
    void begin(const Brush& brush,
               double time,
               StrokePace pace = StrokePace::AtOnce,
               std::shared_ptr<const LimitMesh> limit = {});
    /// \param hit            what the pointer is over, if anything
    /// \param worldPerPixel  length of a device pixel there
    void
    add(const std::optional<SurfacePoint>& hit, const PointerSample& sample, double worldPerPixel);
    void end();
    void cancel();

    bool isActive() const { return m_active; }
    /// Where the last stroke ended: a straight line starts there.
    const std::optional<SurfacePoint>& lastPoint() const { return m_last; }
    void forgetLastPoint() { m_last.reset(); }

private:
    bool jumped(const SurfacePoint& to, glm::dvec2 position, double worldPerPixel) const;

    Document& m_document;
    Brush m_brush;
    bool m_active = false;
    bool m_hasSamples = false; ///< this stroke has met the surface
    bool m_onSurface = false;  ///< the last sample did
    double m_startTime = 0;
    glm::dvec2 m_lastPosition{0};
    std::optional<SurfacePoint> m_last;
};

} // namespace trixel::ui
