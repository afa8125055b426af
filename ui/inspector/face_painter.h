// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draws the texels of a face into a picture, as triangles or as packed pixels, at any scale.
#pragma once

#include <QImage>
#include <QRect>
#include <QRgb>

#include "core/base/parallel.h"
#include "core/lattice/face_layout.h"
#include "core/texture/face_texels.h"
#include "ui/inspector/shaded_texels.h"

namespace trixel::ui {

/// How texels are drawn besides their own colours.
struct TexelPaint
{
    /// Colours laid over lower and upper texels, premultiplied; 0 for none.
    QRgb lowerTint = 0;
    QRgb upperTint = 0;
    /// Pixels that several texels share show the mean of four samples. Off is quicker and has
    /// stairs.
    bool smooth = true;
    /// Lines between texels that show on any colour, in [0, 1]; 0 for none.
    double grid = 0;
    double unit = 1; ///< pixels of the image a unit of line width: of the screen, its density
    Threads threads = Threads::all();
};

/// Draws over what the picture shows; beside the face nothing changes. Costs as many steps as there
/// are pixels of the face inside `clip`, whatever its level.
/// \param image   Format_RGB32 or Format_ARGB32_Premultiplied (checked)
/// \param clip    in pixels of the image; what lies beyond the image is cut off
/// \param layout  in pixels of the image: (0,0) is its top left corner
/// \param shades  of the same level as the texels (checked)
void paintTexels(QImage& image,
                 const QRect& clip,
                 const FaceLayout& layout,
                 const FaceTexels& texels,
                 ShadedTexels& shades,
                 const TexelPaint& paint = {});

/// Side of a texel in the layout's units: of its pixel, or of a square of the same area as the two
/// texels of a cell.
double texelSide(const FaceLayout& layout, Level level);

/// The level, at most `finest`, that has about as many texels as the face has pixels: what is drawn
/// where a face is small.
Level levelToDraw(const FaceLayout& layout, Level finest);

} // namespace trixel::ui
