// SPDX-License-Identifier: GPL-3.0-or-later
//
// The packed atlas of core/atlas on the graphics card. Plain data, no OpenGL.
#pragma once

#include "core/atlas/atlas_layout.h"
#include "core/atlas/atlas_texels.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "render/display_texels.h"
#include "render/filter_mesh.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <unordered_set>
#include <vector>

namespace trixel::render {

/// What to send to the card: room, tiles, records.
struct AtlasUpdate
{
    /// A square of pixels of one layer.
    struct Tile
    {
        std::uint32_t x = 0, y = 0, layer = 0, size = 0;
    };

    bool fresh = false;       ///< nothing that was on the card is needed any more
    std::uint32_t layers = 0; ///< that there must be room for
    std::vector<Tile> tiles;  ///< their bytes follow each other in `bytes`
    std::vector<std::byte> bytes;
    std::vector<DisplayUpdate::Range> records;
};

/// A store's faces in an atlas whose pages are layers of one array of textures. A record's offset
/// is x, y (12 bits each) and layer. A face that is one constant with all about it has the tile of
/// a single texel. For comparison with better ways: it takes 1.1 (level 6) to 2.3 (level 3) pixels
/// a texel, and keeps a snapshot of the store.
class DisplayAtlas
{
public:
    /// Pixels along a side of a layer: tiles of every level fill it well.
    static constexpr std::uint32_t kLayerSize = 2080;
    static constexpr int kFinest = 11; ///< that fits into it
    static constexpr std::uint32_t kMostLayers = 255;

    /// Starts over with a store. Fails when cancelled and when memory runs out; then it is of no
    /// use before the next time.
    /// \param mipDrop   show every face this many levels coarser
    /// \param maxBytes  of all layers; finer faces are shown coarser to fit
    Status reset(std::shared_ptr<const FilterMesh> mesh,
                 const TexelStore& store,
                 int mipDrop,
                 std::uint64_t maxBytes,
                 Progress& progress);
    /// Whether finer faces are shown coarser to fit.
    bool isReduced() const { return m_isReduced; }

    /// Notes that texels changed. \return  false where the layout does not fit them any more
    bool touch(const TexelStore& store, std::span<const TouchedRect> rects);
    /// The same where every texel may have changed: the layout is of no more use.
    static constexpr bool touchAll() { return false; }
    /// Sends other channels from now on, and all tiles anew where they are others.
    void showChannels(const CardChannels& channels);

    /// Makes what is to be sent next, as `DisplayTexels::take`.
    AtlasUpdate take(const TexelStore& store, std::size_t byteBudget);
    bool hasWork() const;

    DisplayFormat format() const { return m_format; }
    std::span<const FaceRecord> records() const { return m_records; }

private:
    bool aConstantNeighbourIsAbout(const TexelStore& store, FaceId face) const;
    void emitFace(FaceId face, AtlasUpdate& update) const;

    std::shared_ptr<const FilterMesh> m_mesh;
    DisplayFormat m_format = DisplayFormat::Rgba8;
    CardChannels m_channels{0, 1, 2, -1};
    int m_drop = 0;
    bool m_fresh = false;
    bool m_isReduced = false;
    std::optional<AtlasTexels> m_texels;
    std::optional<AtlasLayout> m_layout;
    std::vector<FaceRecord> m_records;
    std::size_t m_nextFace = 0;
    std::unordered_set<std::uint32_t> m_touched;
};

} // namespace trixel::render
