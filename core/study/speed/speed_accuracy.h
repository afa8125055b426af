// SPDX-License-Identifier: GPL-3.0-or-later
//
// What every method costs and how far it is from `exact`, in one run.
#pragma once

#include "core/base/result.h"
#include "core/study/speed/contest.h"
#include "core/study/study.h"

#include <span>
#include <string>
#include <vector>

namespace trixel {

struct SpeedAccuracyOptions
{
    /// How often each batch is timed, interleaved with those of all others; the least time counts.
    int rounds = 5;
    /// Processor time that one contestant may take in one pass over all queries. Who would take
    /// longer is measured on some of them, evenly chosen from every class, or left out where that
    /// would be less than one in two hundred; the study's notes say so.
    double secondsAtMost = 4;
    /// Processor time for all rounds of one contestant: who is slow is timed less often, at least
    /// once.
    double secondsOfRounds = 2;
    /// Whether `auto` enters too, at several tolerances, by what was measured before.
    bool withAuto = true;
};

/// Times one thread's processor time for each sample and judges each answer, over all subjects
/// together and by class of footprint: one point each, the Pareto front marked. Every contestant
/// gets the same queries in the same batches, the mixed batch in the queries' own order.
/// Points reach the watcher when a contestant was first measured, and again at the end.
/// Fails only when cancelled.
/// \param subjects     those that the contestants were made for; all of one channel count
Result<Study> measureSpeedAccuracy(const std::vector<StudySubject>& subjects,
                                   const Contestants& contestants,
                                   const SpeedAccuracyOptions& options,
                                   StudyWatcher& watcher);

/// Processor and program, as the study's conditions name them: "AMD …, AVX2, trixel 0.1.0".
std::string machineText();

} // namespace trixel
