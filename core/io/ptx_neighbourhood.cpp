// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ptx_neighbourhood.h"

#include "core/base/check.h"

#include <cstdint>
#include <cstring>
#include <vector>

namespace trixel {

namespace {

constexpr int kMaxFacesOfVertex = 64;

enum class WalkEnd { CameRound, Border, Different, TooLong };

struct Neighbourhood
{
    std::span<const PtxFaceInfo> infos;
    std::span<const std::byte> constants;
    std::size_t texelBytes;

    bool isLike(std::size_t face, std::size_t other) const
    {
        return infos[other].isConstant() && std::memcmp(&constants[face * texelBytes],
                                                        &constants[other * texelBytes],
                                                        texelBytes) == 0;
    }

    // Walks around the vertex that the face's edge starts (turn 1) or ends (turn 2) at.
    WalkEnd walk(std::size_t face, std::size_t edge, std::size_t turn) const
    {
        std::size_t current = face;
        for (int count = 0; count < kMaxFacesOfVertex; ++count) {
            const std::int32_t next = infos[current].adjacentFaces[edge];
            if (next < 0) {
                return WalkEnd::Border;
            }
            edge = (static_cast<std::size_t>(infos[current].adjacentEdge(edge)) + turn) % 3;
            current = static_cast<std::size_t>(next);
            if (current == face) {
                return WalkEnd::CameRound;
            }
            if (!isLike(face, current)) {
                return WalkEnd::Different;
            }
        }
        return WalkEnd::TooLong;
    }

    // Of the faces around one vertex.
    PtxNeighbourhood around(std::size_t face, std::size_t vertex) const
    {
        WalkEnd end = walk(face, vertex, 1);
        if (end == WalkEnd::Border) {
            end = walk(face, (vertex + 2) % 3, 2);
        }
        switch (end) {
        case WalkEnd::CameRound:
        case WalkEnd::Border:
            return PtxNeighbourhood::Constant;
        case WalkEnd::TooLong:
            return PtxNeighbourhood::TooLarge;
        case WalkEnd::Different:
            break;
        }
        return PtxNeighbourhood::Different;
    }
};

} // namespace

PtxNeighbourhood neighbourhoodOf(std::span<const PtxFaceInfo> infos,
                                 std::span<const std::byte> constants,
                                 std::size_t texelBytes,
                                 std::size_t face)
{
    if (!infos[face].isConstant()) {
        return PtxNeighbourhood::Different;
    }
    const Neighbourhood all{infos, constants, texelBytes};
    PtxNeighbourhood worst = PtxNeighbourhood::Constant;
    for (std::size_t vertex = 0; vertex < 3; ++vertex) {
        const PtxNeighbourhood found = all.around(face, vertex);
        if (found == PtxNeighbourhood::Different) {
            return found;
        }
        worst = found == PtxNeighbourhood::Constant ? worst : found;
    }
    return worst;
}

void flagConstantNeighbourhoods(std::span<PtxFaceInfo> infos,
                                std::span<const std::byte> constants,
                                std::size_t texelBytes,
                                Threads threads)
{
    check(constants.size() == infos.size() * texelBytes, "one texel a face");
    // Flags are set on the walked records, but the walks look only at links and the constant flag,
    // kept in a byte of their own here so that no thread reads what another writes.
    std::vector<std::uint8_t> flagged(infos.size());
    parallelFor(infos.size(), 16384, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t face = begin; face < end; ++face) {
            const PtxNeighbourhood found = neighbourhoodOf(infos, constants, texelBytes, face);
            flagged[face] = found == PtxNeighbourhood::Constant ? 1 : 0;
        }
    });
    for (std::size_t face = 0; face < infos.size(); ++face) {
        if (flagged[face] != 0) {
            infos[face].flags |= PtxFaceInfo::kConstantNeighbours;
        }
    }
}

} // namespace trixel
