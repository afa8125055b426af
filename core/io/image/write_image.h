// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/image/image.h"
#include "core/io/image/image_worker.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace trixel {

/// How an image is written.
struct ImageWriteOptions
{
    /// OpenEXR expects colours multiplied by opacity, and so they are, which loses those under an
    /// opacity of 0. False: as they are in the image; Trixel reads them back to the bit, others
    /// take them for multiplied.
    bool multipliesByAlpha = true;
    int tile = 64;  ///< pixels of a tile's side where there are several levels; a multiple of 16
    int effort = 4; ///< of PNG, 1 (fast) to 9 (small)
    /// How a texture goes on beyond its border: "clamp", "black" or "periodic".
    std::string wrap = "clamp";
    Threads threads = Threads::all();
};

/// Fails, in the words of an argument's fault, if a file of this name cannot hold such an image:
/// the name ends otherwise than in .png (uint8 and uint16, 1 to 4 channels), .tif, .tiff (uint8,
/// uint16, float), .exr (half, float) or .tx (a TIFF or OpenEXR file, by type), a PNG would have
/// opacity elsewhere than last, or a side is longer than 2^17 pixels. To be asked before long work.
Status checkImageTarget(const std::filesystem::path& path,
                        const TexelFormat& format,
                        std::int64_t width,
                        std::int64_t height,
                        bool hasLevels);

/// Writes an image, by `commitFile`: the file is read back and compared before it takes its name.
/// What its channels mean goes into the file, in the format's own words and in Trixel's.
/// \param levels  the image, and nothing else: rows, no tiles; or with its halves (`imageLevels`,
///                or others of the same sizes): tiles, each level in the file, a texture as
///                renderers want it (TIFF, OpenEXR and .tx). At least one, all of one format
///                (checked)
/// Errors name the file (see `checkImageTarget`); Cancelled leaves what was there.
Status writeImage(const ImageWorker& worker,
                  const std::filesystem::path& path,
                  std::span<const Image> levels,
                  const ImageWriteOptions& options,
                  Progress& progress);

} // namespace trixel
