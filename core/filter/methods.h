// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the table, one file each.
#pragma once

#include "core/filter/filter_method.h"

namespace trixel {

MethodEntry pointMethod();
MethodEntry nearestLevelMethod();
MethodEntry rectilinearBilinearMethod();
MethodEntry latticeLinearMethod();
MethodEntry trilinearMethod();
MethodEntry probesOneLevelMethod();
MethodEntry probesTwoLevelsMethod();
MethodEntry equalProbesMethod();
MethodEntry stochasticMethod();
MethodEntry separableMethod();
MethodEntry referenceLoopMethod();
MethodEntry ewaMethod();
MethodEntry ewaBlendedMethod();
MethodEntry ewaBaseMethod();
MethodEntry exactMethod();

} // namespace trixel
