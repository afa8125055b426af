// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/face_map.h"
#include "core/mesh/surface.h"
#include "core/texture/texel_store.h"
#include "ui/viewport/map_scale.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace trixel::ui {

/// What a planned fit leaves on each face.
struct FaceErrors
{
    std::shared_ptr<const FaceMap<float>> rms; ///< NaN where no view frames the face
    double tolerance = 0;
};

/// How far each face is from that of another file, and what that is called.
struct FaceDifferences
{
    std::shared_ptr<const FaceMap<float>> rms; ///< in parts of the value range; 0 where they agree
    std::string file;
};

/// All that a map of one number a face is computed from; nothing of it changes meanwhile.
struct FaceMapWork
{
    ViewMapKind map = ViewMapKind::Level; ///< one that `isOfFaces`
    std::shared_ptr<const Surface> surface;
    TexelStore texels;
    FaceErrors errors;           ///< for Fit alone, there with one for each face
    FaceDifferences differences; ///< for Difference alone, likewise
};

/// A number and a colour for each face.
struct FaceNumbers
{
    std::vector<float> values;
    std::vector<std::uint32_t> colors; ///< R G B A
    MapScale scale;                    ///< that the colours are of
};

/// Whether a map has one number for the whole of a face, whatever the camera.
bool isOfFaces(ViewMapKind map);

/// Takes both cores; about a tenth of a second for a million faces.
FaceNumbers computeFaceMap(const FaceMapWork& work);

} // namespace trixel::ui
