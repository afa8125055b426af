// SPDX-License-Identifier: GPL-3.0-or-later
//
// A pyramid that looks across no edge. The linker's --wrap brings every call of
// ConformingPyramid::build here.
#include "core/texture/conforming_pyramid.h"

#define PYRAMID_BUILD                                                                              \
    "_ZN6trixel17ConformingPyramid5buildERKNS_9FloatMipsERKNS_9AdjacencyERKNS_"                    \
    "11VertexRingsENS_7ThreadsERNS_8ProgressE"

namespace trixel {

Result<ConformingPyramid> shippedBuild(const FloatMips& mips,
                                       const Adjacency& adjacency,
                                       const VertexRings& rings,
                                       Threads threads,
                                       Progress& progress) __asm__("__real_" PYRAMID_BUILD);

Result<ConformingPyramid> buildPerFace(const FloatMips& mips,
                                       const Adjacency& adjacency,
                                       const VertexRings& rings,
                                       Threads threads,
                                       Progress& progress) __asm__("__wrap_" PYRAMID_BUILD);

Result<ConformingPyramid> buildPerFace(const FloatMips& mips,
                                       const Adjacency& adjacency,
                                       const VertexRings& /*rings*/,
                                       Threads threads,
                                       Progress& progress)
{
    const Adjacency alone(adjacency.faceCount());
    return shippedBuild(mips, alone, VertexRings(alone), threads, progress);
}

} // namespace trixel
