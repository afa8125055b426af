// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/chart_advice.h"

#include <QCoreApplication>
#include <QStringList>

#include "core/study/speed/auto_method.h"

#include <algorithm>

namespace trixel::ui {

namespace {

QString tr(const char* text)
{
    return QCoreApplication::translate("Advice", text);
}

QString nameOfMethod(const CostEntry& entry)
{
    return QString::fromStdString(toText(entry.method));
}

/// Those it takes, each once, in the order of the classes.
QString methodsOf(const AutoChoices& choices)
{
    QStringList methods;
    for (const CostEntry& entry : choices.classes) {
        if (!methods.contains(nameOfMethod(entry))) {
            methods += nameOfMethod(entry);
        }
    }
    return methods.join(", ");
}

void addAuto(ToleranceAdvice& advice, const Study& study, const StudyView& view)
{
    const auto choices = chooseMethods(costTableOf(study), *view.tolerance);
    if (!choices) {
        advice.details = QString::fromStdString(choices.error().message);
        advice.text += '\n' + tr("auto has no method for some class of footprints");
        return;
    }
    advice.details = QString::fromStdString(toText(*choices));
    if (view.footprintClass) {
        const auto at = static_cast<std::size_t>(*view.footprintClass);
        advice.text += '\n' + tr("auto takes %1 here").arg(nameOfMethod(choices->classes[at]));
    } else {
        advice.text += '\n' + tr("auto takes, by class: %1").arg(methodsOf(*choices));
    }
}

} // namespace

ToleranceAdvice adviceOf(const Study& study, const StudyView& view)
{
    ToleranceAdvice advice;
    const auto best = cheapestWithin(study, view);
    advice.text = best ? tr("Cheapest within it: %1").arg(inBrief(study, *best))
                       : tr("Nobody keeps this tolerance.");
    const bool byClass = std::ranges::any_of(
        study.points, [](const StudyPoint& point) { return point.method && point.footprintClass; });
    if (byClass && view.tolerance) {
        addAuto(advice, study, view);
    }
    return advice;
}

} // namespace trixel::ui
