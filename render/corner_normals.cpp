// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/corner_normals.h"

#include "core/base/parallel.h"
#include "core/mesh/corner_normals.h"
#include "core/mesh/packed_normal.h"

namespace trixel::render {

std::uint32_t packNormal(glm::vec3 normal)
{
    return trixel::packNormal(normal);
}

std::vector<std::uint32_t> cornerNormals(const TriangleMesh& mesh, float creaseDegrees)
{
    constexpr std::size_t kGrain = 65536;
    const std::vector<glm::vec3> normals = trixel::cornerNormals(mesh, creaseDegrees);
    std::vector<std::uint32_t> packed(normals.size());
    parallelFor(packed.size(), kGrain, Threads::all(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t corner = begin; corner < end; ++corner) {
            packed[corner] = packNormal(normals[corner]);
        }
    });
    return packed;
}

} // namespace trixel::render
