// SPDX-License-Identifier: GPL-3.0-or-later
//
// Jumps across edges: vertices where few or many faces meet, faces of unlike levels.
#include "core/filter/filter_method.h"
#include "core/lattice/edge_transfer.h"
#include "core/study/stability/filter_cases.h"
#include "core/study/stability/scenes.h"

#include <array>
#include <cstdint>

namespace trixel::sweeps {

namespace {

constexpr double kSeamlessJump = 1e-5;

bool isContinuous(const MethodEntry& entry)
{
    return entry.claims.edgeContinuous == Claim::Yes;
}

/// White noise in [0,1) that is the same on every machine.
float noise(FaceId face, Level level, TexelIndex texel)
{
    std::uint64_t x =
        (indexOf(face) << 40U) ^ (static_cast<std::uint64_t>(level.log2()) << 32U) ^ indexOf(texel);
    x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    x = (x ^ (x >> 27U)) * 0x94D049BB133111EBULL;
    return static_cast<float>((x ^ (x >> 31U)) >> 40U) * 0x1p-24F;
}

/// The same questions from both sides of every edge.
struct EdgeCase
{
    FilterCase one;
    QueryArrays other;

    double jump(const FilterMethod& method) const
    {
        ResultArrays there(other.size(), one.scene.channels());
        method.filter(one.scene, other.queries(), there.results());
        const ResultArrays here = answersOf(one, method);
        double largest = 0;
        for (std::size_t k = 0; k < here.values.size(); ++k) {
            const auto off = static_cast<double>(std::abs(here.values[k] - there.values[k]));
            largest = worse(largest, off);
        }
        return largest;
    }
};

/// The face on its own knows nothing beyond its edges: what averaging per face does.
FilterScene isolated(const TriangleMesh& mesh, std::span<const Level> levels)
{
    const Adjacency none(mesh.faceCount());
    return sceneOf(mesh, none, levels, noise);
}

/// \param of    the surface that knows the neighbours
/// \param ends  the vertices too
void addEdgeQueries(EdgeCase& edges, const FilterSurface& of, bool ends)
{
    for (std::size_t f = 0; f < of.faceCount(); ++f) {
        for (const LocalEdge edge : kLocalEdges) {
            const auto crossing = of.crossing(faceId(f), edge);
            if (!crossing || indexOf(crossing->face) < f) {
                continue;
            }
            for (const double t : {0.0, 0.03125, 0.125, 0.3125, 0.5, 0.875, 0.96875, 1.0}) {
                if (!ends && (t == 0 || t == 1)) {
                    continue;
                }
                const glm::dvec2 uv = fromEdge(edge, {t, 0});
                for (const double width : {1e-3, 0.1, 0.5}) {
                    const glm::dvec2 w1(width, 0.2 * width);
                    const glm::dvec2 w2(-0.3 * width, 0.8 * width);
                    edges.one.queries.add(faceId(f), uv, w1, w2);
                    edges.other.add(crossing->face,
                                    crossing->point(uv),
                                    crossing->vector(w1),
                                    crossing->vector(w2));
                }
            }
        }
    }
}

FilterErrors edgeErrors(const TriangleMesh& mesh, std::span<const Level> levels, bool ends)
{
    EdgeCase together{{sceneOf(mesh, buildAdjacency(mesh.triangles), levels, noise), {}}, {}};
    addEdgeQueries(together, together.one.scene.surface(), ends);
    const EdgeCase apart{{isolated(mesh, levels), together.one.queries}, together.other};
    const double naive = apart.jump(*makeMethod({"lattice-linear", std::nullopt}));
    return {naive, [edges = std::move(together)](const FilterMethod& method) {
                return edges.jump(method);
            }};
}

} // namespace

StabilitySweep valence()
{
    StabilitySweep sweep{.name = "valence",
                         .title = "Vertices of valence 3 to 100",
                         .hazard = "Averages taken per face differ along every edge.",
                         .property = "The same value from both sides of an edge; at its ends, too, "
                                     "to valence 32.",
                         .axisTitle = "faces about the vertex",
                         .errorTitle = "jump across an edge, of the value range",
                         .bound = kSeamlessJump};
    for (const int count : {3, 4, 5, 6, 7, 8, 10, 16, 32, 100}) {
        sweep.values.push_back(sweepValue(count));
    }
    addFilterCurves(sweep, "averages per face", isContinuous, [](double count) {
        const TriangleMesh mesh = fan(static_cast<int>(count));
        const std::vector<Level> levels(mesh.faceCount(), Level(3));
        // Through 50 needles around the hub, lines are turned in single precision.
        const bool ends = count <= 32;
        return edgeErrors(mesh, levels, ends);
    });
    return sweep;
}

StabilitySweep levelStep()
{
    StabilitySweep sweep{.name = "level-step",
                         .title = "Neighbours up to 10 levels apart",
                         .hazard = "A fine face's own texels do not meet those of a coarse one.",
                         .property = "The same value from both sides of the edge.",
                         .axisTitle = "levels apart",
                         .axis = SweepAxis::Linear,
                         .errorTitle = "jump across the edge, of the value range",
                         .bound = kSeamlessJump};
    for (int step = 0; step <= 10; ++step) {
        sweep.values.push_back(sweepValue(step));
    }
    addFilterCurves(sweep, "averages per face", isContinuous, [](double step) {
        const std::array<Level, 2> levels{Level(static_cast<int>(step)), Level(0)};
        return edgeErrors(pairOfFaces(), levels, true);
    });
    return sweep;
}

} // namespace trixel::sweeps
