// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/image/image.h"
#include "core/io/image/image_worker.h"

#include <filesystem>

namespace trixel {

/// Reads a PNG, JPEG, TIFF, OpenEXR, HDR, TGA, BMP or WebP file, whichever its first bytes say it
/// is. Of several pictures in a file the first is read; a turned photograph is turned upright, a
/// cropped one put into its frame; colours come out not multiplied by opacity. Integers keep their
/// type up to 16 bits, half stays half, everything else becomes float.
///
/// What channels mean is what the file says (Trixel's own files say it of each channel), else sRGB
/// for integers and linear light for floats.
///
/// The decoding happens in another process (`ImageWorker`) under `limits`. Errors name the file:
/// missing or unreadable (Path); no image of these kinds, damaged, too large, or more than it can
/// hold honestly (Contents).
Result<Image> readImage(const ImageWorker& worker,
                        const std::filesystem::path& path,
                        Progress& progress,
                        const ImageLimits& limits = {});

} // namespace trixel
