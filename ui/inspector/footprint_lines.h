// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/footprint_net.h"
#include "render/overlay_pass.h"
#include "ui/inspector/footprint_probe.h"
#include "ui/viewport/seen_surface.h"

#include <span>
#include <vector>

namespace trixel::ui {

/// A line of the net, laid onto the surface piece by piece: from face to face as the net goes.
/// Where the line leaves the net it is left out.
std::vector<render::Polyline> onSurface(const FootprintNet& net,
                                        const SeenSurface& surface,
                                        std::span<const glm::dvec2> line,
                                        glm::vec4 color,
                                        float width);

/// Which footprint lines are for.
enum class FootprintRole { Live, Frozen };

/// Parallelogram, ellipse and both vectors of a footprint on the surface.
/// \param net      of the footprint, reaching as far as its lines do
/// \param widened  the ellipse that filters take, not that of the vectors alone
std::vector<render::Polyline> footprintOnSurface(const FootprintNet& net,
                                                 const SeenSurface& surface,
                                                 FootprintRole role,
                                                 bool widened);

/// Outlines of the heaviest texels in the colours of their weights.
std::vector<render::Polyline>
weightsOnSurface(const SeenSurface& surface, const Contributions& weights, std::size_t most = 256);

/// What is drawn of footprints on the surface; null is left out.
struct FootprintMarks
{
    const ProbedFootprint* live = nullptr;
    const ProbedFootprint* frozen = nullptr;
    const Contributions* weights = nullptr; ///< of the live one
    bool enlarged = true;                   ///< those of pixels, which are a pixel large
};

/// How many times larger the footprint of a pixel is drawn on the surface.
inline constexpr double kFootprintEnlarged = 40.0;
double magnificationOf(const ProbedFootprint& probed, bool enlarged);

std::vector<render::Polyline>
marksOnSurface(const SeenSurface& surface, const TexelStore& texels, const FootprintMarks& marks);

} // namespace trixel::ui
