// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mapping/image_tiles.h"
#include "ui/import/import_settings.h"

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace trixel::ui {

/// The image of a file, or one for each tile.
struct ImportImages
{
    std::filesystem::path path; ///< as it was asked for
    std::vector<TileImage> images;
    QImage small; ///< the first, for the eye

    const Image& first() const { return images.front().image; }
    bool hasTiles() const { return images.size() > 1 || images.front().tile != UdimTile{}; }
};

/// Errors name the file. \param path  "<UDIM>" in its name stands for the tiles' numbers
Result<std::shared_ptr<const ImportImages>> readImportImages(const std::filesystem::path& path,
                                                             Progress& progress);

/// The images as they are looked up, made once for each way of looking them up. Calls may come from
/// several threads, which wait for each other.
class ImportSamplers
{
public:
    /// \param images  stay the same as long as the pointer does
    Result<std::shared_ptr<const ImageTiles>>
    make(const std::shared_ptr<const ImportImages>& images,
         const ImportSettings& settings,
         Progress& progress);

private:
    struct Key
    {
        std::shared_ptr<const ImportImages> images;
        ImageLookup lookup{};
        TableIndex index{};
        bool repeatsS = false;
        bool repeatsT = false;
        std::optional<ColorSpace> color;
        std::optional<std::uint16_t> channel;

        bool operator==(const Key&) const = default;
    };

    std::mutex m_mutex;
    Key m_key;
    std::shared_ptr<const ImageTiles> m_tiles;
};

} // namespace trixel::ui
