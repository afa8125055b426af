// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/project_metadata.h"

#include "core/io/layers_metadata.h"
#include "core/io/ptx_metadata.h"
#include "core/io/sharpness_metadata.h"

#include <cmath>
#include <limits>
#include <string>

namespace trixel {

namespace {

template <class T>
const std::vector<T>* valuesOf(std::span<const PtxMetadata> items, const char* key)
{
    const PtxMetadata* item = findMetadata(items, key);
    return item ? std::get_if<std::vector<T>>(&item->value) : nullptr;
}

tl::unexpected<Error> fault(const char* key, const std::string& what)
{
    return contentsError(std::string(key) + " " + what);
}

Status checkCounts(const std::vector<std::int32_t>& counts, std::uint32_t faceCount)
{
    if (counts.size() != faceCount) {
        return fault(kVertexCountsKey,
                     "is of " + std::to_string(counts.size()) + " faces, the texture has " +
                         std::to_string(faceCount));
    }
    for (std::size_t face = 0; face < counts.size(); ++face) {
        if (counts[face] != 3) {
            return fault(kVertexCountsKey,
                         "gives face " + std::to_string(face) + " " + std::to_string(counts[face]) +
                             " corners, expected 3");
        }
    }
    return {};
}

Result<std::vector<Triangle>> trianglesOf(const std::vector<std::int32_t>& indices,
                                          std::size_t faceCount,
                                          std::size_t vertexCount)
{
    if (indices.size() != 3 * faceCount) {
        return fault(kVertexIndicesKey,
                     "has " + std::to_string(indices.size()) + " values, expected " +
                         std::to_string(3 * faceCount));
    }
    std::vector<Triangle> triangles(faceCount);
    for (std::size_t k = 0; k < indices.size(); ++k) {
        if (indices[k] < 0 || static_cast<std::size_t>(indices[k]) >= vertexCount) {
            return fault(kVertexIndicesKey,
                         "gives face " + std::to_string(k / 3) + " vertex " +
                             std::to_string(indices[k]) + ", but there are " +
                             std::to_string(vertexCount));
        }
        triangles[k / 3][k % 3] = static_cast<std::uint32_t>(indices[k]);
    }
    return triangles;
}

Result<std::vector<glm::vec3>> positionsOf(const std::vector<float>& values)
{
    if (values.size() % 3 != 0) {
        return fault(kVertexPositionsKey,
                     "has " + std::to_string(values.size()) + " values, not three a vertex");
    }
    std::vector<glm::vec3> positions(values.size() / 3);
    for (std::size_t k = 0; k < positions.size(); ++k) {
        positions[k] = {values[3 * k], values[3 * k + 1], values[3 * k + 2]};
        if (!std::isfinite(positions[k].x) || !std::isfinite(positions[k].y) ||
            !std::isfinite(positions[k].z)) {
            return fault(kVertexPositionsKey,
                         "gives vertex " + std::to_string(k) + " a position that is not finite");
        }
    }
    return positions;
}

// Source faces rise from triangle to triangle, as the readers number them; anything else is ignored
// rather than refused, since nothing depends on it but what is shown.
std::vector<std::uint32_t> sourceFacesOf(std::span<const PtxMetadata> items, std::size_t faceCount)
{
    const auto* values = valuesOf<std::int32_t>(items, kSourceFacesKey);
    if (!values || values->size() != faceCount) {
        return {};
    }
    std::vector<std::uint32_t> faces;
    faces.reserve(faceCount);
    for (const std::int32_t value : *values) {
        if (value < 0) {
            return {};
        }
        faces.push_back(static_cast<std::uint32_t>(value));
    }
    return faces;
}

// As tolerant as of source faces, for the same reason.
std::vector<glm::vec2> cornerUvsOf(std::span<const PtxMetadata> items, std::size_t faceCount)
{
    const auto* values = valuesOf<float>(items, kCornerUvsKey);
    if (!values || values->size() != 6 * faceCount) {
        return {};
    }
    std::vector<glm::vec2> uvs(3 * faceCount);
    for (std::size_t k = 0; k < uvs.size(); ++k) {
        uvs[k] = {(*values)[2 * k], (*values)[2 * k + 1]};
    }
    return uvs;
}

} // namespace

bool carriesMesh(std::span<const PtxMetadata> items)
{
    return findMetadata(items, kVertexCountsKey) && findMetadata(items, kVertexIndicesKey) &&
           findMetadata(items, kVertexPositionsKey);
}

Result<TriangleMesh> meshOf(std::span<const PtxMetadata> items, std::uint32_t faceCount)
{
    const auto* counts = valuesOf<std::int32_t>(items, kVertexCountsKey);
    const auto* indices = valuesOf<std::int32_t>(items, kVertexIndicesKey);
    const auto* values = valuesOf<float>(items, kVertexPositionsKey);
    if (!counts || !indices || !values) {
        return contentsError("does not carry its mesh: the metadata PtexFaceVertCounts, "
                             "PtexFaceVertIndices and PtexVertPositions are not all there as "
                             "int32, int32 and float");
    }
    TriangleMesh mesh;
    return checkCounts(*counts, faceCount)
        .and_then([&] { return positionsOf(*values); })
        .and_then([&](std::vector<glm::vec3> positions) {
            mesh.positions = std::move(positions);
            return trianglesOf(*indices, faceCount, mesh.positions.size());
        })
        .and_then([&](std::vector<Triangle> triangles) {
            mesh.triangles = std::move(triangles);
            mesh.sourceFaces = sourceFacesOf(items, faceCount);
            mesh.cornerUvs = cornerUvsOf(items, faceCount);
            return sharpnessOf(items, mesh);
        })
        .map([&](Sharpness sharpness) {
            mesh.sharpness = std::move(sharpness);
            return std::move(mesh);
        });
}

std::vector<PtxMetadata> metadataOf(const TriangleMesh& mesh)
{
    std::vector<std::int32_t> indices;
    indices.reserve(3 * mesh.faceCount());
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) {
            indices.push_back(static_cast<std::int32_t>(vertex));
        }
    }
    std::vector<float> values;
    values.reserve(3 * mesh.positions.size());
    for (const glm::vec3& position : mesh.positions) {
        values.insert(values.end(), {position.x, position.y, position.z});
    }
    std::vector<PtxMetadata> items{
        {kVertexCountsKey, std::vector<std::int32_t>(mesh.faceCount(), 3)},
        {kVertexIndicesKey, std::move(indices)},
        {kVertexPositionsKey, std::move(values)}};
    if (!mesh.sourceFaces.empty()) {
        items.push_back(
            {kSourceFacesKey,
             std::vector<std::int32_t>(mesh.sourceFaces.begin(), mesh.sourceFaces.end())});
    }
    for (PtxMetadata& item : metadataOf(mesh.sharpness)) {
        items.push_back(std::move(item));
    }
    if (mesh.hasUvs()) {
        std::vector<float> uvs;
        uvs.reserve(2 * mesh.cornerUvs.size());
        for (const glm::vec2& uv : mesh.cornerUvs) {
            uvs.insert(uvs.end(), {uv.x, uv.y});
        }
        items.push_back({kCornerUvsKey, std::move(uvs)});
    }
    return items;
}

std::optional<int> projectVersionOf(std::span<const PtxMetadata> items)
{
    const auto* values = valuesOf<std::int32_t>(items, kProjectVersionKey);
    return values && values->size() == 1 ? std::optional<int>(values->front()) : std::nullopt;
}

std::vector<PtxMetadata> withoutMesh(std::vector<PtxMetadata> items)
{
    for (const char* key : {kVertexCountsKey,
                            kVertexIndicesKey,
                            kVertexPositionsKey,
                            kProjectVersionKey,
                            kSourceFacesKey,
                            kCreasesKey,
                            kCreaseSharpnessKey,
                            kSharpVerticesKey,
                            kVertexSharpnessKey,
                            kCreaseAngleKey,
                            kCornerUvsKey,
                            kLayersKey}) {
        removeMetadata(items, key);
    }
    return items;
}

} // namespace trixel
