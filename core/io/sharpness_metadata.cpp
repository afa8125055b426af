// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/sharpness_metadata.h"

#include "core/io/project_metadata.h"
#include "core/io/ptx_metadata.h"
#include "core/mesh/crease_edges.h"

#include <string>

namespace trixel {

namespace {

tl::unexpected<Error> fault(const char* key, const std::string& what)
{
    return contentsError(std::string(key) + " " + what);
}

/// Nothing where there is no such item.
template <class T>
Result<std::vector<T>> valuesOf(std::span<const PtxMetadata> items, const char* key)
{
    const PtxMetadata* item = findMetadata(items, key);
    if (item == nullptr) {
        return std::vector<T>();
    }
    const auto* values = std::get_if<std::vector<T>>(&item->value);
    return values ? Result<std::vector<T>>(*values) : fault(key, "is not of numbers of its type");
}

Result<std::vector<std::uint32_t>>
verticesOf(std::span<const PtxMetadata> items, const char* key, std::size_t vertexCount)
{
    const auto values = valuesOf<std::int32_t>(items, key);
    if (!values) {
        return tl::unexpected(values.error());
    }
    std::vector<std::uint32_t> vertices;
    vertices.reserve(values->size());
    for (const std::int32_t value : *values) {
        if (value < 0 || static_cast<std::size_t>(value) >= vertexCount) {
            return fault(key,
                         "names vertex " + std::to_string(value) + ", but there are " +
                             std::to_string(vertexCount));
        }
        vertices.push_back(static_cast<std::uint32_t>(value));
    }
    return vertices;
}

/// \param count  of what is sharp
Result<std::vector<float>>
sharpnessesOf(std::span<const PtxMetadata> items, const char* key, std::size_t count)
{
    auto values = valuesOf<float>(items, key);
    if (!values) {
        return values;
    }
    if (values->size() != count) {
        return fault(key,
                     "has " + std::to_string(values->size()) + " values, expected " +
                         std::to_string(count));
    }
    for (std::size_t k = 0; k < count; ++k) {
        if (!((*values)[k] > 0 && (*values)[k] <= kSharp)) {
            return fault(key,
                         "has " + std::to_string((*values)[k]) + " at " + std::to_string(k) +
                             ", expected more than 0 and at most 10");
        }
    }
    return values;
}

Result<std::vector<Crease>> creasesOf(std::span<const PtxMetadata> items, const TriangleMesh& mesh)
{
    const auto ends = verticesOf(items, kCreasesKey, mesh.positions.size());
    if (!ends) {
        return tl::unexpected(ends.error());
    }
    if (ends->size() % 2 != 0) {
        return fault(kCreasesKey,
                     "has " + std::to_string(ends->size()) + " values, not two a crease");
    }
    const auto sharpness = sharpnessesOf(items, kCreaseSharpnessKey, ends->size() / 2);
    if (!sharpness) {
        return tl::unexpected(sharpness.error());
    }
    std::vector<Crease> creases;
    for (std::size_t k = 0; k < sharpness->size(); ++k) {
        creases.push_back({(*ends)[2 * k], (*ends)[2 * k + 1], (*sharpness)[k]});
    }
    if (const auto astray = firstOffEdges(mesh, creases)) {
        return fault(kCreasesKey,
                     "has crease " + std::to_string(*astray) + " between vertices " +
                         std::to_string(creases[*astray].from) + " and " +
                         std::to_string(creases[*astray].to) + ", which share no edge");
    }
    return creases;
}

Result<std::vector<SharpVertex>> sharpVerticesOf(std::span<const PtxMetadata> items,
                                                 std::size_t vertexCount)
{
    const auto vertices = verticesOf(items, kSharpVerticesKey, vertexCount);
    if (!vertices) {
        return tl::unexpected(vertices.error());
    }
    const auto sharpness = sharpnessesOf(items, kVertexSharpnessKey, vertices->size());
    if (!sharpness) {
        return tl::unexpected(sharpness.error());
    }
    std::vector<SharpVertex> sharp;
    for (std::size_t k = 0; k < sharpness->size(); ++k) {
        sharp.push_back({(*vertices)[k], (*sharpness)[k]});
    }
    return sharp;
}

} // namespace

Result<Sharpness> sharpnessOf(std::span<const PtxMetadata> items, const TriangleMesh& mesh)
{
    auto creases = creasesOf(items, mesh);
    if (!creases) {
        return tl::unexpected(creases.error());
    }
    auto vertices = sharpVerticesOf(items, mesh.positions.size());
    if (!vertices) {
        return tl::unexpected(vertices.error());
    }
    return Sharpness{std::move(*creases), std::move(*vertices)};
}

std::vector<PtxMetadata> metadataOf(const Sharpness& sharpness)
{
    std::vector<PtxMetadata> items;
    if (!sharpness.creases.empty()) {
        std::vector<std::int32_t> ends;
        std::vector<float> values;
        for (const Crease& crease : sharpness.creases) {
            ends.push_back(static_cast<std::int32_t>(crease.from));
            ends.push_back(static_cast<std::int32_t>(crease.to));
            values.push_back(crease.sharpness);
        }
        items.push_back({kCreasesKey, std::move(ends)});
        items.push_back({kCreaseSharpnessKey, std::move(values)});
    }
    if (!sharpness.vertices.empty()) {
        std::vector<std::int32_t> vertices;
        std::vector<float> values;
        for (const SharpVertex& sharp : sharpness.vertices) {
            vertices.push_back(static_cast<std::int32_t>(sharp.vertex));
            values.push_back(sharp.sharpness);
        }
        items.push_back({kSharpVerticesKey, std::move(vertices)});
        items.push_back({kVertexSharpnessKey, std::move(values)});
    }
    return items;
}

Result<CreaseAngle> creaseAngleOf(std::span<const PtxMetadata> items)
{
    const auto values = valuesOf<float>(items, kCreaseAngleKey);
    if (!values) {
        return tl::unexpected(values.error());
    }
    if (values->empty()) {
        return CreaseAngle();
    }
    if (values->size() > 1) {
        return fault(kCreaseAngleKey,
                     "has " + std::to_string(values->size()) + " values, expected one");
    }
    if (!(values->front() >= 0 && values->front() <= 180)) {
        return fault(kCreaseAngleKey,
                     "is " + std::to_string(values->front()) + " degrees, expected 0 to 180");
    }
    return CreaseAngle(values->front());
}

} // namespace trixel
