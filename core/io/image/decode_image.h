// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/image/image.h"
#include "core/io/image/image_worker.h"

#include <array>
#include <filesystem>
#include <memory>
#include <vector>

namespace trixel {

struct DecodeOptions
{
    bool keepsAlpha = false; ///< colours stay multiplied by opacity where the file keeps them so
    /// Width and height of the levels that must follow the image in the file, and are read too.
    std::vector<std::array<int, 2>> coarserLevels;
};

/// The pixels of a file, and what they are.
struct DecodedImage
{
    int width = 0, height = 0;
    TexelFormat format;
    std::vector<ColorSpace> colors;
    /// Of the image, rows from the top; behind them those of the coarser levels that were asked
    /// for.
    std::shared_ptr<std::byte> pixels;
};

/// `readImage`, and what verifies a written file compares with.
Result<DecodedImage> decodeImageFile(const ImageWorker& worker,
                                     const std::filesystem::path& path,
                                     const DecodeOptions& options,
                                     Progress& progress,
                                     const ImageLimits& limits);

} // namespace trixel
