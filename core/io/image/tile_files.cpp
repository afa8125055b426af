// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/image/tile_files.h"

#include <algorithm>
#include <string_view>
#include <system_error>

namespace trixel {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kUdim = "<UDIM>";
constexpr std::size_t kDigits = 4;

/// Of four digits.
std::optional<UdimTile> tileOf(std::string_view digits)
{
    const bool isNumber =
        std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
    return isNumber ? udimTile(std::stoi(std::string(digits))) : std::nullopt;
}

} // namespace

Result<std::vector<TileFile>> tileFiles(const fs::path& whole)
{
    const std::string name = whole.filename().string();
    const std::size_t at = name.find(kUdim);
    if (at == std::string::npos) {
        return std::vector<TileFile>{{UdimTile{}, whole}};
    }
    const std::string before = name.substr(0, at);
    const std::string after = name.substr(at + kUdim.size());
    const fs::path folder = whole.has_parent_path() ? whole.parent_path() : fs::path(".");
    std::vector<TileFile> tiles;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string file = entry->path().filename().string();
        if (file.size() != before.size() + kDigits + after.size() || !file.starts_with(before) ||
            !file.ends_with(after)) {
            continue;
        }
        if (const auto tile = tileOf(std::string_view(file).substr(before.size(), kDigits))) {
            tiles.push_back({*tile, entry->path()});
        }
    }
    if (error) {
        return pathError(folder.string() + ": cannot be read: " + error.message());
    }
    if (tiles.empty()) {
        return pathError(whole.string() + ": there is no such file for any tile from 1001 on");
    }
    std::sort(tiles.begin(), tiles.end(), [](const TileFile& a, const TileFile& b) {
        return a.tile < b.tile;
    });
    return tiles;
}

std::optional<fs::path> tilePattern(const fs::path& file)
{
    constexpr std::string_view kAround = "._-";
    const std::string name = file.filename().string();
    for (std::size_t at = name.size(); at-- > 1;) { // the last number is the tile's
        if (at + kDigits < name.size() && kAround.find(name[at - 1]) != std::string_view::npos &&
            kAround.find(name[at + kDigits]) != std::string_view::npos &&
            tileOf(std::string_view(name).substr(at, kDigits))) {
            return file.parent_path() /
                   (name.substr(0, at) + std::string(kUdim) + name.substr(at + kDigits));
        }
    }
    return std::nullopt;
}

} // namespace trixel
