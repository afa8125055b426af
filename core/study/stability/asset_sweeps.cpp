// SPDX-License-Identifier: GPL-3.0-or-later
//
// The hazards of an asset's own faces: which are there, and what filters make of the worst.
#include "core/filter/filter_method.h"
#include "core/lattice/edge_transfer.h"
#include "core/mesh/triangle_geometry.h"
#include "core/study/stability/stability.h"
#include "core/study/stability/sweeps.h"
#include "core/study/value_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace trixel {
namespace {

/// Flatter faces than this (height over longest edge) are needles.
constexpr double kNeedle = 0.05;
/// Vertices of more faces than this are remarkable.
constexpr std::size_t kManyFaces = 12;
/// Edges between faces so many levels apart are remarkable.
constexpr int kManyLevels = 2;
/// As many of the worst are asked for their value.
constexpr std::size_t kAsked = 16;

/// A face and how bad it is.
struct Suspect
{
    FaceId face{};
    double badness = 0; ///< the larger the worse
};

/// What was found of one kind, worst first once sorted.
struct Suspects
{
    std::vector<Suspect> faces;
    std::uint64_t count = 0;

    void add(FaceId face, double badness)
    {
        ++count;
        faces.push_back({face, badness});
    }
    void sort()
    {
        std::ranges::sort(faces, [](const Suspect& a, const Suspect& b) {
            return a.badness != b.badness ? a.badness > b.badness : a.face < b.face;
        });
    }
};

/// Height over the longest edge.
double flatness(const std::array<glm::vec3, 3>& c)
{
    const glm::dvec3 e1 = glm::dvec3(c[1]) - glm::dvec3(c[0]);
    const glm::dvec3 e2 = glm::dvec3(c[2]) - glm::dvec3(c[0]);
    const double longest = std::max({glm::length(e1), glm::length(e2), glm::length(e2 - e1)});
    return longest > 0 ? glm::length(glm::cross(e1, e2)) / longest / longest : 0;
}

bool isNeedle(const FilterScene& scene, FaceId face)
{
    const FaceShape& shape = scene.surface().shape(face);
    const double longest =
        std::max({glm::length(shape.e1), glm::length(shape.e2), glm::length(shape.e2 - shape.e1)});
    return shape.e1.x * shape.e2.y < kNeedle * longest * longest;
}

Suspects zeroAreas(const TriangleMesh& mesh)
{
    Suspects found;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        if (isDegenerate(mesh.corners(faceId(f)))) {
            found.add(faceId(f), 0);
        }
    }
    return found;
}

Suspects needles(const TriangleMesh& mesh)
{
    Suspects found;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const double flat = flatness(mesh.corners(faceId(f)));
        if (flat < kNeedle && !isDegenerate(mesh.corners(faceId(f)))) {
            found.add(faceId(f), flat > 0 ? 1 / flat : INFINITY);
        }
    }
    return found;
}

Suspects crowdedVertices(const FilterScene& scene)
{
    Suspects found;
    const VertexRings& rings = scene.surface().rings();
    for (std::size_t r = 0; r < rings.ringCount(); ++r) {
        const auto corners = rings.corners(static_cast<RingId>(r));
        if (corners.size() > kManyFaces) {
            found.add(corners.front().face, static_cast<double>(corners.size()));
        }
    }
    return found;
}

Suspects levelSteps(const FilterScene& scene)
{
    Suspects found;
    for (std::size_t f = 0; f < scene.faceCount(); ++f) {
        for (const LocalEdge edge : kLocalEdges) {
            const auto across = scene.surface().adjacency().neighbour(faceId(f), edge);
            if (!across || indexOf(across->face) < f) {
                continue;
            }
            const int step =
                std::abs(scene.level(faceId(f)).log2() - scene.level(across->face).log2());
            if (step >= kManyLevels) {
                found.add(faceId(f), step);
            }
        }
    }
    return found;
}

