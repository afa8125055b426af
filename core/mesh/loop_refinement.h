// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/mesh/triangle_mesh.h"

namespace trixel {

/// Most refinement steps that `loopRefined` takes.
inline constexpr int kMaxLoopSteps = 8;
/// Most faces that `loopRefined` makes.
inline constexpr std::size_t kMaxLoopFaces = std::size_t{1} << 24U;
/// Most edges at a vertex of the cage; the work grows with the square of it.
inline constexpr std::size_t kMaxLoopValence = 256;

/// Loop subdivision of a control cage: every step cuts each triangle in four, and at the end every
/// vertex is moved to where it lies on the limit surface. Border edges become smooth curves, and
/// border vertices of a single face stay sharp corners.
///
/// Triangle f of the cage becomes the triangles f 4^steps … (f + 1) 4^steps - 1, which name f as
/// their source face. The same cage gives the same mesh, to the bit. Vertices of no face are kept.
/// \param steps  in [0, kMaxLoopSteps]
/// Fails, naming the face or vertex, on an index beyond the positions, a repeated corner, a
/// position that is not finite, a vertex above kMaxLoopValence, or more than kMaxLoopFaces.
Result<TriangleMesh> loopRefined(const TriangleMesh& cage, int steps);

} // namespace trixel
