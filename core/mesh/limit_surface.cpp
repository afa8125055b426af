// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/limit_surface.h"

#include "core/base/check.h"
#include "core/mesh/loop_cage.h"

#include <glm/geometric.hpp>
#include <mutex>
#include <new>
#include <opensubdiv/bfr/refinerSurfaceFactory.h>
#include <opensubdiv/bfr/surface.h>
#include <opensubdiv/far/topologyLevel.h>
#include <optional>
#include <shared_mutex>

namespace trixel {

namespace {

namespace Bfr = OpenSubdiv::Bfr;
namespace Far = OpenSubdiv::Far;

using Cache = Bfr::SurfaceFactoryCacheThreaded<std::shared_mutex,
                                               std::shared_lock<std::shared_mutex>,
                                               std::unique_lock<std::shared_mutex>>;
using Factory = Bfr::RefinerSurfaceFactory<Cache>;
using Patch = Bfr::Surface<double>; // in double: far from the origin floats leave steps

/// Level 2, the library's own choice, is off by 8e-3 of a face at irregular vertices; 6 costs a
/// third more a face than 4 for a tenth of its error. What is left is within 1/32 of a vertex.
constexpr int kSmoothLevel = 5;

Factory::Options factoryOptions()
{
    Factory::Options options;
    options.SetApproxLevelSmooth(kSmoothLevel);
    return options;
}

} // namespace

glm::dvec3 LimitPoint::normal() const
{
    const glm::dvec3 across = glm::cross(perU, perV);
    const double length = glm::length(across);
    return length > 1e-14 * glm::length(perU) * glm::length(perV) ? across / length : glm::dvec3(0);
}

std::array<glm::vec3, 3> LimitPoint::tangentFace(glm::dvec2 uv) const
{
    const glm::dvec3 origin = position - uv.x * perU - uv.y * perV;
    return {glm::vec3(origin), glm::vec3(origin + perU), glm::vec3(origin + perV)};
}

struct LimitSurface::Patches
{
    explicit Patches(LoopRefiner cage)
        : refiner(std::move(cage))
        , factory(*refiner, factoryOptions())
    {
    }

    LoopRefiner refiner;
    Factory factory;
};

LimitSurface::LimitSurface() = default;
LimitSurface::~LimitSurface() = default;

Result<std::shared_ptr<const LimitSurface>> LimitSurface::build(const TriangleMesh& cage,
                                                                const Sharpness& sharpness)
{
    if (Status status = checkLoopCage(cage); !status) {
        return tl::unexpected(status.error());
    }
    if (Status status = checkSharpness(cage, sharpness); !status) {
        return tl::unexpected(status.error());
    }
    try {
        LoopRefiner refiner = makeLoopRefiner(cage, sharpness);
        if (!refiner) {
            return contentsError("the cage's faces cannot be refined together");
        }
        const std::shared_ptr<LimitSurface> surface(new LimitSurface());
        surface->m_positions = cage.positions;
        surface->m_triangles = cage.triangles;
        surface->m_patches = std::make_unique<Patches>(std::move(refiner));
        return surface;
    } catch (const std::bad_alloc&) {
        return contentsError("not enough memory for the cage's limit surface");
    }
}

Status LimitSurface::check(const TriangleMesh& cage)
{
    return checkLoopCage(cage);
}

std::size_t LimitSurface::edgeCount() const
{
    return static_cast<std::size_t>(m_patches->refiner->GetLevel(0).GetNumEdges());
}

std::array<std::uint32_t, 3> LimitSurface::edges(FaceId face) const
{
    const Far::ConstIndexArray edges =
        m_patches->refiner->GetLevel(0).GetFaceEdges(static_cast<int>(face));
    return {static_cast<std::uint32_t>(edges[0]),
            static_cast<std::uint32_t>(edges[1]),
            static_cast<std::uint32_t>(edges[2])};
}

bool LimitSurface::isRegular(FaceId face) const
{
    const Far::TopologyLevel level = m_patches->refiner->GetLevel(0);
    for (const std::uint32_t v : vertices(face)) {
        const int vertex = static_cast<int>(v);
        if (level.IsVertexBoundary(vertex) || level.IsVertexNonManifold(vertex) ||
            level.GetVertexFaces(vertex).size() != 6 ||
            level.GetVertexRule(vertex) != OpenSubdiv::Sdc::Crease::RULE_SMOOTH) {
            return false;
        }
    }
    return true;
}

struct LimitSurface::Evaluator::State
{
    const LimitSurface& surface;
    Patch patch;
    std::vector<double> points; ///< xyz each
    std::optional<FaceId> face;
};

LimitSurface::Evaluator::Evaluator(const LimitSurface& surface)
    : m_state(new State{surface, {}, {}, {}})
{
}

LimitSurface::Evaluator::~Evaluator() = default;
LimitSurface::Evaluator::Evaluator(Evaluator&&) noexcept = default;

void LimitSurface::Evaluator::moveTo(FaceId face)
{
    State& s = *m_state;
    if (s.face == face) {
        return;
    }
    trixel::check(indexOf(face) < s.surface.faceCount(), "a face of the limit surface");
    const bool made =
        s.surface.m_patches->factory.InitVertexSurface(static_cast<int>(face), &s.patch);
    trixel::check(made, "every face of a cage has a limit"); // only holes have none
    s.points.resize(3 * static_cast<std::size_t>(s.patch.GetNumPatchPoints()));
    s.patch.GatherControlPoints(&s.surface.m_positions.front().x, 3, s.points.data(), 3);
    s.patch.ComputePatchPoints(s.points.data(), 3);
    s.face = face;
}

glm::dvec3 LimitSurface::Evaluator::position(glm::dvec2 uv) const
{
    glm::dvec3 position;
    m_state->patch.Evaluate(&uv.x, m_state->points.data(), 3, &position.x);
    return position;
}

LimitPoint LimitSurface::Evaluator::at(glm::dvec2 uv) const
{
    LimitPoint point;
    m_state->patch.Evaluate(
        &uv.x, m_state->points.data(), 3, &point.position.x, &point.perU.x, &point.perV.x);
    return point;
}

LimitPoint LimitSurface::at(FaceId face, glm::dvec2 uv) const
{
    Evaluator evaluator(*this);
    evaluator.moveTo(face);
    return evaluator.at(uv);
}

} // namespace trixel
