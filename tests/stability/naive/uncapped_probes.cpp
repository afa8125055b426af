// SPDX-License-Identifier: GPL-3.0-or-later
//
// As many probes as the ellipse is long, up to what there is room for.
#include "core/filter/probe_plan.h"

// The shipped cap under another name.
#define probeCap shippedCap
#include "core/filter/probe_plan.cpp"
#undef probeCap

namespace trixel {

ProbeCap probeCap(const ProbeSettings& settings)
{
    ProbeSettings uncapped = settings;
    uncapped.most = 1000;
    return shippedCap(uncapped);
}

} // namespace trixel
