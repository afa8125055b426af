// SPDX-License-Identifier: GPL-3.0-or-later
//
// A picture of a panel or the view as an image or a file, with a line below it that tells what it
// is of.
#pragma once

#include <QByteArray>
#include <QImage>
#include <QString>

#include "core/base/result.h"

#include <filesystem>

namespace trixel::ui {

class PictureSource;

/// Pixels along a side of a larger picture: it is refused.
inline constexpr int kMostPicturePixels = 16'384;

/// \param caption        below the picture; none when empty
/// \param pixelsPerUnit  2 is as sharp as a screen of twice the density
/// \return the image; an error where there is nothing to show or it would be too large (Contents)
Result<QImage> imageOf(PictureSource& source, const QString& caption, double pixelsPerUnit);

/// The same as lines, areas and letters: SVG. Letters are outlines where the source draws them so.
Result<QByteArray> svgOf(PictureSource& source, const QString& caption);

/// Compresses and writes an image as `.png`; the file is whole or not there. Takes its time: meant
/// for the background.
Status writePng(const QImage& image, const std::filesystem::path& path);

} // namespace trixel::ui
