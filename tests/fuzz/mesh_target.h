// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/check.h"
#include "core/mesh/mesh_reader.h"
#include "core/mesh/surface.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace trixel::fuzz {

/// Parses the bytes; what is accepted must be a mesh, and everything derived from it must build.
inline int readMeshBytes(MeshFormat format, const std::uint8_t* data, std::size_t size)
{
    NoProgress progress;
    auto mesh = parseMesh(format, {reinterpret_cast<const char*>(data), size}, progress);
    if (!mesh) {
        check(!mesh.error().message.empty(), "an error says why");
        return 0;
    }
    check(mesh->faceCount() > 0, "a mesh has faces");
    for (const Triangle& t : mesh->triangles) {
        for (const std::uint32_t vertex : t) {
            check(vertex < mesh->positions.size(), "indices are in range");
        }
    }
    for (const glm::vec3& p : mesh->positions) {
        check(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), "finite positions");
    }
    const auto surface = Surface::build(std::move(*mesh), progress);
    check(surface && (*surface)->report().describe().size() < 20, "a surface can be built");
    return 0;
}

} // namespace trixel::fuzz
