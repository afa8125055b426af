// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/atlas/packed_pages.h"

#include "core/atlas/atlas_texels.h"
#include "core/mesh/face_pieces.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace trixel {

namespace {

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

    /// Fails when cancelled and when memory runs out.
    Status fill(const AtlasTexels& texels, Threads threads, Progress& progress)
    {
        const Level level = texels.level();
        const std::uint32_t firstRank = m_layout.options().mips ? 0 : m_layout.finerFaces(level);
        return forWholeFaces(
            m_layout.tileCount(level),
            [&](FaceId) -> std::uint64_t { return level.texelCount(); },
            threads,
            progress,
            [&](FaceId k) {
                fill(texels,
                     m_layout.faceOfRank(firstRank + static_cast<std::uint32_t>(indexOf(k))));
            });
    }

    /// Whether any level coarser than this one has tiles.
    bool goesOnBelow(Level level) const
    {
        while (level > Level()) {
            level = level.coarser();
            if (m_layout.tileCount(level) > 0) {
                return true;
            }
        }
        return false;
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
        // Each level has a quarter of the work of the one before, half of it reducing.
        const bool isLast = !tiles.goesOnBelow(texels.level());
        const double end = isLast ? 1 : done + 0.75 * (1 - done);
        const double middle = isLast ? 1 : 0.5 * (done + end);
        StageProgress filling(progress, done, middle);
        StageProgress reducing(progress, middle, end);
        done = end;
        if (Status filled = tiles.fill(texels, threads, filling); !filled) {
            return tl::unexpected(filled.error());
        }
        if (isLast) {
            break;
        }
        if (Status reduced = texels.coarsen(threads, reducing); !reduced) {
            return tl::unexpected(reduced.error());
        }
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
    std::vector<FaceTexels> made(faces.size());
    const Status done = forWholeFaces(
        faces.size(),
        [&](FaceId face) -> std::uint64_t { return faces[face].level.texelCount(); },
        threads,
        progress,
        [&](FaceId face) {
            made[indexOf(face)] = unpackedFace(faces[face], border, pages[faces[face].place.page]);
        });
    if (!done) {
        return tl::unexpected(done.error());
    }
    for (std::size_t f = 0; f < made.size(); ++f) {
        store.exchange(faceId(f), std::move(made[f]));
    }
    if (!progress.report(1)) {
        return cancelled();
    }
    return store;
}

} // namespace trixel
