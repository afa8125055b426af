// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/footprint/ellipse_report.h"
#include "core/texture/texel_format.h"
#include "core/texture/texel_neighbours.h"
#include "ui/viewport/hover_filter.h"

#include <optional>
#include <span>

namespace trixel::ui {

/// The words of the readout that are not those of a `TexelReport`. Numbers are written so that they
/// can be pasted into other programs: no group separators, a point before the fraction.

/// A point with the digits that count on a surface of that size, so that all three numbers fit.
/// \param size  diagonal of the surface's bounding box, world units
QString positionText(glm::vec3 position, float size);
QString vectorText(glm::dvec2 vector); ///< in (u,v)
QString ellipseText(const FootprintEllipse& ellipse);

QString widthText(const EllipseReport& report); ///< "3.4 texels · level 2.3"
QString readAtText(const FilteredTexel& texel); ///< "level 2.0 · 24 taps"
/// Filtered values on the scale of the stored ones, with what lies between whole numbers.
QString filteredText(TexelType type, std::span<const float> values);

/// Rich text whose links are texel addresses: "12:3,1,lower", "12:4,0,lower … 7,0 ×4", "border".
QString neighbourLinks(const std::optional<TexelsAcross>& neighbour);

} // namespace trixel::ui
