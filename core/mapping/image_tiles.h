// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/image/image_sampler.h"
#include "core/mapping/uv_mapping.h"

#include <cstdint>
#include <string>
#include <vector>

namespace trixel {

/// One image of a set, and the tile it fills.
struct TileImage
{
    UdimTile tile;
    Image image;
    std::string name; ///< for errors
};

/// The images that a surface takes its colours from: one, or one for each tile. Const calls may
/// come from several threads.
class ImageTiles
{
public:
    /// Fails, naming the image, if two are of one tile or differ in their channels.
    /// \param images  at least one (checked); one alone of tile 1001 is a single image, which goes
    ///                on beyond the unit square as `options` say
    static Result<ImageTiles>
    make(std::vector<TileImage> images, const SamplerOptions& options, Threads threads);
    /// The same for long work. Fails when cancelled, too, and when an image does not fit into
    /// memory. Each image is given back as soon as its samplers are made.
    static Result<ImageTiles> make(std::vector<TileImage> images,
                                   const SamplerOptions& options,
                                   Threads threads,
                                   Progress& progress);

    /// Tiles that there is an image for, ascending.
    std::vector<UdimTile> tiles() const;
    /// Channels but for the opacity, and what they mean.
    const std::vector<ColorSpace>& colors() const { return m_colors; }
    bool hasOpacity() const { return m_hasOpacity; }
    /// Three colours each.
    std::size_t groups() const { return (m_colors.size() + 2) / 3; }

    /// Colours of a group times the opacity, and the opacity; all 0 where no tile is.
    glm::vec4 at(glm::dvec2 st, const Footprint& footprint, std::size_t group) const;

private:
    struct Tile
    {
        UdimTile tile;
        std::vector<ImageSampler> groups;
    };

    bool m_isSingle = true;
    bool m_hasOpacity = false;
    std::vector<ColorSpace> m_colors;
    std::vector<Tile> m_tiles;
};

} // namespace trixel
