// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/adjacency.h"

#include <span>
#include <vector>

namespace trixel {

struct FacePair
{
    FaceId a{};
    FaceId b{};
};

/// The faces that are wound against most faces of their component; of two halves of equal size, the
/// one without the component's lowest face. A component that has no consistent winding at all (a
/// Möbius strip) contributes only what can be told.
/// \param opposed  pairs of faces, alone on an edge, that run along it the same way
std::vector<FaceId> findFlippedFaces(const Adjacency& adjacency, std::span<const FacePair> opposed);

} // namespace trixel
