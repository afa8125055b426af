// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace trixel::render {

/// How the view's shader makes a pixel's colour out of texels.
enum class Filtering {
    Texels,      ///< the texel under the pixel, with its edges
    LowerHalf,   ///< only the lower texels of a face, as programs do that know squares alone
    PackedAtlas, ///< hardware bilinear in the packed squares, with borders from the neighbours
    Seamless,    ///< trilinear between averages at lattice vertices: no jump across any edge
    Anisotropic  ///< as Seamless, at several places along the pixel's footprint
};

} // namespace trixel::render
