// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/paint/brush.h"
#include "core/paint/stroke.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace trixel {

/// A stroke as recorded: a brush and where it went.
struct RecordedStroke
{
    Brush brush;
    std::vector<StrokeSample> samples;
};

/// Reads a stroke file (JSON, version 1; see the command line's documentation). Errors name the
/// stroke and the field. Faces are checked against `faceCount`.
Result<std::vector<RecordedStroke>> parseStrokes(std::string_view json, std::size_t faceCount);
std::string writeStrokes(std::span<const RecordedStroke> strokes);

/// Replays strokes in order on a store. The result does not depend on the number of threads.
Status replayStrokes(std::span<const RecordedStroke> strokes,
                     const std::shared_ptr<const Surface>& surface,
                     std::span<const std::byte> fill,
                     TexelStore& store,
                     Threads threads,
                     Progress& progress);

} // namespace trixel
