// SPDX-License-Identifier: GPL-3.0-or-later
//
// The table of filter methods: one interface, so that they can be exchanged, timed and judged.
#pragma once

#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/filter/filter_queries.h"
#include "core/filter/filter_scene.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trixel {

/// Most taps a query may cost, but for the exact and the base-level methods, which refuse beyond a
/// cap of their own.
inline constexpr std::uint32_t kMostTaps = 4096;

/// A filter with its parameter set. Const calls may come from several threads; no call allocates
/// for a query.
class FilterMethod
{
public:
    virtual ~FilterMethod() = default;

    /// Answers every query. Non-finite u or v give the face's average; a NaN comes out only where a
    /// NaN texel lies under the footprint.
    /// \param results  room for all (checked)
    virtual void filter(const FilterScene& scene,
                        const FilterQueries& queries,
                        const FilterResults& results) const = 0;
};

/// Whether a property holds for a method.
enum class Claim { No, Yes, InTheMean };

/// What a method promises, each tested; the columns of the property table.
struct MethodClaims
{
    Claim constantKept = Claim::Yes;
    Claim affineKept = Claim::No;      ///< at the centre, within 1e-5
    Claim rotationFree = Claim::No;    ///< the order of a face's vertices changes nothing: 1e-6
    Claim edgeContinuous = Claim::No;  ///< same value from both sides of an edge: 1e-5
    Claim footprintFree = Claim::Yes;  ///< (W1, W2) swapped, negated, rotated: same, 1e-5
    /// No popping when the width changes: 0.02 % change nothing by more than 1e-3, but for a face
    /// behind a vertex that is not flat (unfolding.h).
    Claim levelContinuous = Claim::No;
};

/// The one number that trades speed for accuracy.
struct MethodParameter
{
    std::string_view name;    ///< e.g. "probes"
    std::string_view meaning; ///< one sentence
    double least = 1;
    double most = 1;
    double standard = 1;
    std::vector<double> curve; ///< values that the chart measures, ascending
    bool whole = false;        ///< whether it counts something, so that fractions are refused
};

struct MethodEntry
{
    std::string_view name;  ///< as the command line takes it, e.g. "nearest-level"
    std::string_view title; ///< as people read it
    std::string_view about; ///< one sentence
    MethodClaims claims;
    std::optional<MethodParameter> parameter;
    /// \param parameter  within its bounds (checked); ignored where there is none
    std::unique_ptr<const FilterMethod> (*make)(double parameter) = nullptr;
};

/// Every method, cheapest kind first, `exact` last.
std::span<const MethodEntry> filterMethods();
/// Null when there is none of that name.
const MethodEntry* findMethod(std::string_view name);

/// A method and its parameter: "probes-1:16", or "probes-1" for the standard.
struct MethodChoice
{
    std::string name = "probes-2";
    std::optional<double> parameter;

    bool operator==(const MethodChoice&) const = default;
};

/// Errors name the methods there are, or the parameter's bounds.
Result<MethodChoice> parseMethod(std::string_view text);
std::string toText(const MethodChoice& choice);
/// \param choice  of an existing method, its parameter within bounds (checked)
std::unique_ptr<const FilterMethod> makeMethod(const MethodChoice& choice);

/// The same as method.filter, by several threads.
void filterParallel(const FilterMethod& method,
                    const FilterScene& scene,
                    const FilterQueries& queries,
                    const FilterResults& results,
                    Threads threads);

} // namespace trixel
