// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/image/image.h"
#include "core/io/image/image_worker.h"

#include <filesystem>

namespace trixel {

/// `readImage`, and what verifies a written file compares with.
/// \param keepsAlpha  colours stay multiplied by opacity where the file keeps them so
Result<Image> decodeImageFile(const ImageWorker& worker,
                              const std::filesystem::path& path,
                              bool keepsAlpha,
                              Progress& progress,
                              const ImageLimits& limits);

} // namespace trixel