/// The same question from both sides of an edge, in footprints of 1 and 4 texels.
void addEdge(const FilterScene& scene, FaceId face, LocalEdge edge, QueryArrays& a, QueryArrays& b)
{
    const auto crossing = scene.surface().crossing(face, edge);
    if (!crossing) {
        return;
    }
    const FaceShape& shape = scene.surface().shape(face);
    for (const double t : {0.1, 0.5, 0.8}) {
        const glm::dvec2 uv = fromEdge(edge, {t, 0});
        for (const double texels : {1.0, 4.0}) {
            const double width = texels * std::exp2(scene.log2TexelSize(face, uv));
            const glm::dvec2 w1 = shape.toUv({width, 0.2 * width});
            const glm::dvec2 w2 = shape.toUv({-0.2 * width, width});
            a.add(face, uv, w1, w2);
            b.add(crossing->face, crossing->point(uv), crossing->vector(w1), crossing->vector(w2));
        }
    }
}

/// Methods that claim to be continuous and answer quickly.
std::vector<std::unique_ptr<const FilterMethod>> askedMethods()
{
    std::vector<std::unique_ptr<const FilterMethod>> methods;
    for (const MethodEntry& entry : filterMethods()) {
        const bool slow = entry.name == "exact" || entry.name == "ewa-base";
        if (!slow && entry.claims.edgeContinuous == Claim::Yes) {
            methods.push_back(entry.make(entry.parameter ? entry.parameter->standard : 0));
        }
    }
    return methods;
}

double largestJump(const FilterScene& scene,
                   const FilterMethod& method,
                   const QueryArrays& a,
                   const QueryArrays& b)
{
    ResultArrays here(a.size(), scene.channels());
    ResultArrays there(b.size(), scene.channels());
    method.filter(scene, a.queries(), here.results());
    method.filter(scene, b.queries(), there.results());
    double largest = 0;
    for (std::size_t k = 0; k < here.values.size(); ++k) {
        const bool bothNaN = std::isnan(here.values[k]) && std::isnan(there.values[k]);
        const auto off = static_cast<double>(std::abs(here.values[k] - there.values[k]));
        largest = bothNaN ? largest : sweeps::worse(largest, off);
    }
    return largest;
}

/// Infinite where a footprint of no, any or no numeric length on a face gives no number although
/// the texels are numbers.
double hostileError(const FilterScene& scene, const FilterMethod& method, const Suspects& suspects)
{
    constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
    QueryArrays queries;
    for (std::size_t k = 0; k < std::min(kAsked, suspects.faces.size()); ++k) {
        for (const float length : {0.0F, 1e-40F, 1.0F, 1e30F, kNaN}) {
            queries.add(suspects.faces[k].face, {0.3F, 0.3F}, {length, 0}, {0, length});
        }
    }
    ResultArrays results(queries.size(), scene.channels());
    method.filter(scene, queries.queries(), results.results());
    return std::ranges::all_of(results.values, [](float v) { return std::isfinite(v); })
               ? 0
               : sweeps::kNoAnswer;
}

/// Whether every texel is a number: then every answer has to be one.
bool hasNumbersOnly(const FilterScene& scene)
{
    for (std::size_t f = 0; f < scene.faceCount(); ++f) {
        for (int c = 0; c < scene.channels(); ++c) {
            const float* average = scene.mips().average(faceId(f), c / kGroupChannels);
            if (!std::isfinite(average[c % kGroupChannels])) {
                return false;
            }
        }
    }
    return true;
}

