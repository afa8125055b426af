// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/inspector/footprint_probe.h"

class QComboBox;
class QGridLayout;
class QToolButton;

namespace trixel::ui {

class ViewSettings;

/// Where the footprint comes from, which method is asked and what colours texels.
class FootprintChoices : public QWidget
{
    Q_OBJECT

public:
    enum class Colouring { MethodWeights, ExactWeights, Values };

    explicit FootprintChoices(ViewSettings& settings, QWidget* parent = nullptr);

    void setSource(FootprintSource source);
    /// \param possible  whether there is a footprint to freeze or to let go
    void setFrozen(bool frozen, bool possible);
    Colouring colouring() const;

signals:
    void sourceChosen(trixel::ui::FootprintSource source);
    void freezeToggled(bool frozen);
    void colouringChosen();

private:
    void addRow(QGridLayout& grid, const QString& text, QComboBox& box, QWidget* beside = nullptr);

    QComboBox* m_source;
    QComboBox* m_colouring;
    QToolButton* m_freeze;
};

} // namespace trixel::ui
