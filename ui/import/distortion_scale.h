// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "ui/import/distortion_work.h"
#include "ui/viewport/map_scale.h"

namespace trixel::ui {

/// By which numbers become colours; the same for every mapping, so that maps can be compared.
const MapScale& distortionScale(DistortionMeasure measure);
/// What the colours mean, in one sentence.
QString distortionTitle(DistortionMeasure measure);
/// "0.42 texels a pixel", "3.2 : 1"
QString distortionText(DistortionMeasure measure, double number);

} // namespace trixel::ui