/// Sets error and bound from the worst faces.
void ask(const FilterScene& scene,
         const Suspects& suspects,
         double range,
         bool numbersOnly,
         AssetFinding& finding)
{
    QueryArrays a;
    QueryArrays b;
    Level finest;
    for (std::size_t k = 0; k < std::min(kAsked, suspects.faces.size()); ++k) {
        const FaceId face = suspects.faces[k].face;
        for (const LocalEdge edge : kLocalEdges) {
            const auto across = scene.surface().adjacency().neighbour(face, edge);
            // On a needle the texture itself changes over the needle's height: no two floats for W
            // are near enough for the same answer.
            if (across && !isNeedle(scene, face) && !isNeedle(scene, across->face)) {
                addEdge(scene, face, edge, a, b);
                finest = std::max({finest, scene.level(face), scene.level(across->face)});
            }
        }
    }
    double error = 0;
    for (const auto& method : askedMethods()) {
        if (numbersOnly) {
            error = sweeps::worse(error, hostileError(scene, *method, suspects));
        }
        if (a.size() > 0 && range > 0) {
            error = sweeps::worse(error, largestJump(scene, *method, a, b) / range);
        }
    }
    finding.error = error;
    // Beside what methods claim, what the rounding of u and v to floats moves the point by, on
    // texels that change by the whole range from one to the next.
    finding.bound = 1e-5 + 4.0 * finest.resolution() * 0x1p-24;
}

} // namespace

StabilityAsset::StabilityAsset(std::string name, const FilterScene& scene, const TriangleMesh* mesh)
    : m_name(std::move(name))
    , m_mesh(mesh)
    , m_scene(&scene)
{
}

StabilityAsset::StabilityAsset(std::string name, const Surface& surface, const TexelStore* texels)
    : m_name(std::move(name))
    , m_mesh(&surface.mesh())
    , m_surface(&surface)
    , m_texels(texels)
{
    check(texels != nullptr, "texels of the surface");
}

Result<std::shared_ptr<const FilterScene>> StabilityAsset::scene(Threads threads,
                                                                 Progress& progress) const
{
    if (m_scene != nullptr) {
        // Somebody else's: the pointer only looks.
        return std::shared_ptr<const FilterScene>(std::shared_ptr<const FilterScene>(), m_scene);
    }
    auto surface = std::make_shared<const FilterSurface>(
        FilterSurface::fromMesh(m_surface->mesh(), m_surface->adjacency()));
    return FilterScene::build(std::move(surface), *m_texels, threads, progress)
        .map([](FilterScene&& scene) {
            return std::make_shared<const FilterScene>(std::move(scene));
        });
}

Result<std::vector<AssetFinding>>
findHazards(const StabilityAsset& asset, Threads threads, Progress& progress)
{
    StageProgress building(progress, 0, 0.2);
    const auto built = asset.scene(threads, building);
    if (!built) {
        return tl::unexpected(built.error());
    }
    const FilterScene& scene = **built;
    std::vector<AssetFinding> findings;
    const double range = valueRange(scene.mips(), threads);
    if (!progress.report(0.4)) {
        return cancelled();
    }
    const bool numbersOnly = hasNumbersOnly(scene);
    const auto add = [&](std::string name, std::string title, Suspects suspects) {
        suspects.sort();
        AssetFinding finding{std::move(name), std::move(title), suspects.count, 0, {}, {}, 0};
        if (!suspects.faces.empty()) {
            finding.worst = suspects.faces.front().badness;
            finding.face = suspects.faces.front().face;
            ask(scene, suspects, range, numbersOnly, finding);
        }
        findings.push_back(std::move(finding));
        return progress.report(0.4 + 0.6 * static_cast<double>(findings.size()) / 4);
    };
    const Suspects none;
    const bool goOn =
        add("asset-zero-area",
            "Faces without area",
            asset.mesh() != nullptr ? zeroAreas(*asset.mesh()) : none) &&
        add("asset-needles",
            "Needles (length over height above 20)",
            asset.mesh() != nullptr ? needles(*asset.mesh()) : none) &&
        add("asset-valence", "Vertices of more than 12 faces (faces)", crowdedVertices(scene)) &&
        add("asset-level-steps",
            "Edges between faces two and more levels apart (levels)",
            levelSteps(scene));
    if (!goOn) {
        return cancelled();
    }
    return findings;
}

} // namespace trixel
