// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/probe_plan.h"

namespace trixel {

ProbeCap probeCap(const ProbeSettings& settings)
{
    // The support is (most + 1)/2 steps of spacing * sigma at most.
    const double ratio = 2 * kProbeSupport / (settings.spacing * (settings.most + 1));
    return {ratio * ratio / (1 + ratio * ratio), 2.0 / (settings.most + 1)};
}

} // namespace trixel
