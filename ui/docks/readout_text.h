// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>

#include "core/footprint/ellipse_report.h"
#include "core/texture/texel_format.h"
#include "ui/viewport/hover_filter.h"
#include "ui/viewport/viewport.h"

#include <span>

namespace trixel::ui {

/// The words of the readout. Numbers are written so that they identify a texel and can be pasted
/// into other programs: no group separators, a point before the fraction.

QString texelText(const TexelCoord& texel);     ///< "(3, 1) upper"
QString storageText(const HoveredTexel& texel); ///< "pixel 3, 1 · index 11"
QString barycentricText(glm::vec2 uv);          ///< "u 0.25000  v 0.50000  w 0.25000"
/// A point with the digits that count on a surface of that size, so that all three numbers fit.
/// \param size  diagonal of the surface's bounding box, world units
QString positionText(glm::vec3 position, float size);
QString vectorText(glm::dvec2 vector); ///< in (u,v)
QString ellipseText(const FootprintEllipse& ellipse);

QString widthText(const EllipseReport& report); ///< "3.4 texels · level 2.3"
QString readAtText(const FilteredTexel& texel); ///< "level 2.0 · 24 taps"
/// Filtered values on the scale of the stored ones, with what lies between whole numbers.
QString filteredText(TexelType type, std::span<const float> values);

/// Values as they are stored: whole numbers for the integer types.
QString storedText(TexelType type, std::span<const float> values);

/// The values as a screen colour; one or two channels give a grey, a fourth channel is opacity.
QColor shownColor(std::span<const float> values);
/// "#c8c8c8 · 200 200 200"
QString shownText(const QColor& color);

} // namespace trixel::ui
