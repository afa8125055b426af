// SPDX-License-Identifier: GPL-3.0-or-later
//
// A stability report as text, tables and a sheet of pictures.
#pragma once

#include "core/study/stability/stability.h"

#include <string>

namespace trixel {

/// A header line, then one line a sweep, form and value:
/// sweep,axis,value,label,form,kind,error,bound,within. Errors may be "inf".
std::string toCsv(const StabilityReport& report);

/// The whole report; infinite errors are null.
std::string toJson(const StabilityReport& report);

/// One line a sweep and a finding, for people: bound, worst error of our form and of the
/// textbook's, and where the textbook's leaves the chart.
std::string toText(const StabilityReport& report);

/// Small multiples, one panel a sweep: log error against what is swept, the textbook's curve, ours,
/// and the bound. Errors beyond the chart are drawn at its edge. For light backgrounds.
std::string toSvg(const StabilityReport& report);

/// Where naive forms first leave the bound: the first value beyond it, in the order of the sweep.
/// Nothing where they never do.
std::optional<SweepValue> firstNaiveFailure(const StabilitySweep& sweep);

} // namespace trixel
