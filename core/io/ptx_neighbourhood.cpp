// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ptx_neighbourhood.h"

#include "core/base/check.h"

#include <cstdint>
#include <cstring>
#include <vector>

namespace trixel {

namespace {

constexpr int kMaxFacesOfVertex = 64;

enum class WalkEnd { CameRound, Border, Different };

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
        return WalkEnd::Different;
    }

    bool isConstantAround(std::size_t face, std::size_t vertex) const
    {
        const WalkEnd end = walk(face, vertex, 1);
        return end == WalkEnd::CameRound ||
               (end == WalkEnd::Border && walk(face, (vertex + 2) % 3, 2) != WalkEnd::Different);
    }
};

} // namespace

bool hasConstantNeighbourhood(std::span<const PtxFaceInfo> infos,
                              std::span<const std::byte> constants,
                              std::size_t texelBytes,
                              std::size_t face)
{
    const Neighbourhood all{infos, constants, texelBytes};
    return infos[face].isConstant() && all.isConstantAround(face, 0) &&
           all.isConstantAround(face, 1) && all.isConstantAround(face, 2);
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
            flagged[face] = hasConstantNeighbourhood(infos, constants, texelBytes, face) ? 1 : 0;
        }
    });
    for (std::size_t face = 0; face < infos.size(); ++face) {
        if (flagged[face] != 0) {
            infos[face].flags |= PtxFaceInfo::kConstantNeighbours;
        }
    }
}

} // namespace trixel
