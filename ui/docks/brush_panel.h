// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/paint/brush.h"

#include <utility>
#include <vector>

class QCheckBox;
class QFormLayout;

namespace trixel::ui {

class BrushColors;
class SwatchButton;
class SwatchRow;
class ValueRow;
class ViewSettings;

/// Everything that decides what a dab looks like.
class BrushPanel : public QWidget
{
    Q_OBJECT

public:
    /// Radii offered, as parts of the surface's size.
    static constexpr float kLeastRadius = 2e-4F;
    static constexpr float kMostRadius = 0.5F;

    BrushPanel(ViewSettings& settings, BrushColors& colors, QWidget* parent = nullptr);

    /// Fits the radius slider to a surface. \param size  diagonal of its bounding box, world units
    void setSurfaceSize(float size);
    /// Whether the texture has a channel for opacity to choose.
    void setHasAlpha(bool hasAlpha) { m_hasAlpha = hasAlpha; }
    void chooseColor();

private:
    QWidget* makeColors();
    QWidget* makeValues();
    QWidget* makeSwitches();
    void addPercent(QFormLayout* form,
                    const QString& label,
                    const QString& toolTip,
                    float Brush::*value,
                    double high = 100.0);
    QCheckBox* makeSwitch(const QString& text, const QString& toolTip, bool Brush::*value);
    void showBrush();
    void showColors();

    ViewSettings& m_settings;
    BrushColors& m_colors;
    bool m_hasAlpha = false;
    SwatchButton* m_front = nullptr;
    SwatchButton* m_back = nullptr;
    SwatchRow* m_recent = nullptr;
    ValueRow* m_radius = nullptr;
    std::vector<std::pair<ValueRow*, float Brush::*>> m_percents;
    std::vector<std::pair<QCheckBox*, bool Brush::*>> m_switches;
};

} // namespace trixel::ui
