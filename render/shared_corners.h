// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/triangle_mesh.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace trixel::render {

/// A corner that faces about a mesh vertex share, so that what a vertex costs is paid for once.
struct SharedCorner
{
    std::uint32_t vertex = 0;
    /// Where it stands in any face: bits 0 and 1, 0 to 2, another for each corner of a face. And of
    /// the one face that it stands for: bits 2 and 3 the label of the face's corner 1, bits 4 and 5
    /// that of corner 2, and the face's number from bit 6 on. Zero where it stands for none.
    std::uint32_t bits = 0;
    std::uint32_t normal = 0; ///< see `packNormal`

    static constexpr unsigned kFaceShift = 6;

    std::uint32_t label() const { return bits & 3U; }
    std::uint32_t face() const { return bits >> kFaceShift; }
    /// Of a corner of the face that it stands for.
    std::uint32_t labelAt(int corner) const
    {
        const std::uint32_t one = bits >> 2U & 3U;
        const std::uint32_t two = bits >> 4U & 3U;
        return corner == 1 ? one : corner == 2 ? two : 3U - one - two;
    }

    friend bool operator==(const SharedCorner&, const SharedCorner&) = default;
};
static_assert(sizeof(SharedCorner) == 12);

/// A mesh as an index buffer draws it. What is interpolated over a face is told apart by its
/// corners' labels, what is one for all of it comes from its last corner: about one corner a face
/// in place of three.
struct SharedCorners
{
    std::vector<SharedCorner> corners;
    /// Three corners a face, turned so that the last stands for the face and for no other.
    std::vector<std::array<std::uint32_t, 3>> faces;

    static constexpr std::size_t kMostFaces = std::size_t{1} << (32U - SharedCorner::kFaceShift);

    /// \param normals  three a face (checked), see `cornerNormals`: corners with different ones are
    ///                 not shared
    /// \return         nothing where the mesh has more than `kMostFaces`
    static SharedCorners of(const TriangleMesh& mesh, std::span<const std::uint32_t> normals);

    friend bool operator==(const SharedCorners&, const SharedCorners&) = default;
};

} // namespace trixel::render
