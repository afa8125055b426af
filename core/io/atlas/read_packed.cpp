// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/read_file.h"
#include "core/io/atlas/atlas_description.h"
#include "core/io/atlas/export_atlas.h"
#include "core/io/image/decode_image.h"
#include "core/texture/convert.h"

#include <algorithm>
#include <utility>

namespace trixel {

namespace {

Result<Image> readPage(const ImageWorker& worker,
                       const std::filesystem::path& path,
                       const AtlasDescription& atlas,
                       const AtlasPage& size,
                       Progress& progress)
{
    ImageLimits limits;
    limits.mostChannels = TexelFormat::kMaxChannels;
    // As large as the description says, and no larger.
    limits.mostBytes = std::uint64_t{size.width} * size.height * atlas.format.channels *
                       byteSize(TexelType::Float);
    limits.memoryBytes = std::max(limits.memoryBytes, 3 * limits.mostBytes);
    auto page = decodeImageFile(worker, path, {}, progress, limits);
    if (!page) {
        return tl::unexpected(page.error());
    }
    const auto found = [](std::int64_t width, std::int64_t height, int channels) {
        return std::to_string(width) + " × " + std::to_string(height) + " pixels of " +
               std::to_string(channels) + " channels";
    };
    if (page->width != static_cast<int>(size.width) ||
        page->height != static_cast<int>(size.height) ||
        page->format.channels != atlas.format.channels) {
        return contentsError(path.string() + ": expected " +
                             found(size.width, size.height, atlas.format.channels) + ", found " +
                             found(page->width, page->height, page->format.channels));
    }
    // Which channel is opacity, and what the others mean, not every image format can say.
    const TexelFormat format{page->format.type, page->format.channels, atlas.format.alpha};
    return Image::adopt(page->width, page->height, format, atlas.colors, std::move(page->pixels));
}

} // namespace

Result<ReadAtlas> readPackedAtlas(const ImageWorker& worker,
                                  const std::filesystem::path& path,
                                  Threads threads,
                                  Progress& progress)
{
    const auto text = readFile(path);
    if (!text) {
        return tl::unexpected(text.error());
    }
    auto atlas = parseAtlasDescription(*text);
    if (!atlas) {
        return prefixed(path.string(), atlas.error());
    }
    std::vector<Image> pages;
    for (std::size_t k = 0; k < atlas->pages.size(); ++k) {
        const auto part = [&](std::size_t done) {
            return 0.8 * static_cast<double>(done) / static_cast<double>(atlas->pages.size());
        };
        StageProgress stage(progress, part(k), part(k + 1));
        const AtlasPageFile& file = atlas->pages[k];
        auto page = readPage(worker, path.parent_path() / file.file, *atlas, file.size, stage);
        if (!page) {
            return tl::unexpected(page.error());
        }
        if (!pages.empty() && page->format() != pages.front().format()) {
            return contentsError((path.parent_path() / file.file).string() +
                                 ": its pixels are of another type than those of the first page");
        }
        pages.push_back(std::move(*page));
    }
    StageProgress taking(progress, 0.8, 0.9);
    const auto texels = unpackedFaces(atlas->faces, atlas->border, pages, threads, taking);
    if (!texels) {
        return tl::unexpected(texels.error());
    }
    StageProgress converting(progress, 0.9, 1);
    auto store = converted(*texels, atlas->format.type, threads, converting);
    if (!store) {
        return tl::unexpected(store.error());
    }
    return ReadAtlas{std::move(*store), std::move(atlas->colors)};
}

} // namespace trixel
