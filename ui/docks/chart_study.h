// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the chart can measure, as the panel sees it.
#pragma once

#include <QString>

#include "core/base/result.h"
#include "core/io/project.h"
#include "core/study/study.h"

#include <functional>
#include <optional>
#include <vector>

namespace trixel::ui {

/// What a study is to run on.
struct StudyInput
{
    std::optional<Project> project; ///< a snapshot; nothing: the stored test textures
    QString name;                   ///< of the project
};

/// A study that can be run.
struct StudyOffer
{
    QString title; ///< as people choose it, in a word or two
    QString about; ///< one sentence
    /// Name, titles and units as the study will have them, for the points that come before its end.
    Study header;
    bool onProject = true;
    QString stored; ///< what it runs on where it needs no project, "Stored test textures"
    /// Runs on another thread. Points may be told again when they are known better.
    std::function<Result<Study>(const StudyInput& input, StudyWatcher& watcher)> run;
};

/// The view's ways of filtering on the graphics card. On the window's thread.
StudyOffer filteringOffer();

/// The studies of the program. On the window's thread.
std::vector<StudyOffer> studyOffers();

} // namespace trixel::ui
