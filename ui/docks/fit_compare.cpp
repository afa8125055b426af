// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/fit_compare.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QRadioButton>
#include <QScopedValueRollback>

#include "ui/viewport/view_map.h"
#include "ui/viewport/view_settings.h"

#include <utility>

namespace trixel::ui {

namespace {

constexpr int kSpace = 10;

/// The errors live as long as the outcome does.
FaceErrors errorsOf(const std::shared_ptr<const FitOutcome>& outcome)
{
    if (!outcome) {
        return {};
    }
    return {{outcome, &outcome->fit.plan.errors}, outcome->settings.tolerance};
}

} // namespace

FitCompare::FitCompare(ViewSettings& settings, Viewport& viewport, ViewMap& map, QWidget* parent)
    : QWidget(parent)
    , m_settings(settings)
    , m_viewport(viewport)
    , m_map(map)
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kSpace);
    m_texels =
        addChoice(tr("&Now"), tr("Show the texels as they are"), tr("The texels as they are"));
    m_fitted = addChoice(tr("&Fitted"),
                         tr("Show the fitted texels"),
                         tr("The texels as the plan would have them; nothing is changed yet"));
    m_errors =
        addChoice(tr("E&rrors"),
                  tr("Show the errors of the fit"),
                  tr("The RMS that the plan leaves on each face, as a map over the view (Ctrl+5)"));
    row->addStretch(1);
    connect(m_texels, &QRadioButton::clicked, this, &FitCompare::showTexels);
    connect(m_fitted, &QRadioButton::clicked, this, &FitCompare::showFitted);
    connect(m_errors, &QRadioButton::clicked, this, &FitCompare::showErrors);
    connect(&settings, &ViewSettings::viewChanged, this, &FitCompare::follow);
    connect(&viewport, &Viewport::otherTexelsShown, this, &FitCompare::takeShown);
    follow();
}

QRadioButton*
FitCompare::addChoice(const QString& text, const QString& name, const QString& toolTip)
{
    auto* choice = new QRadioButton(text);
    choice->setAccessibleName(name);
    choice->setToolTip(toolTip);
    layout()->addWidget(choice);
    return choice;
}

void FitCompare::setOutcome(std::shared_ptr<const FitOutcome> outcome, bool isCurrent)
{
    if (m_outcome != outcome) {
        m_outcome = std::move(outcome);
        m_viewport.showOtherTexels(std::nullopt);
        m_map.setFaceErrors(errorsOf(m_outcome));
        if (!m_outcome) {
            chooseMap(false);
        }
    }
    m_fitted->setEnabled(m_outcome && isCurrent);
    m_errors->setEnabled(m_outcome != nullptr);
}

void FitCompare::showTexels()
{
    m_viewport.showOtherTexels(std::nullopt);
    chooseMap(false);
}

void FitCompare::showFitted()
{
    if (m_outcome) {
        chooseMap(false);
        const QScopedValueRollback showing(m_isShowing, true);
        m_viewport.showOtherTexels(m_outcome->fit.fitted);
    }
}

void FitCompare::showErrors()
{
    if (m_outcome) {
        m_viewport.showOtherTexels(std::nullopt);
        chooseMap(true);
    }
}

/// Another map than the errors stays.
void FitCompare::chooseMap(bool errors)
{
    ViewOptions view = m_settings.view();
    if (errors || view.map == ViewMapKind::Fit) {
        view.map = errors ? ViewMapKind::Fit : ViewMapKind::None;
        m_settings.setView(view);
    }
}

/// Other texels may be those of an import's preview, too.
void FitCompare::takeShown(bool others)
{
    m_showsFitted = others && m_isShowing;
    follow();
}

void FitCompare::follow()
{
    QRadioButton* shown = m_settings.view().map == ViewMapKind::Fit ? m_errors
                          : m_showsFitted                           ? m_fitted
                                                                    : m_texels;
    shown->setChecked(true);
}

} // namespace trixel::ui
