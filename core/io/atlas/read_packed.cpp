// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/read_file.h"
#include "core/io/atlas/atlas_description.h"
#include "core/io/atlas/export_atlas.h"
#include "core/io/image/read_image.h"
#include "core/texture/convert.h"

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
    auto page = readImage(worker, path, progress, limits);
    if (!page) {
        return page;
    }
    const auto found = [](std::int64_t width, std::int64_t height, int channels) {
        return std::to_string(width) + " × " + std::to_string(height) + " pixels of " +
               std::to_string(channels) + " channels";
    };
    if (page->width() != static_cast<int>(size.width) ||
        page->height() != static_cast<int>(size.height) ||
        page->format().channels != atlas.format.channels) {
        return contentsError(path.string() + ": expected " +
                             found(size.width, size.height, atlas.format.channels) + ", found " +
                             found(page->width(), page->height(), page->format().channels));
    }
    return page;
}

} // namespace

Result<TexelStore> readPackedAtlas(const ImageWorker& worker,
                                   const std::filesystem::path& path,
                                   Threads threads,
                                   Progress& progress)
{
    const auto text = readFile(path);
    if (!text) {
        return tl::unexpected(text.error());
    }
    const auto atlas = parseAtlasDescription(*text);
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
        return texels;
    }
    StageProgress converting(progress, 0.9, 1);
    return converted(*texels, atlas->format.type, threads, converting);
}

} // namespace trixel
