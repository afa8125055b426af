// SPDX-License-Identifier: GPL-3.0-or-later
//
// Footprints do not end where what a view sees ends: the faces that a fit need not keep for
// themselves, but that what it keeps reaches into.
#pragma once

#include "core/study/fit/fit_samples.h"

#include <vector>

namespace trixel {

struct FitRim
{
    /// Of each judged face the faces of the rim that its footprints reach, none twice.
    FaceMap<std::vector<FaceId>> reached;
    /// World units per pixel of the finest footprint that reaches a face of the rim; infinite
    /// elsewhere.
    FaceMap<double> spacing;

    bool contains(FaceId face) const;
};

/// Every face that is not judged and meets a judged one at a vertex, or comes within two of its
/// pixels and four of its edges: farther away a Gaussian's share is small, or faces are so small
/// that their means will do.
FitRim fitRim(const Surface& surface, const VertexRings& rings, const FitSamples& samples);

} // namespace trixel
