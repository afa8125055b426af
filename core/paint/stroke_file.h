// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/layers/compose.h"
#include "core/paint/brush.h"
#include "core/paint/stroke.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trixel {

/// A stroke as recorded: a brush and where it went.
struct RecordedStroke
{
    Brush brush;
    std::vector<StrokeSample> samples;
    bool onLimit = false;    ///< painted on the limit surface, by `limitToPaintOn`, not on the cage
    std::uint32_t layer = 0; ///< painted on: 0 for the base, then the layers from the bottom
};

/// Reads a stroke file (JSON, version 1; see the command line's documentation). Errors name the
/// stroke and the sample, counted from 1, and the field. Faces are checked against `faceCount`.
/// Required are "version", "strokes", each stroke's "brush" (with "radius" and "color") and
/// "samples" (each with "face", "u" and "v"); what else is left out has its default. Beyond the
/// documented fields a brush may hold "pressureToSize", "pressureToOpacity" and "paintThrough";
/// a stroke a "surface", "cage" or "limit";
/// fields of other names are refused, and so are units but "world" and brushes that `validate`
/// refuses.
Result<std::vector<RecordedStroke>> parseStrokes(std::string_view json, std::size_t faceCount);

/// The text that `parseStrokes` reads back to equal strokes.
std::string writeStrokes(std::span<const RecordedStroke> strokes);

/// Replays strokes in order, each on its layer, and shows what they make of the whole. The result
/// does not depend on the number of threads. Fails when a brush is not valid, when a stroke is on a
/// layer that is not there or on the limit of a surface that has none, or when cancelled, and then
/// leaves everything as it was.
/// \param fill     what Erase moves the base towards
/// \param creases  of the limit surface, beside those of the mesh; see `limitToPaintOn`
Status replayStrokes(std::span<const RecordedStroke> strokes,
                     const std::shared_ptr<const Surface>& surface,
                     std::span<const std::byte> fill,
                     Layered& painted,
                     Threads threads,
                     Progress& progress,
                     CreaseAngle creases = {});

/// The same on texels without layers.
Status replayStrokes(std::span<const RecordedStroke> strokes,
                     const std::shared_ptr<const Surface>& surface,
                     std::span<const std::byte> fill,
                     TexelStore& store,
                     Threads threads,
                     Progress& progress,
                     CreaseAngle creases = {});

} // namespace trixel
