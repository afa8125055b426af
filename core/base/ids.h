// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace trixel {

/// Number of a triangle, in the order of the file it came from.
enum class FaceId : std::uint32_t {};

/// Number of a mesh vertex.
enum class VertexId : std::uint32_t {};

/// Storage order of a texel within one face: row-major in the packed square.
enum class TexelIndex : std::uint32_t {};

/// Ptex edge of a face: E0 is v = 0 (V0→V1), E1 is w = 0 (V1→V2), E2 is u = 0 (V2→V0).
enum class LocalEdge : std::uint8_t { E0 = 0, E1 = 1, E2 = 2 };

inline constexpr LocalEdge kLocalEdges[3] = {LocalEdge::E0, LocalEdge::E1, LocalEdge::E2};

constexpr std::size_t indexOf(FaceId id)
{
    return static_cast<std::size_t>(id);
}
constexpr std::size_t indexOf(VertexId id)
{
    return static_cast<std::size_t>(id);
}
constexpr std::size_t indexOf(TexelIndex id)
{
    return static_cast<std::size_t>(id);
}
constexpr std::size_t indexOf(LocalEdge edge)
{
    return static_cast<std::size_t>(edge);
}

/// Face id of an index; the caller keeps it below 2^30.
constexpr FaceId faceId(std::size_t index)
{
    return static_cast<FaceId>(index);
}

/// The edge that follows counter-clockwise.
constexpr LocalEdge nextEdge(LocalEdge edge)
{
    return static_cast<LocalEdge>((indexOf(edge) + 1) % 3);
}

} // namespace trixel
