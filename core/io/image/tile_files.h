// SPDX-License-Identifier: GPL-3.0-or-later
//
// Images that are spread over several files, one for each tile.
#pragma once

#include "core/base/result.h"
#include "core/mapping/uv_mapping.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace trixel {

struct TileFile
{
    UdimTile tile;
    std::filesystem::path path;

    bool operator==(const TileFile&) const = default;
};

/// The files that a name stands for, in the order of their tiles: where its last part holds
/// "<UDIM>", one for each tile number found in its place; else the file itself, as tile 1001,
/// whether or not it is there. Fails if the folder cannot be read or there is no file for any tile.
Result<std::vector<TileFile>> tileFiles(const std::filesystem::path& name);

/// The name with "<UDIM>" in the place of its tile number; nothing where the last part of the path
/// has none (four digits from 1001 on, with a dot, an underscore or a minus at both sides).
std::optional<std::filesystem::path> tilePattern(const std::filesystem::path& file);

} // namespace trixel
