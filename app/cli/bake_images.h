// SPDX-License-Identifier: GPL-3.0-or-later
//
// The images that `bake` lays onto faces, as its options name them.
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/image/color_space.h"
#include "core/mapping/image_tiles.h"

#include <optional>
#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace trixel::app {

enum class MappingKind { Uv, Sphere, Planar, Quad, Camera };

struct BakeImageArguments
{
    std::string image;
    std::string lookup = "footprint";
    std::string index = "centres";
    std::optional<std::string> color;
    bool repeats = false;
};

void addBakeImageOptions(CLI::App& verb, BakeImageArguments& arguments);

struct BakeImages
{
    ImageTiles tiles;
    bool repeats = false;
};

/// Reads the image, or one for each tile where its name holds <UDIM>. Errors name the file, or the
/// option at fault.
Result<BakeImages> readBakeImages(const BakeImageArguments& arguments,
                                  MappingKind mapping,
                                  Threads threads,
                                  Progress& progress);

/// "srgb", "linear" or "raw".
Result<ColorSpace> colorSpace(std::string_view option, std::string_view text);

} // namespace trixel::app
