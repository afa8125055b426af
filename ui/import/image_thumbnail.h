// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>

#include "core/image/image.h"

namespace trixel::ui {

/// A small picture of an image as a screen shows it, with its opacity. \param mostAcross  pixels
/// that its longer side may have
QImage thumbnailOf(const Image& image, int mostAcross);

} // namespace trixel::ui
