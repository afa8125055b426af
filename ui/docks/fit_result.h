// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/docks/fit_run.h"

class QFormLayout;
class QLabel;
class QPushButton;
class QTreeWidget;

namespace trixel::ui {

class ViewSettings;

/// What a fit would do and what it would leave: texels, memory, errors, subdivision, filter method,
/// and the faces by level.
class FitResult : public QWidget
{
    Q_OBJECT

public:
    explicit FitResult(ViewSettings& settings, QWidget* parent = nullptr);

    void show(const FitOutcome& outcome);

private:
    QLabel* addRow(QFormLayout& form, const QString& title, const QString& toolTip);
    void makeLevels();
    void showUnseen(const FitOutcome& outcome);
    void showMethod(const FitOutcome& outcome);
    void showSubdivision(const FitOutcome& outcome);
    void showLevels(const FitOutcome& outcome);
    void showUse();

    ViewSettings& m_settings;
    QLabel* m_texels;
    QLabel* m_memory;
    QLabel* m_faces;
    QLabel* m_unseen;
    QLabel* m_error;
    QLabel* m_subdivision;
    QLabel* m_method;
    QPushButton* m_use;
    QTreeWidget* m_levels;
    std::optional<MethodChoice> m_choice;
};

} // namespace trixel::ui
