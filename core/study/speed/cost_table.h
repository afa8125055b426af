// SPDX-License-Identifier: GPL-3.0-or-later
//
// What each method costs and how far off it is on this machine, kept between runs.
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/filter/filter_method.h"
#include "core/study/footprint_class.h"
#include "core/study/machine.h"
#include "core/study/study.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace trixel {

/// A method with its parameter on one class of footprints.
struct CostEntry
{
    MethodChoice method;
    FootprintClass footprintClass{};
    double cost = 0; ///< ns per sample
    double rms = 0;  ///< fraction of the value range
    double p99 = 0;  ///< fraction of the value range

    bool operator==(const CostEntry&) const = default;
};

struct CostTable
{
    Machine machine;
    /// Hash of the methods, their curves and the stored distribution.
    std::uint64_t contents = 0;
    std::vector<CostEntry> entries;

    bool operator==(const CostTable&) const = default;
};

/// The hash for this program; a table with another was measured on something else.
std::uint64_t costTableContents();

/// The study's points of single classes that name a method; those of a method that refused
/// footprints of the class are left out, because `auto` has to answer all, and so are those
/// measured partly, whose errors are not known well enough; but not `exact`, which has none.
CostTable costTableOf(const Study& study);

/// Measures the stored distribution: a few seconds. Fails only when cancelled.
Result<CostTable> measureCostTable(Progress& progress);

std::string toJson(const CostTable& table);
/// Strict: names that are no method, parameters out of bounds, numbers that are not finite or
/// negative and classes that do not exist are refused.
Result<CostTable> parseCostTable(std::string_view json);

/// $XDG_CACHE_HOME/trixel/filter-costs.json, under ~/.cache where the variable is not an absolute
/// path; empty where there is no home either.
std::filesystem::path costTablePath();

/// Whether a table was read, and if not, why it was measured.
struct FoundCostTable
{
    CostTable table;
    bool measured = false;
    std::string why; ///< "there was none", "it was made on another machine", …; empty if read
};

/// The table kept at `path` if it was measured on this machine by this program; otherwise it is
/// measured and kept there, whole or not at all. A path that cannot be read or written is no error.
/// \param path  empty: neither read nor kept
/// \param measure  how it is measured; `measureCostTable` but in tests
/// Fails only when cancelled.
Result<FoundCostTable>
findCostTable(const std::filesystem::path& path,
              Progress& progress,
              const std::function<Result<CostTable>(Progress&)>& measure = measureCostTable);

} // namespace trixel
