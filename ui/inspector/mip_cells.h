// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>
#include <QSizeF>

#include "core/lattice/face_layout.h"

#include <vector>

namespace trixel::ui {

/// How the levels of a face are set side by side.
struct MipArrangement
{
    FaceLayout::Texels texels = FaceLayout::Texels::Triangles;
    /// Each level half as wide as the finer one, as its texels count; else all alike.
    bool trueSize = false;

    bool operator==(const MipArrangement&) const = default;
};

/// Where one level is drawn.
struct MipCell
{
    Level level;
    QRectF picture; ///< around the triangle or square, in pixels
    QRectF label;   ///< above it
    FaceLayout layout = FaceLayout::packed();
};

/// Cells for all levels down from `base`, the finest first, row by row, as large as they may be so
/// that all fit.
/// \param lineHeight  of the labels' text
/// \param lines       of a label, where cells are alike; one where they are of true size
std::vector<MipCell>
placeMips(Level base, QSizeF room, const MipArrangement& arrangement, double lineHeight, int lines);

} // namespace trixel::ui
