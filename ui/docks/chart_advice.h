// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/study/study.h"
#include "ui/charts/study_plot.h"

namespace trixel::ui {

/// What to take for a tolerance.
struct ToleranceAdvice
{
    QString text;    ///< a line or two
    QString details; ///< what `auto` takes for each class; empty where the study has no methods
};

/// The cheapest within the view's tolerance by what the study measured, and what `auto` would take,
/// which chooses for each class of footprint on its own.
ToleranceAdvice adviceOf(const Study& study, const StudyView& view);

} // namespace trixel::ui
