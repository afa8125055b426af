// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mapping/image_tiles.h"

#include "core/base/check.h"

#include <algorithm>
#include <utility>

namespace trixel {

namespace {

/// Channels of an image that are colours.
std::vector<std::uint16_t> colorChannels(const TexelFormat& format)
{
    std::vector<std::uint16_t> channels;
    for (std::uint16_t c = 0; c < format.channels; ++c) {
        if (format.alpha != c) {
            channels.push_back(c);
        }
    }
    if (channels.empty()) {
        channels.push_back(0); // opacity alone is its own colour
    }
    return channels;
}

std::vector<ColorSpace> colorsOf(const Image& image)
{
    std::vector<ColorSpace> colors;
    for (const std::uint16_t channel : colorChannels(image.format())) {
        colors.push_back(image.colors()[channel]);
    }
    return colors;
}

Result<std::vector<ImageSampler>>
samplersOf(const Image& image, const SamplerOptions& options, Threads threads, Progress& progress)
{
    const std::vector<std::uint16_t> channels = colorChannels(image.format());
    const auto channel = [&](std::size_t k) { return channels[std::min(k, channels.size() - 1)]; };
    const auto part = [&](std::size_t k) {
        return std::min(1.0, static_cast<double>(k) / static_cast<double>(channels.size()));
    };
    std::vector<ImageSampler> groups;
    for (std::size_t k = 0; k < channels.size(); k += 3) {
        StageProgress stage(progress, part(k), part(k + 3));
        auto made = ImageSampler::make(
            image, std::array{channel(k), channel(k + 1), channel(k + 2)}, options, threads, stage);
        if (!made) {
            return tl::unexpected(made.error());
        }
        groups.push_back(std::move(*made));
    }
    return groups;
}

} // namespace

Result<ImageTiles>
ImageTiles::make(std::vector<TileImage> images, const SamplerOptions& options, Threads threads)
{
    NoProgress progress;
    return make(std::move(images), options, threads, progress);
}

Result<ImageTiles> ImageTiles::make(std::vector<TileImage> images,
                                    const SamplerOptions& options,
                                    Threads threads,
                                    Progress& progress)
{
    check(!images.empty(), "at least one image");
    std::sort(images.begin(), images.end(), [](const TileImage& a, const TileImage& b) {
        return a.tile < b.tile;
    });
    ImageTiles set;
    set.m_isSingle = images.size() == 1 && images.front().tile == UdimTile{};
    set.m_colors = colorsOf(images.front().image);
    set.m_hasOpacity = images.front().image.format().alpha.has_value();
    SamplerOptions inTile = options;
    if (!set.m_isSingle) {
        inTile.wrapS = inTile.wrapT = ImageWrap::Clamp;
    }
    for (TileImage& one : images) {
        if (!set.m_tiles.empty() && set.m_tiles.back().tile == one.tile) {
            return contentsError(one.name + ": there is another image for tile " +
                                 std::to_string(one.tile.number()));
        }
        if (colorsOf(one.image) != set.m_colors) {
            return contentsError(one.name + ": its channels differ from those of " +
                                 images.front().name);
        }
        const auto part = [&](std::size_t done) {
            return static_cast<double>(done) / static_cast<double>(images.size());
        };
        StageProgress stage(progress, part(set.m_tiles.size()), part(set.m_tiles.size() + 1));
        auto groups = samplersOf(one.image, inTile, threads, stage);
        if (!groups) {
            return groups.error().kind == ErrorKind::Cancelled ? cancelled()
                                                               : prefixed(one.name, groups.error());
        }
        set.m_tiles.push_back({one.tile, std::move(*groups)});
        one.image = {}; // its float levels stay; not both
    }
    return set;
}

std::vector<UdimTile> ImageTiles::tiles() const
{
    std::vector<UdimTile> tiles;
    for (const Tile& tile : m_tiles) {
        tiles.push_back(tile.tile);
    }
    return tiles;
}

glm::vec4 ImageTiles::at(glm::dvec2 st, const Footprint& footprint, std::size_t group) const
{
    if (m_isSingle) {
        return m_tiles.front().groups[group].at(st, footprint);
    }
    const auto place = udimTileAt(st);
    const auto found =
        place ? std::lower_bound(m_tiles.begin(),
                                 m_tiles.end(),
                                 *place,
                                 [](const Tile& tile, UdimTile t) { return tile.tile < t; })
              : m_tiles.end();
    if (found == m_tiles.end() || !(found->tile == *place)) {
        return glm::vec4(0);
    }
    return found->groups[group].at(st - glm::dvec2(place->column, place->row), footprint);
}

} // namespace trixel
