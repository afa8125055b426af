// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/triangle_mesh.h"

#include <cmath>
#include <cstdint>

namespace trixel {

/// A wavy sheet of 2 n² faces, from -1 to 1.
inline TriangleMesh sheetMesh(int n)
{
    TriangleMesh mesh;
    const auto id = [n](int i, int j) { return static_cast<std::uint32_t>(i + j * (n + 1)); };
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            const float x = 2.0F * static_cast<float>(i) / static_cast<float>(n) - 1;
            const float y = 2.0F * static_cast<float>(j) / static_cast<float>(n) - 1;
            mesh.positions.push_back({x, y, 0.2F * std::sin(6 * x) * std::cos(5 * y)});
        }
    }
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            mesh.triangles.push_back({id(i, j), id(i + 1, j), id(i, j + 1)});
            mesh.triangles.push_back({id(i + 1, j + 1), id(i, j + 1), id(i + 1, j)});
        }
    }
    return mesh;
}

} // namespace trixel
