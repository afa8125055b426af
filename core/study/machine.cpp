// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/machine.h"

#include <fstream>
#include <hwy/targets.h>

namespace trixel {
namespace {

std::string processorModel()
{
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) {
            return line.substr(colon + 2);
        }
    }
    return "unknown";
}

/// Targets are bits, better ones lower.
std::string widestTarget()
{
    const auto targets = hwy::SupportedTargets();
    return hwy::TargetName(targets & -targets);
}

} // namespace

Machine thisMachine()
{
    return {processorModel(), widestTarget(), TRIXEL_VERSION};
}

std::string toText(const Machine& machine)
{
    return machine.processor + ", " + machine.simd + ", Trixel " + machine.version;
}

} // namespace trixel
