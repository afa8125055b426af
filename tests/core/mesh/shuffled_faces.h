// SPDX-License-Identifier: GPL-3.0-or-later
//
// A mesh, and the same with its faces in another order, begun and wound otherwise.
#pragma once

#include "core/mesh/face_match.h"
#include "tests/core/mesh/meshes.h"

#include <algorithm>
#include <numeric>
#include <random>

namespace trixel::test {

/// A grid that no turn and no mirror brings onto itself: some faces of it left out.
inline TriangleMesh ragged(std::uint32_t side = 6)
{
    TriangleMesh mesh = gridMesh(side);
    for (std::size_t k = 0; k < mesh.positions.size(); ++k) {
        mesh.positions[k].z = 0.1F * static_cast<float>(k % 7);
    }
    for (const std::size_t gone : {0, 3, 9, 20}) {
        mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(gone));
    }
    mesh.sourceFaces.clear();
    return mesh;
}

enum class Winding { Kept, AllTurnedOver, Random };

struct Shuffled
{
    TriangleMesh mesh;
    FaceMatch match; ///< of the mesh it was made from
};

/// The same faces in another order, begun at other corners, wound otherwise, and with their
/// vertices numbered anew.
inline Shuffled shuffled(const TriangleMesh& mesh, unsigned seed, Winding winding)
{
    std::mt19937 random(seed);
    std::vector<std::uint32_t> vertices(mesh.positions.size());
    std::iota(vertices.begin(), vertices.end(), 0U);
    std::ranges::shuffle(vertices, random);
    std::vector<std::uint32_t> faces(mesh.faceCount());
    std::iota(faces.begin(), faces.end(), 0U);
    std::ranges::shuffle(faces, random);
    Shuffled result;
    result.mesh.positions.resize(mesh.positions.size());
    for (std::size_t k = 0; k < vertices.size(); ++k) {
        result.mesh.positions[vertices[k]] = mesh.positions[k];
    }
    result.mesh.triangles.resize(mesh.faceCount());
    result.match.resize(mesh.faceCount());
    for (std::size_t k = 0; k < faces.size(); ++k) {
        const bool over =
            winding == Winding::AllTurnedOver || (winding == Winding::Random && random() % 2 == 0);
        const CornerOrder order = kCornerOrders[random() % 3 + (over ? 3 : 0)];
        for (std::size_t c = 0; c < 3; ++c) {
            result.mesh.triangles[faces[k]][order[c]] = vertices[mesh.triangles[k][c]];
        }
        result.match[k] = {faceId(faces[k]), order};
    }
    return result;
}

} // namespace trixel::test
