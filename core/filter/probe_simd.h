// SPDX-License-Identifier: GPL-3.0-or-later
//
// The arithmetic of the probe methods, several queries or probes at a time, compiled for every
// instruction set of the machine's kind and chosen at run time.
#pragma once

#include "core/filter/filter_method.h"
#include "core/filter/probe_plan.h"

#include <cstdint>
#include <vector>

namespace trixel {

/// Answers every query; see `FilterMethod::filter`.
void filterByProbes(const FilterScene& scene,
                    const FilterQueries& queries,
                    const ProbeSettings& settings,
                    const FilterResults& results);

/// Instruction sets that this machine and this build have, as Highway numbers them.
std::vector<std::int64_t> probeTargets();
/// The same on one of them, for tests; not while other threads filter.
void filterByProbesOn(std::int64_t target,
                      const FilterScene& scene,
                      const FilterQueries& queries,
                      const ProbeSettings& settings,
                      const FilterResults& results);

} // namespace trixel
