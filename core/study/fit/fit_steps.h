// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a fit chooses: how many levels each face gives up.
#pragma once

#include "core/study/fit/fit_source.h"

namespace trixel {

/// Of a judged face the levels it gives up. Of a face of the rim the levels that it gives up beyond
/// the judged face that reaches it and gives up fewest: it changes how finely `exact` looks there,
/// and nothing else. Others go to level 0 whatever is said.
using FitSteps = FaceMap<int>;

/// As many for all judged faces and as many for the whole rim.
FitSteps evenSteps(const FitSource& source, int judged, int rim);

FaceMap<Level> levelsAfter(const FitSource& source, const FitSteps& steps);

/// Texels of all faces at those levels.
std::uint64_t texelsAfter(const FitSource& source, const FitSteps& steps);

} // namespace trixel
