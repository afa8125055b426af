// SPDX-License-Identifier: GPL-3.0-or-later
//
// The JSON file beside a packed atlas: what a shader needs to address it, and what Trixel needs to
// take the faces back.
//
//   version     1
//   kind        "packed"
//   border      pixels about each half of a tile: 0 or 1
//   mips        whether coarser levels are there
//   packing     "bands" or "shelves"
//   type        "uint8", "uint16", "half", "float": of the faces
//   channels    how many; alpha: which of them is opacity, or null
//   colors      "raw", "linear" or "srgb" for each channel
//   pages       [{file, width, height}], beside this file
//   levels      for each level: level, faces that are finer (the prefix sum), grids
//               [{first, count, perRow, page, x, y}] of tiles in order of rank
//   faces       for each face in order: level, rank, page, x, y of the tile of its own level
//   table       the same numbers as 32-bit unsigned, for the address function
//   shader      the file of that function (GLSL and HLSL)
#pragma once

#include "core/atlas/packed_pages.h"
#include "core/base/json_fields.h"
#include "core/image/color_space.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trixel {

struct AtlasPageFile
{
    std::string file; ///< a name beside the JSON file
    AtlasPage size;

    bool operator==(const AtlasPageFile&) const = default;
};

/// What is needed to take the faces back.
struct AtlasDescription
{
    AtlasBorder border{};
    TexelFormat format; ///< of the faces; the pages may be of a type that holds more
    std::vector<ColorSpace> colors;
    std::vector<AtlasPageFile> pages;
    FaceMap<PackedFace> faces;
};

/// The text of the file. \param pages  one for each of the layout (checked)
std::string describeAtlas(const AtlasLayout& layout,
                          const TexelFormat& format,
                          const std::vector<ColorSpace>& colors,
                          const std::vector<std::string>& pages,
                          const std::string& shader);

/// Strict: errors name the field. Tiles lie whole on their pages, which have names without folders.
Result<AtlasDescription> parseAtlasDescription(std::string_view text);

/// The address function, as it is written beside the atlas.
std::string_view atlasShader();

} // namespace trixel
