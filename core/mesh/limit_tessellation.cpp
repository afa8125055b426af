// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/limit_tessellation.h"

#include "core/base/check.h"
#include "core/mesh/limit_rates.h"
#include "core/mesh/packed_normal.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace trixel {

namespace {

constexpr std::size_t kFacesAtATime = 64;
constexpr std::size_t kFacesPerReport = 16384;

/// Where the corner or edge k of a face begins among the points of its pattern.
std::uint32_t firstOfEdge(const CutRates& rates, std::uint32_t k)
{
    std::uint32_t first = 0;
    for (std::uint32_t e = 0; e < k; ++e) {
        first += rates.edges[e];
    }
    return first;
}

std::uint32_t normalAt(const LimitPoint& point, const glm::dvec3& instead)
{
    const glm::dvec3 normal = point.normal();
    return packNormal(glm::vec3(normal == glm::dvec3(0) ? instead : normal));
}

} // namespace

class LimitTessellation::Build
{
public:
    Build(LimitTessellation& made, std::shared_ptr<const LimitTessellation> before)
        : m_made(made)
        , m_before(before && before->m_bends == made.m_bends ? std::move(before) : nullptr)
    {
        const std::size_t faces = m_made.m_rates.size();
        m_patterns.reserve(faces);
        m_made.m_firstVertex.assign(1, 0);
        m_made.m_firstTriangle.assign(1, 0);
        CutRates last;
        const CutPattern* pattern = &m_cutter.pattern(last);
        for (const CutRates& rates : m_made.m_rates) {
            if (!(rates == last)) {
                pattern = &m_cutter.pattern(rates);
                last = rates;
            }
            m_patterns.push_back(pattern);
            m_made.m_firstVertex.push_back(m_made.m_firstVertex.back() +
                                           static_cast<std::uint32_t>(pattern->points.size()));
            m_made.m_firstTriangle.push_back(m_made.m_firstTriangle.back() +
                                             static_cast<std::uint32_t>(pattern->triangles.size()));
        }
        m_made.m_vertices.resize(m_made.m_firstVertex.back());
        m_made.m_triangles.resize(m_made.m_firstTriangle.back());
    }

    Status run(Threads threads, Progress& progress)
    {
        const std::size_t faces = m_patterns.size();
        for (std::size_t first = 0; first < faces; first += kFacesPerReport) {
            if (!progress.report(static_cast<double>(first) / static_cast<double>(faces))) {
                return cancelled();
            }
            const std::size_t count = std::min(kFacesPerReport, faces - first);
            parallelFor(count, kFacesAtATime, threads, [&](std::size_t begin, std::size_t end) {
                LimitSurface::Evaluator evaluator(m_made.surface());
                for (std::size_t f = first + begin; f < first + end; ++f) {
                    fill(f, evaluator);
                }
            });
        }
        parallelFor(faces, 4096, threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t f = begin; f < end; ++f) {
                join(f);
            }
        });
        return {};
    }

private:
    void fill(std::size_t f, LimitSurface::Evaluator& evaluator)
    {
        const CutPattern& pattern = *m_patterns[f];
        const std::uint32_t first = m_made.m_firstVertex[f];
        const auto vertices = m_made.m_vertices.begin() + first;
        std::ranges::transform(pattern.triangles,
                               m_made.m_triangles.begin() + m_made.m_firstTriangle[f],
                               [&](const std::array<std::uint16_t, 3>& t) {
                                   return Triangle{first + t[0], first + t[1], first + t[2]};
                               });
        if (m_before && m_before->m_rates[f] == m_made.m_rates[f]) {
            std::copy_n(m_before->m_vertices.begin() + m_before->m_firstVertex[f],
                        pattern.points.size(),
                        vertices);
            return;
        }
        evaluator.moveTo(faceId(f));
        glm::dvec3 instead = evaluator.at({1.0 / 3, 1.0 / 3}).normal();
        if (instead == glm::dvec3(0)) {
            instead = {0, 0, 1};
        }
        std::ranges::transform(pattern.points, vertices, [&](glm::dvec2 uv) {
            const LimitPoint point = evaluator.at(uv);
            return LimitVertex{glm::vec3(point.position),
                               normalAt(point, instead),
                               glm::vec2(uv),
                               static_cast<std::uint32_t>(f)};
        });
    }

    // Faces only write where they own nothing, and only read what is owned.
    void join(std::size_t f)
    {
        const LimitSurface& surface = m_made.surface();
        const auto edges = surface.edges(faceId(f));
        const Triangle& vertices = surface.vertices(faceId(f));
        for (std::uint32_t k = 0; k < 3; ++k) {
            const LimitOwner corner = m_made.m_bends->vertexOwners()[vertices[k]];
            if (corner.face != f) {
                place(f, firstOfEdge(m_made.m_rates[f], k)) =
                    place(corner.face, firstOfEdge(m_made.m_rates[corner.face], corner.corner));
            }
            const LimitOwner edge = m_made.m_bends->edgeOwners()[edges[k]];
            if (edge.face != f) {
                joinEdge(f, k, edge);
            }
        }
    }

    void joinEdge(std::size_t f, std::uint32_t k, LimitOwner owner)
    {
        const CutRates& rates = m_made.m_rates[f];
        const std::uint32_t pieces = rates.edges[k];
        const std::uint32_t mine = firstOfEdge(rates, k);
        const std::uint32_t theirs = firstOfEdge(m_made.m_rates[owner.face], owner.corner);
        const LimitSurface& surface = m_made.surface();
        const bool isSameWay =
            surface.vertices(faceId(f))[k] == surface.vertices(faceId(owner.face))[owner.corner];
        for (std::uint32_t p = 1; p < pieces; ++p) {
            place(f, mine + p) = place(owner.face, theirs + (isSameWay ? p : pieces - p));
        }
    }

    glm::vec3& place(std::size_t face, std::uint32_t point)
    {
        return m_made.m_vertices[m_made.m_firstVertex[face] + point].position;
    }

    LimitTessellation& m_made;
    std::shared_ptr<const LimitTessellation> m_before;
    PatternCutter m_cutter;
    std::vector<const CutPattern*> m_patterns; ///< one a face
};

Result<std::shared_ptr<const LimitTessellation>>
LimitTessellation::make(std::shared_ptr<const LimitBends> bends,
                        const LimitDemand& demand,
                        std::shared_ptr<const LimitTessellation> before,
                        Threads threads,
                        Progress& progress)
{
    check(demand.error > 0, "an error that can be met");
    const std::shared_ptr<LimitTessellation> made(new LimitTessellation());
    made->m_bends = std::move(bends);
    RatePlan plan = planRates(*made->m_bends, demand.scale, demand.error, demand.mostTriangles);
    made->m_rates = std::move(plan.faces);
    made->m_error = plan.error;
    if (const Status status = Build(*made, std::move(before)).run(threads, progress); !status) {
        return tl::unexpected(status.error());
    }
    return made;
}

bool LimitTessellation::isAsDemanded(const LimitDemand& demand) const
{
    return planRates(*m_bends, demand.scale, demand.error, demand.mostTriangles).faces == m_rates;
}

} // namespace trixel
