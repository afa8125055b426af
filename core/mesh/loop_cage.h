// SPDX-License-Identifier: GPL-3.0-or-later
//
// What refinement and the limit surface ask of a cage, and its connectivity as OpenSubdiv holds it.
#pragma once

#include "core/base/result.h"
#include "core/mesh/triangle_mesh.h"

#include <memory>
#include <opensubdiv/far/topologyRefiner.h>

namespace trixel {

using LoopRefiner = std::unique_ptr<OpenSubdiv::Far::TopologyRefiner>;

/// Whether Loop's scheme takes the cage. Fails, naming the face or vertex, on no faces, an index
/// beyond the positions, a repeated corner, a position that is not finite, or a vertex above
/// kMaxLoopValence.
Status checkLoopCage(const TriangleMesh& cage);

/// Fails, naming the crease or sharp vertex (counted from 1), where a vertex is beyond the positions
/// or the sharpness not in [0, kSharp].
Status checkSharpness(const TriangleMesh& cage, const Sharpness& sharpness);

/// The connectivity of a cage that was checked, not refined yet; nothing if OpenSubdiv refuses it.
/// Borders become curves, border vertices of a single face corners. Creases between vertices that
/// share no edge mean nothing. May throw std::bad_alloc.
LoopRefiner makeLoopRefiner(const TriangleMesh& cage, const Sharpness& sharpness);

} // namespace trixel
