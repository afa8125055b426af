// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/speed/auto_contestants.h"

#include "core/study/speed/auto_method.h"
#include "core/study/speed/prepared_filter.h"

#include <algorithm>
#include <array>
#include <sstream>

namespace trixel {
namespace {

constexpr std::array<double, 7> kTolerances = {0.1, 0.05, 0.02, 0.01, 0.007, 0.005, 0.002};

class AutoContestant final : public Contestant
{
public:
    AutoContestant(const AutoChoices& choices,
                   std::string variant,
                   const std::vector<StudySubject>& subjects)
        : Contestant("auto", std::move(variant), std::nullopt)
        , m_method(choices)
        , m_subjects(subjects)
    {
    }

    std::unique_ptr<PreparedQueries> prepare(std::size_t subject,
                                             const FilterQueries& queries) const override
    {
        return std::make_unique<PreparedFilter<AutoMethod>>(
            m_method, *m_subjects[subject].scene, queries);
    }

private:
    AutoMethod m_method;
    const std::vector<StudySubject>& m_subjects;
};

/// Classes that do not occur need a method all the same.
void fillAbsentClasses(CostTable& table)
{
    for (const FootprintClass footprintClass : footprintClasses()) {
        if (std::ranges::find(table.entries, footprintClass, &CostEntry::footprintClass) ==
            table.entries.end()) {
            table.entries.push_back({MethodChoice{}, footprintClass, 0, 0, 0});
        }
    }
}

} // namespace

Contestants autoContestants(const Study& measured, const std::vector<StudySubject>& subjects)
{
    Contestants contestants;
    CostTable table = costTableOf(measured);
    if (table.entries.empty()) {
        return contestants;
    }
    fillAbsentClasses(table);
    std::array<CostEntry, kFootprintClasses> former;
    for (const double tolerance : kTolerances) {
        const auto choices = chooseMethods(table, tolerance);
        if (!choices || choices->classes == former) {
            continue;
        }
        former = choices->classes;
        std::ostringstream variant;
        variant << "tolerance " << tolerance;
        contestants.push_back(std::make_unique<AutoContestant>(*choices, variant.str(), subjects));
    }
    return contestants;
}

} // namespace trixel
