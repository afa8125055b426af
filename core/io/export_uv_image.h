// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is painted as images by the mesh's own uvs: one, or one for each tile.
#pragma once

#include "core/base/parallel.h"
#include "core/image/color_space.h"
#include "core/io/image/image_worker.h"
#include "core/io/project.h"
#include "core/mapping/uv_mapping.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace trixel {

/// Stands for a tile's number in the name of a file.
inline constexpr std::string_view kUdimPlace = "<UDIM>";

struct UvExportOptions
{
    static constexpr int kMostPixels = 65536; ///< of a side
    static constexpr int kMostGutter = 256;

    int width = 2048;  ///< pixels, [1, kMostPixels]
    int height = 2048; ///< likewise
    int gutter = 16;   ///< pixels, [0, kMostGutter]; see `UvImageOptions`
    /// Empty for what the kind of file holds nearest to that of the texels.
    std::optional<TexelType> type;
    /// What the image's channels are to mean; empty for what the project says, else sRGB for
    /// integers and linear for floats.
    std::optional<ColorSpace> space;
    bool levels = false; ///< with all halves, as renderers want textures: TIFF, OpenEXR and .tx

    bool operator==(const UvExportOptions&) const = default;
};

/// What will be written.
struct UvExportPlan
{
    std::vector<UdimTile> tiles;
    std::vector<std::filesystem::path> files; ///< one a tile
    TexelFormat format;                       ///< of the images
    std::vector<ColorSpace> colors;           ///< of their channels
    std::uint64_t pixels = 0;                 ///< of all images, without their halves

    /// Before compression, halves included.
    std::uint64_t bytes(const UvExportOptions& options) const;
};

/// Looks at the uvs and at what the kind of file can hold; draws and writes nothing.
/// \param path  of the image; kUdimPlace in its name stands for the number of each tile
/// Errors are those of `uvTiles` and `checkImageTarget`, and uvs beyond the first tile where the
/// name has no place for tiles' numbers; those of the mesh do not name a file.
Result<UvExportPlan> planUvExport(const std::filesystem::path& path,
                                  const Project& project,
                                  const UvExportOptions& options);

/// What became of one tile.
struct UvTileOutcome
{
    std::filesystem::path file;
    std::uint64_t insidePixels = 0; ///< that lie on faces
    std::uint64_t pixels = 0;
    std::uint32_t facesWithoutPixel = 0; ///< too small to hold one
};

/// Draws and writes the images, which take their names together when all are there, each read back
/// and compared. Errors name the file, or tell of the mesh; Cancelled leaves what was there.
Result<std::vector<UvTileOutcome>> exportUvImages(const ImageWorker& worker,
                                                  const std::filesystem::path& path,
                                                  const Project& project,
                                                  const UvExportOptions& options,
                                                  Threads threads,
                                                  Progress& progress);

} // namespace trixel
