// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/speed/contest.h"
#include "core/study/study.h"

namespace trixel {

/// `auto` at tolerances from 10 % to 0.2 %, chosen by what a study has measured so far: what is
/// won by giving each class of footprint its own method. A tolerance that no method meets in some
/// class, or that leads to the same choice as a wider one, is left out.
/// \param subjects  outlive the contestants
Contestants autoContestants(const Study& measured, const std::vector<StudySubject>& subjects);

} // namespace trixel
