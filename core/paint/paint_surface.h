// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/limit_mesh.h"
#include "core/mesh/surface.h"

#include <memory>

namespace trixel {

/// The limit surface of a cage as strokes find their way on it: tessellated alike whatever looks at
/// it, to within 1/4096 of the surface's size or by four million triangles.
/// \param creases  beside those of its mesh; see `sharpnessOf`
/// Fails as `LimitSurface::build`, or when cancelled.
Result<std::shared_ptr<const LimitMesh>>
limitToPaintOn(const Surface& surface, CreaseAngle creases, Threads threads, Progress& progress);

} // namespace trixel
