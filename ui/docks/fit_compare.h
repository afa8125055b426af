// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/docks/fit_run.h"

class QRadioButton;

namespace trixel::ui {

class ViewMap;
class ViewSettings;
class Viewport;

/// Chooses what the view shows of a plan before it is applied: the texels as they are, the fitted
/// ones in their place, or the error of each face.
class FitCompare : public QWidget
{
    Q_OBJECT

public:
    FitCompare(ViewSettings& settings, Viewport& viewport, ViewMap& map, QWidget* parent = nullptr);

    /// \param outcome   null where there is none
    /// \param isCurrent whether the texels are still those that it was planned for
    void setOutcome(std::shared_ptr<const FitOutcome> outcome, bool isCurrent);
    void showTexels();
    void showErrors();

private:
    QRadioButton* addChoice(const QString& text, const QString& name, const QString& toolTip);
    void showFitted();
    void chooseMap(bool errors);
    void takeShown(bool others);
    void follow();

    ViewSettings& m_settings;
    Viewport& m_viewport;
    ViewMap& m_map;
    std::shared_ptr<const FitOutcome> m_outcome;
    bool m_isShowing = false;   ///< what the view is told to show is ours
    bool m_showsFitted = false; ///< and nobody else has had it show others since
    QRadioButton* m_texels;
    QRadioButton* m_fitted;
    QRadioButton* m_errors;
};

} // namespace trixel::ui
