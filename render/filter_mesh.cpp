// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/filter_mesh.h"

#include "core/base/check.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

namespace trixel::render {

namespace {

/// Length of the mean normal of faces that have nothing in common any more, and of those that do.
constexpr double kBent = 0.55;
constexpr double kFlat = 0.9;

/// [-1, 1] as the shader unpacks it.
std::uint16_t packed(double value)
{
    return static_cast<std::uint16_t>(std::lround((0.5 * value + 0.5) * 65535));
}

/// Where a face's corners are, and how long its edges.
struct FaceSize
{
    std::array<glm::dvec3, 3> corners{};
    std::array<double, 3> lengths{};
};

FaceSize sizeOf(const std::array<glm::vec3, 3>& corners)
{
    FaceSize size;
    for (std::size_t k = 0; k < 3; ++k) {
        size.corners[k] = glm::dvec3(corners[k]);
        size.lengths[k] = glm::length(glm::dvec3(corners[(k + 1) % 3] - corners[k]));
    }
    return size;
}

/// Along its curved edges.
FaceSize sizeOn(const LimitTessellation& limit, FaceId face)
{
    const std::span<const LimitVertex> border = limit.vertices(face);
    const CutRates& rates = limit.rates(face);
    const std::size_t around = std::size_t{rates.edges[0]} + rates.edges[1] + rates.edges[2];
    FaceSize size;
    std::size_t at = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        size.corners[k] = glm::dvec3(border[at].position);
        for (int piece = 0; piece < rates.edges[k]; ++piece, ++at) {
            const glm::vec3 next = border[(at + 1) % around].position;
            size.lengths[k] += glm::length(glm::dvec3(next - border[at].position));
        }
    }
    return size;
}

} // namespace

FilterMesh::FilterMesh(const TriangleMesh& mesh,
                       Adjacency adjacency,
                       const TexelStore& store,
                       const LimitTessellation* limit)
    : m_adjacency(std::move(adjacency))
    , m_rings(m_adjacency)
{
    check(store.faceCount() == mesh.faceCount() && m_adjacency.faceCount() == mesh.faceCount(),
          "texels and neighbours of this mesh");
    m_across.reserve(3 * mesh.faceCount());
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        for (const LocalEdge edge : kLocalEdges) {
            const auto across = m_adjacency.neighbour(faceId(f), edge);
            m_across.push_back(across ? static_cast<std::uint32_t>(indexOf(across->face)) << 2U |
                                            static_cast<std::uint32_t>(across->edge)
                                      : kBorder);
        }
    }
    measure(mesh, store, limit);
}

void FilterMesh::measure(const TriangleMesh& mesh,
                         const TexelStore& store,
                         const LimitTessellation* limit)
{
    struct Sums
    {
        double lengths = 0;
        double edges = 0;
        double levels = 0;
        double faces = 0;
        double area = 0;
        glm::dvec3 normal{0};
    };
    std::vector<Sums> sums(mesh.positions.size());
    double longest = 0;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const Triangle& triangle = mesh.triangles[f];
        const FaceSize size = limit ? sizeOn(*limit, faceId(f)) : sizeOf(mesh.corners(faceId(f)));
        const glm::dvec3 twice =
            glm::cross(size.corners[1] - size.corners[0], size.corners[2] - size.corners[0]);
        const double area = glm::length(twice);
        for (std::size_t k = 0; k < 3; ++k) {
            Sums& own = sums[triangle[k]];
            own.levels += store.face(faceId(f)).level().log2();
            own.faces += 1;
            own.normal += twice;
            own.area += area;
            // An edge that two faces share counts once.
            const std::uint32_t across = m_across[3 * f + k];
            const double length = size.lengths[k];
            longest = std::max(longest, length);
            if ((across == kBorder || across >> 2U > f) && length > 0) {
                const double log2Length = std::log2(length);
                for (Sums* end : {&own, &sums[triangle[(k + 1) % 3]]}) {
                    end->lengths += log2Length;
                    end->edges += 1;
                }
            }
        }
    }
    m_longestEdge = static_cast<float>(longest);
    m_scales.resize(sums.size());
    for (std::size_t v = 0; v < sums.size(); ++v) {
        const Sums& sum = sums[v];
        VertexScale& scale = m_scales[v];
        const double log2Length = sum.edges > 0 ? sum.lengths / sum.edges : 0;
        scale.log2Length = static_cast<float>(log2Length);
        scale.log2Texel =
            static_cast<float>(log2Length - (sum.faces > 0 ? sum.levels / sum.faces : 0));
        const double length = glm::length(sum.normal);
        const bool isTurned = length > std::numeric_limits<float>::min() && sum.area > 0;
        const glm::dvec3 normal = isTurned ? sum.normal / length : glm::dvec3(0, 0, 1);
        const double flatness = isTurned ? length / sum.area : 0;
        const double x = std::clamp((flatness - kBent) / (kFlat - kBent), 0.0, 1.0);
        scale.normal = {packed(normal.x), packed(normal.y), packed(normal.z)};
        scale.flatness = static_cast<std::uint16_t>(std::lround(x * x * (3 - 2 * x) * 65535));
    }
}

} // namespace trixel::render
