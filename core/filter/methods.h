// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the table, one file each.
#pragma once

#include "core/filter/filter_method.h"

namespace trixel {

MethodEntry pointMethod();
MethodEntry nearestLevelMethod();
MethodEntry rectilinearBilinearMethod();
MethodEntry trilinearMethod();
MethodEntry latticeLinearMethod();
MethodEntry probesOneLevelMethod();
MethodEntry probesTwoLevelsMethod();
MethodEntry referenceLoopMethod();
MethodEntry separableMethod();
MethodEntry equalProbesMethod();
MethodEntry stochasticMethod();
MethodEntry ewaMethod();
MethodEntry ewaBlendedMethod();
MethodEntry ewaBaseMethod();
MethodEntry exactMethod();

} // namespace trixel
