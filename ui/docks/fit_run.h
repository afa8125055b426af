// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/project.h"
#include "core/study/fit/scene_fit.h"
#include "ui/docks/measured_run.h"
#include "ui/document/document.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>

namespace trixel::ui {

/// What a fit is planned for.
struct FitInput
{
    Project project;
    StateId state{}; ///< that the project is a snapshot of
    FitSettings settings;
};

/// Faces at each level.
using LevelCounts = std::array<std::uint32_t, Level::kMax + 1>;

/// A plan and what it was made for.
struct FitOutcome
{
    SceneFit fit;
    StateId state{};
    FitSettings settings;
    LevelCounts before{};
    LevelCounts after{};
};

/// Runs on another thread.
using FitWork = std::function<Result<SceneFit>(const FitInput& input, Progress& progress)>;

/// Core's `fitScene`, with all threads.
FitWork fitWork();

/// A fit being planned in the background, and the last one that was.
class FitRun : public MeasuredRun
{
    Q_OBJECT

public:
    FitRun(BackgroundJobs& jobs, FitWork work, QObject* parent = nullptr);

    /// Does nothing while a plan is being made.
    void start(FitInput input);
    /// Gives up the last plan and the one being made.
    void forget();
    /// Null while there is none.
    const std::shared_ptr<const FitOutcome>& outcome() const { return m_outcome; }

private:
    using Outcome = std::shared_ptr<const FitOutcome>;
    bool take() override { return false; } // a plan comes whole

    FitWork m_work;
    Outcome m_outcome;
};

} // namespace trixel::ui
