// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which faces have the same vertex averages because all they are made from is the same.
#pragma once

#include "core/base/parallel.h"
#include "core/mesh/vertex_rings.h"
#include "core/texture/float_mips.h"

#include <cstdint>
#include <vector>

namespace trixel {

class PyramidSharing
{
public:
    PyramidSharing(const FloatMips& mips, const Adjacency& adjacency, const VertexRings& rings);

    /// Whether the face and all about it are one constant, to the bit.
    bool isConstant(FaceId face) const;

    /// For every face the first one that is alike: itself where it is the first.
    std::vector<FaceId> firstAlike(Threads threads) const;

private:
    std::uint64_t signature(FaceId face) const;
    bool isAlike(FaceId a, FaceId b) const;
    /// Calls work(face, place) for all that a face is made from, in an order of its own; false
    /// where work said so.
    template <class Work>
    bool eachSource(FaceId face, const Work& work) const;

    const FloatMips& m_mips;
    const Adjacency& m_adjacency;
    const VertexRings& m_rings;
};

} // namespace trixel
