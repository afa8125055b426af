// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sweeps that ask every method of the table.
#pragma once

#include "core/filter/filter_method.h"
#include "core/study/stability/sweeps.h"

#include <algorithm>
#include <functional>
#include <string>

namespace trixel::sweeps {

/// What is asked, and of what.
struct FilterCase
{
    FilterScene scene;
    QueryArrays queries;
};

inline ResultArrays answersOf(const FilterCase& filterCase, const FilterMethod& method)
{
    ResultArrays results(filterCase.queries.size(), filterCase.scene.channels());
    method.filter(filterCase.scene, filterCase.queries.queries(), results.results());
    return results;
}

/// Error of the textbook's way at one value, and of any method.
struct FilterErrors
{
    double naive = 0;
    std::function<double(const FilterMethod&)> ofMethod;
};

/// One naive curve and one for every method that `applies`. errorsAt(value) → FilterErrors is
/// called once a value.
template <class Applies, class ErrorsAt>
void addFilterCurves(StabilitySweep& sweep,
                     std::string naiveForm,
                     const Applies& applies,
                     const ErrorsAt& errorsAt)
{
    std::vector<std::unique_ptr<const FilterMethod>> methods;
    sweep.curves.push_back({std::move(naiveForm), true, {}});
    for (const MethodEntry& entry : filterMethods()) {
        if (applies(entry)) {
            methods.push_back(entry.make(entry.parameter ? entry.parameter->standard : 0));
            sweep.curves.push_back({std::string(entry.name), false, {}});
        }
    }
    for (const SweepValue& value : sweep.values) {
        const FilterErrors errors = errorsAt(value.at);
        sweep.curves[0].errors.push_back(std::isnan(errors.naive) ? kNoAnswer : errors.naive);
        for (std::size_t m = 0; m < methods.size(); ++m) {
            const double error = errors.ofMethod(*methods[m]);
            sweep.curves[m + 1].errors.push_back(std::isnan(error) ? kNoAnswer : error);
        }
    }
}

} // namespace trixel::sweeps
