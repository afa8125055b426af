// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/sample_scene.h"

#include "core/io/new_project.h"
#include "core/mesh/loop_refinement.h"
#include "core/mesh/mesh_reader.h"
#include "core/paint/stroke_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace trixel {
namespace {

constexpr int kLoopSteps = 2;
constexpr TexelFormat kFormat{TexelType::UInt8, 3, std::nullopt};
constexpr std::array<float, 3> kFill{0x45 / 255.0F, 0xB8 / 255.0F, 0x92 / 255.0F};

/// Texels per world unit away from every focus.
constexpr float kDensity = 100;

/// A place that is looked at closely: the density grows by `gain` times towards its centre.
struct Focus
{
    glm::vec3 centre;
    float radius;
    float gain;
};
const std::array<Focus, 3> kFoci{{{{0, 0.75F, 1.15F}, 0.75F, 1.2F},    // head
                                  {{0.5F, 0.9F, 1.2F}, 0.3F, 1.6F},    // left eye
                                  {{-0.5F, 0.9F, 1.2F}, 0.3F, 1.6F}}}; // right eye

float densityAt(glm::vec3 position)
{
    float gain = 1;
    for (const Focus& focus : kFoci) {
        const float distance = glm::distance(position, focus.centre) / focus.radius;
        gain += focus.gain * std::exp(-distance * distance);
    }
    return kDensity * gain;
}

LevelPlan planLevels(const TriangleMesh& mesh)
{
    LevelPlan plan{FaceMap<Level>(mesh.faceCount()), 0};
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const auto c = mesh.corners(faceId(f));
        const float edge =
            (glm::distance(c[0], c[1]) + glm::distance(c[1], c[2]) + glm::distance(c[2], c[0])) / 3;
        const float texels = std::max(1.0F, edge * densityAt((c[0] + c[1] + c[2]) / 3.0F));
        const Level level(std::min(Level::kMax, static_cast<int>(std::lround(std::log2(texels)))));
        plan.levels[faceId(f)] = level;
        plan.texels += level.texelCount();
    }
    return plan;
}

Result<TriangleMesh> refinedCage(std::string_view cageObj, Progress& progress)
{
    auto mesh =
        parseMesh(MeshFormat::Obj, cageObj, progress).and_then([](const TriangleMesh& cage) {
            return loopRefined(cage, kLoopSteps);
        });
    if (!mesh) {
        return prefixed("the sample scene's cage", mesh.error());
    }
    // From here on each triangle stands for itself: the cage's were no polygons to paint as one.
    mesh->sourceFaces.clear();
    return mesh;
}

} // namespace

Result<Project> buildSampleScene(std::string_view cageObj,
                                 std::string_view strokesJson,
                                 Progress& progress,
                                 Threads threads)
{
    StageProgress reading(progress, 0, 0.05);
    auto mesh = refinedCage(cageObj, reading);
    if (!mesh) {
        return tl::unexpected(mesh.error());
    }
    const auto strokes = parseStrokes(strokesJson, mesh->faceCount());
    if (!strokes) {
        return prefixed("the sample scene's strokes", strokes.error());
    }
    const LevelPlan plan = planLevels(*mesh);
    StageProgress building(progress, 0.05, 0.2);
    auto project = newProject(std::move(*mesh), plan, kFormat, kFill, building);
    if (!project) {
        return project;
    }
    StageProgress painting(progress, 0.2, 1);
    const Status painted = replayStrokes(
        *strokes, project->surface, fillOf(*project), project->texels, threads, painting);
    if (!painted) {
        return tl::unexpected(painted.error());
    }
    return project;
}

} // namespace trixel
