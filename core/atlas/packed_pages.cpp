// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/atlas/packed_pages.h"

#include "core/atlas/atlas_texels.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace trixel {

namespace {

constexpr std::size_t kFacesAtOnce = 4096;
constexpr std::size_t kGrain = 16;

/// Tiles of the level that the texels are at.
class LevelTiles
{
public:
    LevelTiles(const AtlasLayout& layout, std::vector<Image>& pages)
        : m_layout(layout)
    {
        for (Image& page : pages) {
            m_strides.push_back(static_cast<std::size_t>(page.width()) *
                                page.format().texelBytes());
            m_pixels.push_back(page.writable());
        }
    }

    /// False when cancelled.
    bool fill(const AtlasTexels& texels, Threads threads, Progress& progress)
    {
        const Level level = texels.level();
        const std::uint32_t tiles = m_layout.tileCount(level);
        const std::uint32_t firstRank = m_layout.options().mips ? 0 : m_layout.finerFaces(level);
        for (std::uint32_t first = 0; first < tiles; first += kFacesAtOnce) {
            if (!progress.report(static_cast<double>(first) / tiles)) {
                return false;
            }
            const std::size_t some = std::min<std::size_t>(kFacesAtOnce, tiles - first);
            parallelFor(some, kGrain, threads, [&](std::size_t begin, std::size_t end) {
                for (std::size_t k = begin; k < end; ++k) {
                    fill(texels,
                         m_layout.faceOfRank(firstRank + first + static_cast<std::uint32_t>(k)));
                }
            });
        }
        return progress.report(1);
    }

private:
    void fill(const AtlasTexels& texels, FaceId face)
    {
        const AtlasPlace place = m_layout.place(face, texels.level());
        const std::size_t stride = m_strides[place.page];
        std::byte* first = m_pixels[place.page].data() + place.origin.y * stride +
                           place.origin.x * texels.format().texelBytes();
        texels.fill(face, m_layout.tile(texels.level()), first, stride);
    }

    const AtlasLayout& m_layout;
    std::vector<std::span<std::byte>> m_pixels; ///< of each page
    std::vector<std::size_t> m_strides;         ///< bytes of a row
};

FaceTexels unpackedFace(const PackedFace& face, AtlasBorder border, const Image& page)
{
    const AtlasTile tile(face.level, border);
    check(face.place.origin.x + tile.side() <= static_cast<std::uint32_t>(page.width()) &&
              face.place.origin.y + tile.side() <= static_cast<std::uint32_t>(page.height()),
          "a tile on its page");
    const std::size_t bytes = page.format().texelBytes();
    std::vector<std::byte> texels(face.level.texelCount() * bytes);
    for (std::uint32_t k = 0; k < face.level.texelCount(); ++k) {
        const TexelCoord at = texelAt(face.level, TexelIndex(k));
        const AtlasPixel pixel = tile.pixel({at.i, at.j, at.half});
        const auto value =
            pixelOf(page, {face.place.origin.x + pixel.x, face.place.origin.y + pixel.y});
        std::memcpy(texels.data() + k * bytes, value.data(), bytes);
    }
    return FaceTexels::full(face.level, bytes, texels).collapsed();
}

} // namespace

Result<std::vector<Image>> packedPages(const AtlasLayout& layout,
                                       const TexelStore& store,
                                       const Adjacency& adjacency,
                                       const std::vector<ColorSpace>& colors,
                                       Threads threads,
                                       Progress& progress)
{
    check(layout.faceCount() == store.faceCount(), "a layout of these faces");
    std::vector<Image> pages = emptyPages(layout.pages(), store.format(), colors);
    if (store.faceCount() == 0) {
        return pages;
    }
    LevelTiles tiles(layout, pages);
    AtlasTexels texels(store, adjacency);
    double done = 0;
    while (true) {
        // Each level has a quarter of the work of the one before.
        StageProgress stage(
            progress, done, texels.level() == Level() ? 1 : done + 0.75 * (1 - done));
        done += 0.75 * (1 - done);
        if (!tiles.fill(texels, threads, stage)) {
            return cancelled();
        }
        if (texels.level() == Level()) {
            break;
        }
        texels.coarsen(threads);
    }
    if (const Status whole = store.checkWhole(); !whole) {
        return tl::unexpected(whole.error());
    }
    return pages;
}

FaceMap<PackedFace> packedFaces(const AtlasLayout& layout)
{
    FaceMap<PackedFace> faces(layout.faceCount());
    for (std::size_t f = 0; f < layout.faceCount(); ++f) {
        const FaceId face = faceId(f);
        faces[face] = {layout.level(face), layout.place(face, layout.level(face))};
    }
    return faces;
}

Result<TexelStore> unpackedFaces(const FaceMap<PackedFace>& faces,
                                 AtlasBorder border,
                                 std::span<const Image> pages,
                                 Threads threads,
                                 Progress& progress)
{
    check(faces.size() == 0 || !pages.empty(), "pages of the faces");
    const TexelFormat format = pages.empty() ? TexelFormat{} : pages.front().format();
    TexelStore store(static_cast<std::uint32_t>(faces.size()),
                     format,
                     Level(),
                     std::vector<std::byte>(format.texelBytes()));
    std::vector<FaceTexels> some;
    for (std::size_t first = 0; first < faces.size(); first += kFacesAtOnce) {
        if (!progress.report(static_cast<double>(first) / static_cast<double>(faces.size()))) {
            return cancelled();
        }
        some.assign(std::min(kFacesAtOnce, faces.size() - first), {});
        parallelFor(some.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                const PackedFace& face = faces[faceId(first + k)];
                some[k] = unpackedFace(face, border, pages[face.place.page]);
            }
        });
        for (std::size_t k = 0; k < some.size(); ++k) {
            store.exchange(faceId(first + k), std::move(some[k]));
        }
    }
    if (!progress.report(1)) {
        return cancelled();
    }
    return store;
}

} // namespace trixel
