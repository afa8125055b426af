// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/layer_blend.h"
#include "core/texture/face_texels.h"
#include "core/texture/texel_format.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace trixel {

/// One face of a layer as it is shown.
struct LayerFace
{
    LayerBlend blend = LayerBlend::Normal;
    float opacity = 1.0F;
    FaceTexels texels; ///< in memory, of `layerFormat`
};

/// Puts layers over runs of texels: decodes a piece of what lies below, lets each layer change it
/// in float, encodes once. Coverage outside [0,1] counts as the nearer end, NaN as none. Where no
/// layer covers anything the stored bits stay; where a Normal one covers all its value is stored as
/// it is.
class TexelComposer
{
public:
    explicit TexelComposer(const TexelFormat& base);

    /// \param base   in memory, of the base's format
    /// \param over   bottom to top, of the base's level
    /// \param first  of the texels, in packed order; those of constant faces are all alike
    /// \param shown  receives a whole number of texels; may not overlap what is read
    void compose(const FaceTexels& base,
                 std::span<const LayerFace> over,
                 std::size_t first,
                 std::span<std::byte> shown) const;

private:
    TexelFormat m_format;
    std::size_t m_chunk; ///< texels worked on at a time
};

} // namespace trixel
