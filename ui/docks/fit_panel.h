// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/docks/fit_run.h"

#include <optional>

class QBoxLayout;
class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace trixel::ui {

class FitCompare;
class FitResult;
class FitViews;
class ScaledSpinBox;
class ViewSettings;
class ViewMap;
class Viewport;

/// Fit to scene: from views and a tolerance the lowest level of each face that keeps what the views
/// show. The plan, its costs and its errors are shown before it is applied as one undo step.
class FitPanel : public QWidget
{
    Q_OBJECT

public:
    FitPanel(Document& document,
             ViewSettings& settings,
             BackgroundJobs& jobs,
             Viewport& viewport,
             ViewMap& map,
             FitWork work,
             QWidget* parent = nullptr);

    const FitRun& run() const { return m_run; }
    /// Whether the last plan is for the texels and the choices as they are now.
    bool isCurrent() const;
    /// Gives the keyboard to the first choice.
    void begin();

signals:
    /// One sentence about what could not be done.
    void failed(const QString& sentence);
    /// One sentence about what was done.
    void applied(const QString& sentence);

private:
    void makeTolerance(QBoxLayout& column);
    void makeUnseen(QBoxLayout& column);
    void makeButtons(QBoxLayout& column);
    void connectRun();
    void planOrCancel();
    void apply();
    static QString applyText();
    void applyToLayers(const std::shared_ptr<const FitOutcome>& outcome);
    void tellApplied(const LevelCost& cost);
    void showOutcome();
    bool hasItsTexels() const;
    void showState();
    QString stateText() const;
    QString problem() const;
    FitSettings settings() const;

    Document& m_document;
    BackgroundJobs& m_jobs;
    FitRun m_run;
    std::shared_ptr<const FitOutcome> m_shown;
    std::optional<std::uint64_t> m_applied; ///< the texels' state that the plan led to

    FitViews* m_views;
    ScaledSpinBox* m_tolerance;
    QCheckBox* m_unseen;
    FitResult* m_result;
    FitCompare* m_compare;
    QLabel* m_state;
    QProgressBar* m_progress;
    QPushButton* m_plan;
    QPushButton* m_apply;
};

} // namespace trixel::ui
