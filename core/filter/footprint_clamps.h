// SPDX-License-Identifier: GPL-3.0-or-later
//
// What had to be brought into bounds before a footprint could be filtered.
#pragma once

#include "core/filter/footprint_net.h"

#include <vector>

namespace trixel {

struct FootprintClamp
{
    enum class Kind {
        NotFinite,      ///< a vector was no number: the widest footprint stands in for it
        Shortened,      ///< a vector was longer than filters take; edges of the face
        Grazing,        ///< the view is so grazing that the length was limited; edges of the face
        CentreMoved,    ///< the centre lay outside its face; how far, in (u,v)
        Widened,        ///< narrower than a texel: the minor half axis, in texels
        FinestLevel,    ///< a finer level than the face has was asked for
        CoarsestLevel,  ///< a coarser one than a single texel
        MethodWidened,  ///< the weights are wider across than asked for; minor half axes, in texels
        MethodShortened ///< and shorter along it; major half axes, in texels
    };

    Kind kind{};
    double asked = 0;
    double used = 0;
};

/// Those that applied, in that order. Texels are those of the footprint's place
/// (`QueryEllipse::log2Texel`).
/// \param fromScreen  whether the footprint is a pixel's, limited to `kGrazingLimit`
/// \param weights     of the method, where they are known: what its own caps do is seen by them.
/// Axes that change by less than a tenth are not told.
std::vector<FootprintClamp> clampsOf(const PlacedFootprint& footprint,
                                     const FootprintNet& net,
                                     bool fromScreen,
                                     const std::optional<WeightEllipse>& weights = std::nullopt);

/// The longest axis of a footprint from the screen, in edges (`footprintOf`).
inline constexpr double kGrazingLimit = 64.0;

} // namespace trixel
