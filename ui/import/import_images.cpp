// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/import_images.h"

#include "core/io/image/read_image.h"
#include "core/io/image/tile_files.h"
#include "ui/import/image_thumbnail.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace trixel::ui {

namespace {

constexpr int kSmall = 512;

/// One channel alone, as an image of its own.
Image channelOf(const Image& image, std::uint16_t channel)
{
    const TexelFormat format{image.format().type, 1, std::nullopt};
    Image one(image.width(), image.height(), format, {image.colors()[channel]});
    const std::size_t bytes = format.texelBytes();
    const std::size_t stride = image.format().texelBytes();
    const std::byte* from = image.pixels().data() + channel * bytes;
    const std::span<std::byte> target = one.writable();
    for (std::size_t at = 0; at < target.size(); at += bytes, from += stride) {
        std::memcpy(target.data() + at, from, bytes);
    }
    return one;
}

Image asDeclared(const Image& image, const ImportSettings& settings)
{
    const Image chosen = settings.channel && *settings.channel < image.format().channels
                             ? channelOf(image, *settings.channel)
                             : image;
    if (!settings.color) {
        return chosen;
    }
    const TexelFormat& format = chosen.format();
    return chosen.declared(uniformColors(*settings.color, format.channels, format.alpha));
}

} // namespace

Result<std::shared_ptr<const ImportImages>> readImportImages(const std::filesystem::path& path,
                                                             Progress& progress)
{
    const auto files = tileFiles(path);
    if (!files) {
        return tl::unexpected(files.error());
    }
    const ImageWorker worker;
    auto read = std::make_shared<ImportImages>();
    read->path = path;
    const double part = 1.0 / static_cast<double>(files->size());
    for (const TileFile& file : *files) {
        const double done = part * static_cast<double>(read->images.size());
        StageProgress stage(progress, done, done + part);
        auto image = readImage(worker, file.path, stage);
        if (!image) {
            return tl::unexpected(image.error());
        }
        read->images.push_back({file.tile, std::move(*image), file.path.filename().string()});
    }
    read->small = thumbnailOf(read->first(), kSmall);
    return std::shared_ptr<const ImportImages>(std::move(read));
}

Result<std::shared_ptr<const ImageTiles>>
ImportSamplers::make(const std::shared_ptr<const ImportImages>& images,
                     const ImportSettings& settings,
                     Progress& progress)
{
    const bool isUvs = settings.kind == MapKind::Uvs;
    // Round a sphere the image goes on by itself.
    const bool repeatsS = settings.kind == MapKind::Sphere || (isUvs && settings.repeats);
    const bool repeatsT = isUvs && settings.repeats;
    const Key key{images,
                  settings.lookup,
                  settings.index,
                  repeatsS,
                  repeatsT,
                  settings.color,
                  settings.channel};
    const std::lock_guard lock(m_mutex);
    if (m_tiles && m_key == key) {
        return m_tiles;
    }
    SamplerOptions options;
    options.lookup = settings.lookup;
    options.index = settings.index;
    options.wrapS = repeatsS ? ImageWrap::Repeat : ImageWrap::Clamp;
    options.wrapT = repeatsT ? ImageWrap::Repeat : ImageWrap::Clamp;
    std::vector<TileImage> declared;
    for (const TileImage& one : images->images) {
        declared.push_back({one.tile, asDeclared(one.image, settings), one.name});
    }
    auto made = ImageTiles::make(std::move(declared), options, Threads::all(), progress);
    if (!made) {
        return tl::unexpected(made.error());
    }
    m_key = key;
    m_tiles = std::make_shared<const ImageTiles>(std::move(*made));
    return m_tiles;
}

} // namespace trixel::ui
