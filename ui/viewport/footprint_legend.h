// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace trixel::ui {

/// A line in the lower left corner of the view that says what the lines of the footprint are, and
/// that they are drawn larger than they are.
class FootprintLegend : public QLabel
{
    Q_OBJECT

public:
    explicit FootprintLegend(QWidget* view);

    /// The pixel that is looked at, under the pointer or where a texel is held.
    void tellOfHovered();
    /// Footprints that a panel chose.
    void tellOf(double magnification, bool withFrozen);

    /// Takes the corner again, after the view has changed its size.
    void place();
};

} // namespace trixel::ui
