// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the panel of imports speaks.
#pragma once

#include <QString>

#include "core/base/result.h"
#include "core/layers/layer_stack.h"
#include "ui/import/import_images.h"

namespace trixel::ui {

/// As a QFileDialog takes it.
QString imageFilter();
/// Whether a file's name ends as those of images do.
bool isImageName(const QString& path);

/// "4,096 × 2,048 pixels, 3 channels of uint8, sRGB"
QString aboutText(const ImportImages& images);
/// What the image's file says of its colours.
QString colorText(const Image& image);
/// "Red", "Opacity", "Channel 5"
QString channelName(const TexelFormat& format, int channel);
/// "0.4 seconds", "about 3 minutes"
QString secondsText(double seconds);

/// " Shown over all layers, it will lie right above Lines.": where a preview, which lies over all,
/// does not tell the place of an import; else nothing. \param below  the layer under it
QString placeText(const LayerStack& layers, LayerId below);

/// An error as a sentence: a capital at its beginning, but for names of files, and a full stop.
QString problemText(const Error& error);

} // namespace trixel::ui
