// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines and dots over drawn texels: where texels end, where they are sampled.
#pragma once

#include <QLineF>
#include <QPolygonF>
#include <QRectF>

#include "core/lattice/face_layout.h"

#include <functional>
#include <optional>
#include <vector>

class QPainter;

namespace trixel::ui {

inline QPointF toPoint(glm::dvec2 p)
{
    return {p.x, p.y};
}
QPolygonF toPolygon(const TexelOutline& outline);
QRectF boundsOf(const TexelOutline& outline);

/// The part of a line inside a rectangle, if any.
std::optional<QLineF> clipped(const QLineF& line, const QRectF& area);

/// Calls for every texel whose outline may be seen in the area, each once.
/// \param layout  in the painter's units, as the area
void forEachTexel(const FaceLayout& layout,
                  Level level,
                  const QRectF& area,
                  const std::function<void(TexelCoord)>& visit);

/// The lines between texels that cross the area, each once: of the lattice, or of the pixels.
std::vector<QLineF> gridLines(const FaceLayout& layout, Level level, const QRectF& area);

/// Of a packed square: the steps between the pixels of lower and those of upper texels.
std::vector<QLineF> diagonalSteps(const FaceLayout& layout, Level level, const QRectF& area);
/// Of a packed square: the edge from V1 to V2 as it is drawn, x + y = R + 1/3, so that no pixel's
/// centre lies on it.
QLineF diagonal(const FaceLayout& layout, Level level);

/// Draws lines that show on any colour. \param strength  in [0, 1]
void drawLines(QPainter& painter, const std::vector<QLineF>& lines, double strength);
/// Draws dots that show on any colour. \param radius  in the painter's units
void drawDots(QPainter& painter, const std::vector<QPointF>& dots, double radius, double strength);

/// 0 where `size` is at most `from`, 1 from `to` on: marks fade in as texels grow.
double fadeIn(double size, double from, double to);

} // namespace trixel::ui
