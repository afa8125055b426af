// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mapping/distortion.h"
#include "ui/import/import_work.h"

#include <cstdint>
#include <vector>

namespace trixel::ui {

/// What about a mapping a map of colours tells.
enum class DistortionMeasure {
    TexelsPerPixel, ///< along a side: above 1 the image is spread thin, below 1 pixels are lost
    Stretch         ///< of all directions the most pixels a unit over the fewest; 1 is none
};

/// A colour for each corner of each face, and what its number comes from.
struct DistortionColors
{
    ImportMapping mapping;
    TexelStore texels;
    glm::dvec2 imageSize{1}; ///< pixels
    DistortionMeasure measure{};
    std::vector<std::uint32_t> colors; ///< R G B A, three a face
};

/// Fails where the settings make no mapping.
Result<DistortionColors> distortionColors(const ImportInput& input, DistortionMeasure measure);

/// At a point of a face; NaN where the image does not reach.
double distortionAt(const DistortionColors& of, FaceId face, glm::dvec2 uv);

} // namespace trixel::ui
