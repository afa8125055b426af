// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/filter/filter_scene.h"
#include "core/image/image.h"
#include "core/mapping/uv_mapping.h"
#include "core/mesh/triangle_mesh.h"
#include "core/texture/texel_store.h"

#include <cstdint>
#include <vector>

namespace trixel {

/// An image of the texels by the mesh's own uvs: what of it, how large, and how stored.
struct UvImageOptions
{
    int width = 2048;
    int height = 2048;
    UdimTile tile;
    /// Pixels beyond a face's uvs that take what lies there on the surface: the true neighbour's
    /// texels, where there is one. They keep seams away from as many halvings as 2^n <= gutter.
    int gutter = 16;
    TexelType type = TexelType::UInt8;
    /// What the image's channels are to mean, one each; those of the scene are linear light (or
    /// raw, which passes).
    std::vector<ColorSpace> colors;
    Threads threads = Threads::all();
};

struct UvImage
{
    Image image;
    std::uint64_t insidePixels = 0; ///< whose centres lie in a face's uvs
    std::uint64_t gutterPixels = 0; ///< that took what lies beyond
    /// Faces with uvs in the tile that hold no pixel's centre: what is on them is lost.
    std::uint32_t facesWithoutPixel = 0;
};

/// Tiles that the mesh's uvs reach, ascending. Fails if it has none (`checkUvs`), or beyond all
/// tiles.
Result<std::vector<UdimTile>> uvTiles(const TriangleMesh& mesh);

/// The store as floats in linear light, to be filtered as such; itself where nothing is declared to
/// be otherwise. Fails only when cancelled or when a face cannot be read.
/// \param colors  what the channels mean; empty: as they are
Result<TexelStore> linearStore(const TexelStore& store,
                               const std::vector<ColorSpace>& colors,
                               Threads threads,
                               Progress& progress);

/// Draws the image. Each pixel is what its footprint on the surface averages: between texels where
/// it is smaller than two of them, else a Gaussian over them. What neither lies in uvs nor in the
/// gutter goes over smoothly into what does, so that coarser levels mix in nothing foreign; so do
/// the colours of what no opacity shows, for programs that look up colours on their own.
/// Fails when cancelled; when the mesh has no uvs; and when the image is too small, so that no face
/// holds a pixel's centre.
/// \param scene   of the mesh's faces (checked); weighed where the format has an opacity, see
///                opacity.h
/// \param format  of the scene's texels: which channel is opacity
Result<UvImage> makeUvImage(const FilterScene& scene,
                            const TriangleMesh& mesh,
                            const TexelFormat& format,
                            const UvImageOptions& options,
                            Progress& progress);

} // namespace trixel
