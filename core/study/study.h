// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a study measured: points of cost against error, for the chart, the files and `auto`.
#pragma once

#include "core/base/progress.h"
#include "core/filter/filter_method.h"
#include "core/study/footprint_class.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace trixel {

/// One method (or variant) with one parameter, on one class of footprints.
struct StudyPoint
{
    std::string series;                 ///< who: "probes-1", "reference loop", "uint8", …
    std::string variant;                ///< parameter as people read it, "probes 16"; may be empty
    std::optional<MethodChoice> method; ///< where a click can choose it
    std::optional<FootprintClass> footprintClass; ///< nothing: all of them together
    double cost = 0;                              ///< in the study's unit
    double rms = 0;                               ///< fraction of the value range
    double p99 = 0;   ///< 99th percentile of |error|, fraction of the range
    double worst = 0; ///< largest |error|, fraction of the range
    std::uint64_t samples = 0;
    bool onFront = false;      ///< nobody of its class is cheaper and as accurate
    std::uint64_t refused = 0; ///< queries that the method refused; left out of the errors
    bool partly = false;       ///< measured on some of the footprints only: all would take too long

    bool operator==(const StudyPoint&) const = default;
};

struct Study
{
    std::string name;       ///< "speed-accuracy", "paint-projection", "reduction", "storage", …
    std::string title;      ///< one sentence over the chart
    std::string costTitle;  ///< axis: "Time per sample"
    std::string costUnit;   ///< "ns", "bytes", "faces"
    std::string subject;    ///< what it ran on
    std::string conditions; ///< machine, threads, seeds: what one needs to repeat it
    std::vector<StudyPoint> points;
    std::vector<std::string> notes; ///< sentences on what was refused or left out, and why
};

/// Hears of points as they are measured; from the thread that runs the study. A point comes again
/// when its cost is known better: one of the same series, variant and class takes the place of the
/// former.
class StudyWatcher : public Progress
{
public:
    virtual void measured(const StudyPoint& point) = 0;
};

/// Sets `onFront` of every point, class by class, by cost and rms.
void markFront(std::vector<StudyPoint>& points);

/// One line a point, a header line first; fields with commas or quotes are quoted.
std::string toCsv(const Study& study);
std::string toJson(const Study& study);

} // namespace trixel
