// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/display_atlas.h"

#include "core/base/check.h"
#include "core/base/parallel.h"
#include "core/texture/face_vertices.h"
#include "core/texture/mips.h"

#include <algorithm>
#include <utility>

namespace trixel::render {

namespace {

/// Of the time before the first tile, about.
constexpr double kStoreShare = 0.5;

/// The store as the atlas shows it: coarser, and single texels where that says all.
Result<TexelStore>
shownStore(const FilterMesh& mesh, const TexelStore& store, int drop, Progress& progress)
{
    ChainCache none({0, 1, 2, -1}, 0);
    const FaceMips mips(store, none);
    const FaceVertices about(mips, mesh.adjacency(), mesh.rings());
    TexelStore shown = store;
    for (std::size_t f = 0; f < store.faceCount(); ++f) {
        if (!progress.report(static_cast<double>(f) / static_cast<double>(store.faceCount()))) {
            return cancelled();
        }
        const FaceTexels& face = store.face(faceId(f));
        if (about.isConstant(faceId(f))) {
            shown.exchange(faceId(f), face.atLevel(Level(0)));
        } else if (drop > 0) {
            shown.exchange(faceId(f), reduced(store.format(), face, drop));
        }
    }
    return shown;
}

} // namespace

Status DisplayAtlas::reset(std::shared_ptr<const FilterMesh> mesh,
                           const TexelStore& store,
                           int mipDrop,
                           std::uint64_t maxBytes,
                           Progress& progress)
{
    check(mesh->faceCount() == store.faceCount(), "texels of this mesh");
    m_mesh = std::move(mesh);
    m_format = displayFormat(store.format().type);
    m_drop = mipDrop;
    m_nextFace = 0;
    m_fresh = true;
    m_isReduced = false;
    m_touched.clear();
    StageProgress showing(progress, 0, kStoreShare);
    auto shown = shownStore(*m_mesh, store, mipDrop, showing);
    if (!shown) {
        return tl::unexpected(shown.error());
    }
    m_texels.emplace(std::move(*shown), m_mesh->adjacency());
    // Each level takes a quarter of the time of the one before.
    auto coarsen = [&, done = kStoreShare]() mutable {
        const double begin = std::exchange(done, 1 - (1 - done) / 4);
        StageProgress coarsening(progress, begin, done);
        return m_texels->coarsen(Threads::all(), coarsening);
    };

    const std::uint64_t layerBytes = std::uint64_t{kLayerSize} * kLayerSize * texelBytes(m_format);
    const std::uint64_t most = std::clamp<std::uint64_t>(maxBytes / layerBytes, 1, kMostLayers);
    AtlasOptions options;
    options.largestPage = kLayerSize;
    const auto plan = [&] {
        FaceMap<Level> levels(store.faceCount());
        for (std::size_t f = 0; f < store.faceCount(); ++f) {
            levels[faceId(f)] = m_texels->levelOf(faceId(f));
        }
        return AtlasLayout::plan(levels, options);
    };
    while (m_texels->level() > Level(kFinest)) {
        if (Status coarser = coarsen(); !coarser) {
            return coarser;
        }
    }
    auto layout = plan();
    while ((!layout || layout->pages().size() > most) && m_texels->level() > Level(0)) {
        m_isReduced = true;
        if (Status coarser = coarsen(); !coarser) {
            return coarser;
        }
        layout = plan();
    }
    check(layout.has_value(), "room for tiles of single texels");
    m_layout.emplace(std::move(*layout));
    m_records.assign(store.faceCount(), FaceRecord{});
    for (std::size_t f = 0; f < store.faceCount(); ++f) {
        const Level level = m_texels->levelOf(faceId(f));
        const AtlasPlace place = m_layout->place(faceId(f), level);
        const auto number = static_cast<std::uint32_t>(level.log2());
        const auto own =
            static_cast<std::uint32_t>(store.face(faceId(f)).level().coarser(mipDrop).log2());
        m_records[f] = {place.origin.x | (place.origin.y << 12U) | (place.page << 24U),
                        number | (own << FaceRecord::kOwnShift)};
    }
    return {};
}

bool DisplayAtlas::touch(const TexelStore& store, std::span<const TouchedRect> rects)
{
    for (const TouchedRect& rect : rects) {
        const FaceTexels& face = store.face(rect.face);
        const Level shown = m_texels->levelOf(rect.face);
        if (shown != face.level().coarser(m_drop)) {
            return false; // it was a single texel, or is shown coarser than others
        }
        if (rect.wholeFace && aConstantNeighbourIsAbout(store, rect.face)) {
            return false; // as one texel it can't end where the new paint does
        }
        m_texels->replace(rect.face, m_drop > 0 ? reduced(store.format(), face, m_drop) : face);
        const VertexRings& rings = m_mesh->rings();
        for (std::uint8_t corner = 0; corner < 3; ++corner) {
            for (const Corner& other : rings.corners(rings.ring({rect.face, corner}))) {
                m_touched.insert(static_cast<std::uint32_t>(other.face));
            }
        }
    }
    return true;
}

/// Whether a face that shares a vertex is shown by a single texel, or coarser than its own level.
bool DisplayAtlas::aConstantNeighbourIsAbout(const TexelStore& store, FaceId face) const
{
    const VertexRings& rings = m_mesh->rings();
    for (std::uint8_t corner = 0; corner < 3; ++corner) {
        for (const Corner& other : rings.corners(rings.ring({face, corner}))) {
            if (m_texels->levelOf(other.face) != store.face(other.face).level().coarser(m_drop)) {
                return true;
            }
        }
    }
    return false;
}

void DisplayAtlas::showChannels(const CardChannels& channels)
{
    if (channels != m_channels) {
        m_channels = channels;
        m_nextFace = 0;
    }
}

bool DisplayAtlas::hasWork() const
{
    return m_fresh || !m_touched.empty() || m_nextFace < m_records.size();
}

AtlasUpdate DisplayAtlas::take(const TexelStore& /*store*/, std::size_t byteBudget)
{
    AtlasUpdate update;
    update.fresh = std::exchange(m_fresh, false);
    update.layers = static_cast<std::uint32_t>(m_layout->pages().size());
    for (const std::uint32_t face : std::exchange(m_touched, {})) {
        if (face < m_nextFace) {
            emitFace(faceId(face), update);
        }
    }
    const std::size_t first = m_nextFace;
    while (m_nextFace < m_records.size() &&
           (m_nextFace == first || update.bytes.size() < byteBudget)) {
        emitFace(faceId(m_nextFace++), update);
    }
    if (m_nextFace > first) {
        update.records.push_back(
            {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(m_nextFace - first)});
    }
    return update;
}

void DisplayAtlas::emitFace(FaceId face, AtlasUpdate& update) const
{
    const AtlasTile tile = m_layout->tile(m_texels->levelOf(face));
    const AtlasPlace place = m_layout->place(face, m_texels->levelOf(face));
    const TexelFormat& format = m_texels->format();
    const std::size_t stride = tile.side() * format.texelBytes();
    std::vector<std::byte> pixels(tile.side() * stride);
    m_texels->fill(face, tile, pixels.data(), stride);
    update.tiles.push_back({place.origin.x, place.origin.y, place.page, tile.side()});
    appendShown(format, m_channels, pixels, update.bytes);
}

} // namespace trixel::render
