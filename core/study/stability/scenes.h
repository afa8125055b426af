// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small surfaces that the sweeps look at.
#pragma once

#include "core/filter/filter_scene.h"

#include <functional>
#include <glm/vec3.hpp>
#include <vector>

namespace trixel::sweeps {

/// Value of a texel by where its centroid lies.
using TexelValue = std::function<float(FaceId face, Level level, TexelIndex texel)>;

/// One channel of floats on a mesh. \param levels  one a face
FilterScene sceneOf(const TriangleMesh& mesh,
                    const Adjacency& adjacency,
                    std::span<const Level> levels,
                    const TexelValue& value);
/// The same, neighbours as the mesh has them.
FilterScene
sceneOf(const TriangleMesh& mesh, std::span<const Level> levels, const TexelValue& value);

/// One equilateral face of edge 1 and value 0.5.
FilterScene flatScene(Level level);

/// Two equilateral faces glued along all three edges, of level 9, each of whose texels has the one
/// value: no line over it ever ends, and nothing is saved because it is constant.
FilterScene pillowScene(float value);

/// Closed fan of triangles around the origin, corners at distance 1.
TriangleMesh fan(int valence);

/// Two faces that share an edge: V1→V2 of the first.
TriangleMesh pairOfFaces();

} // namespace trixel::sweeps
