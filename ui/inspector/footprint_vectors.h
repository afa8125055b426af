// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/footprint/footprint.h"

#include <array>

class QDoubleSpinBox;

namespace trixel::ui {

/// W1 and W2 as numbers, to be typed and stepped.
class FootprintVectors : public QWidget
{
    Q_OBJECT

public:
    explicit FootprintVectors(QWidget* parent = nullptr);

    /// \param texel  edge of a texel in (u,v): what a step is
    void show(const Footprint& footprint, double texel);

signals:
    void edited(glm::dvec2 w1, glm::dvec2 w2);

private:
    std::array<QDoubleSpinBox*, 4> m_boxes{}; ///< W1 u, v, W2 u, v
    Footprint m_shown;
};

} // namespace trixel::ui
