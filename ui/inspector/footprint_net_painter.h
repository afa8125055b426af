// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPointF>
#include <QRectF>

#include "core/filter/footprint_net.h"
#include "core/texture/texel_store.h"
#include "render/look.h"

#include <optional>
#include <vector>

class QPainter;
class QPalette;

namespace trixel::ui {

/// What is drawn of a footprint laid flat. A value: what it shows does not change under it.
struct NetPicture
{
    /// What texels are filled with.
    enum class Fill { Weights, Values };

    FootprintNet net;
    /// Of the method, where they are known.
    std::optional<Contributions> weights;
    /// A second footprint, on a face of the net.
    std::optional<PlacedFootprint> frozen;
    /// For Fill::Values.
    TexelStore texels;
    render::Look look;
    Fill fill = Fill::Weights;
};

/// Plane of the net (world units, y up) → the picture (pixels, y down).
struct NetView
{
    double scale = 1; ///< pixels of a world unit
    QPointF centre;   ///< where the footprint's centre is

    QPointF toPicture(glm::dvec2 point) const
    {
        return {centre.x() + scale * point.x, centre.y() - scale * point.y};
    }
    glm::dvec2 toPlane(QPointF point) const
    {
        return {(point.x() - centre.x()) / scale, (centre.y() - point.y()) / scale};
    }
};

/// The view that shows a footprint whole, and the texels about it.
NetView fittedView(const FootprintNet& net, const QRectF& area);

/// W1 and W2 are taken hold of at the middles of the parallelogram's sides, where the ellipse meets
/// them, too.
enum class NetHandle { W1, W2 };
glm::dvec2 handlePosition(const FootprintNet& net, NetHandle handle);

/// Colour of a weight, and of the scale beside it. \param share  of the largest weight
QColor weightColor(double share);

/// Draws the net into an area, by vectors.
/// \param held  a handle that is under the pointer or dragged
void paintNet(QPainter& painter,
              const QRectF& area,
              const NetPicture& picture,
              const NetView& view,
              const QPalette& palette,
              std::optional<NetHandle> held = std::nullopt);

} // namespace trixel::ui
