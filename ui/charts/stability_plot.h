// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include "core/study/stability/stability.h"
#include "ui/charts/plot.h"

namespace trixel::ui {

/// A sweep as a plot: how far each form is from the truth at every value, the textbook's beside
/// ours, with the bound across. A point's source is curve · values + value.
Plot plotOf(const StabilitySweep& sweep);

/// What is known of a point of that plot, a few short lines.
QStringList describe(const StabilitySweep& sweep, std::size_t source);

/// The largest error of ours, or of the textbook's, as people read it: "3·10⁻¹⁴", "∞".
QString worstText(const StabilitySweep& sweep, bool naive);

} // namespace trixel::ui
