// SPDX-License-Identifier: GPL-3.0-or-later
//
// The pixels of a packed atlas: texels to the bit, borders of true neighbours, mips face by face.
#pragma once

#include "core/atlas/atlas_layout.h"
#include "core/atlas/page_pixels.h"
#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/adjacency.h"
#include "core/texture/texel_store.h"

#include <vector>

namespace trixel {

/// Every page, in the store's own format. Pixels that no tile takes are 0.
/// \param layout  of the levels of the store's faces (checked)
/// \param colors  what the channels mean, one for each (checked)
/// Fails when cancelled, when memory runs out, and when a face cannot be read.
Result<std::vector<Image>> packedPages(const AtlasLayout& layout,
                                       const TexelStore& store,
                                       const Adjacency& adjacency,
                                       const std::vector<ColorSpace>& colors,
                                       Threads threads,
                                       Progress& progress);

/// Where the texels of a face lie among the pages of an atlas.
struct PackedFace
{
    Level level;
    AtlasPlace place; ///< of the tile of that level

    bool operator==(const PackedFace&) const = default;
};

/// Where each face lies at its own level.
FaceMap<PackedFace> packedFaces(const AtlasLayout& layout);

/// The faces of an atlas: the texels that `packedPages` put there, those of one value constant.
/// \param pages  all of one format, each tile whole on one of them (checked)
/// Fails when cancelled and when memory runs out.
Result<TexelStore> unpackedFaces(const FaceMap<PackedFace>& faces,
                                 AtlasBorder border,
                                 std::span<const Image> pages,
                                 Threads threads,
                                 Progress& progress);

} // namespace trixel
