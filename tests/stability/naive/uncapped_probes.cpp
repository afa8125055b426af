// SPDX-License-Identifier: GPL-3.0-or-later
//
// As many probes as the ellipse is long, however long.
#include "core/filter/probe_plan.h"

// The shipped plan under another name.
#define probePlan cappedPlan
#include "core/filter/probe_plan.cpp"
#undef probePlan

namespace trixel {

ProbePlan
probePlan(const QueryEllipse& ellipse, const FaceShape& shape, const ProbeSettings& settings)
{
    ProbeSettings uncapped = settings;
    uncapped.most = 1 << 13;
    return cappedPlan(ellipse, shape, uncapped);
}

} // namespace trixel
