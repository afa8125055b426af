// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/fit_run.h"

#include <QThreadPool>

#include <utility>

namespace trixel::ui {

namespace {

LevelCounts countLevels(std::span<const Level> levels)
{
    LevelCounts counts{};
    for (const Level level : levels) {
        ++counts[static_cast<std::size_t>(level.log2())];
    }
    return counts;
}

/// The texels of a plan are many small pieces: whoever leaves it last, they are freed elsewhere.
void discard(FitOutcome* outcome)
{
    QThreadPool::globalInstance()->start([outcome] { delete outcome; });
}

} // namespace

FitWork fitWork()
{
    return [](const FitInput& input, Progress& progress) {
        return fitScene(
            *input.project.surface, input.project.texels, input.settings, Threads::all(), progress);
    };
}

FitRun::FitRun(BackgroundJobs& jobs, FitWork work, QObject* parent)
    : MeasuredRun(jobs, parent)
    , m_work(std::move(work))
{
}

void FitRun::start(FitInput input)
{
    if (isRunning()) {
        return;
    }
    const auto work = [fit = m_work,
                       input = std::move(input)](Progress& progress) -> Result<Outcome> {
        auto made = fit(input, progress);
        if (!made) {
            return tl::unexpected(made.error());
        }
        const auto outcome = std::shared_ptr<FitOutcome>(new FitOutcome, &discard);
        outcome->fit = std::move(*made);
        outcome->state = input.state;
        outcome->settings = input.settings;
        outcome->before = countLevels(levelsOf(input.project.texels).values());
        outcome->after = countLevels(outcome->fit.plan.levels.values());
        return Outcome(outcome);
    };
    launch(tr("Fitting levels to the scene…"), work, [this](Outcome outcome) {
        m_outcome = std::move(outcome);
    });
}

void FitRun::forget()
{
    cancel();
    m_outcome = nullptr;
}

} // namespace trixel::ui
