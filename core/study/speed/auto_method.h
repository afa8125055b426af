// SPDX-License-Identifier: GPL-3.0-or-later
//
// Given a tolerance, the fastest method that meets it, for each class of footprint.
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/filter/filter_method.h"
#include "core/study/footprint_class.h"
#include "core/study/speed/cost_table.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace trixel {

/// What each class of footprint is filtered with; by FootprintClass.
struct AutoChoices
{
    double tolerance = 0; ///< RMS error, fraction of the value range
    std::array<CostEntry, kFootprintClasses> classes;
};

/// The cheapest entry of each class whose measured RMS is within the tolerance; of equally cheap
/// ones the more accurate.
/// \param tolerance  above 0
/// Errors name the class that no method of the table serves and how near the best comes.
Result<AutoChoices> chooseMethods(const CostTable& table, double tolerance);

/// One line a class: its method, cost and error.
std::string toText(const AutoChoices& choices);

/// Sorts every batch by class and has each class answered by its method.
class AutoMethod final : public FilterMethod
{
public:
    explicit AutoMethod(const AutoChoices& choices);
    ~AutoMethod() override;

    const AutoChoices& choices() const { return m_choices; }

    /// The method that answers a query.
    const MethodChoice&
    choiceFor(const FilterScene& scene, const FilterQueries& queries, std::size_t index) const;

    void filter(const FilterScene& scene,
                const FilterQueries& queries,
                const FilterResults& results) const override;

private:
    class Chunk;

    AutoChoices m_choices;
    std::vector<std::unique_ptr<const FilterMethod>> m_methods;    // each once
    std::array<std::uint8_t, kFootprintClasses> m_methodOfClass{}; // position in m_methods
};

/// The method for a tolerance by the table of this machine, which is measured (a few seconds) where
/// none is kept. Fails when no method of a class is good enough, or when cancelled.
Result<std::unique_ptr<AutoMethod>> makeAuto(double tolerance, Progress& progress);

} // namespace trixel
