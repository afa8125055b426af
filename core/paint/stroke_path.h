// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/paint/brush.h"
#include "core/paint/stroke.h"

#include <functional>
#include <glm/vec3.hpp>
#include <optional>

namespace trixel {

/// Turns samples into places for dabs: one at the first sample, then one whenever the path through
/// the samples has grown by `spacing` times the diameter of the dab before. Only the path counts,
/// not how many samples drew it or when.
class StrokePath
{
public:
    /// Where a dab belongs.
    struct Point
    {
        glm::vec3 position{0}; ///< on the straight line between two samples
        float pressure = 1;    ///< [0,1], linear between samples
        bool isSample = false; ///< the first sample itself
    };

    explicit StrokePath(const Brush& brush);

    /// Follows the path to the next sample and calls `place` for each dab it completes. At most
    /// kMaxDabs are placed on the way between two samples: beyond that they move apart evenly.
    /// \param position  finite
    /// \param pressure  [0,1]
    void moveTo(glm::vec3 position, float pressure, const std::function<void(const Point&)>& place);

    /// The next sample starts afresh, as the first did: nothing is placed on the way to it.
    void lift() { m_started = false; }

    static constexpr int kMaxDabs = 20'000;

private:
    double spacingAt(float pressure) const;

    double m_spacing; ///< world units at full pressure
    bool m_pressureToSize;
    bool m_started = false;
    glm::dvec3 m_last{0};
    float m_lastPressure = 1;
    double m_untilNext = 0; ///< path length from the last sample to the next dab
};

/// Radius of a dab as a part of the brush's: the pressure where that sets the size.
float sizeAt(const Brush& brush, float pressure);

} // namespace trixel
