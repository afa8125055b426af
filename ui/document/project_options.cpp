// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/project_options.h"

#include "core/io/new_project.h"

#include <algorithm>
#include <string>
#include <utility>

namespace trixel::ui {

Result<LevelPlan> planFor(const TriangleMesh& mesh, const ProjectOptions& options)
{
    switch (options.size) {
    case SizeChoice::Level:
        if (const std::optional<Level> level = Level::fromInput(options.level)) {
            return planUniform(mesh.faceCount(), *level);
        }
        return contentsError("The level is " + std::to_string(options.level) +
                             "; it must be from 0 to " + std::to_string(Level::kMax) + ".");
    case SizeChoice::Density:
        return planByDensity(mesh, options.density);
    case SizeChoice::Total:
        break;
    }
    return planByTotal(mesh, options.total);
}

Result<Project> makeProject(TriangleMesh mesh, const ProjectOptions& options, Progress& progress)
{
    const Result<LevelPlan> plan = planFor(mesh, options);
    if (!plan) {
        return tl::unexpected(plan.error());
    }
    std::vector<float> fill(options.format.channels);
    for (std::size_t k = 0; k < fill.size(); ++k) {
        fill[k] = options.fill[std::min<std::size_t>(k, options.fill.size() - 1)];
    }
    return newProject(std::move(mesh), *plan, options.format, fill, progress);
}

ProjectOptions defaultOptions(std::size_t faceCount)
{
    ProjectOptions options;
    options.total = std::max<std::uint64_t>(options.total, std::uint64_t{16} * faceCount);
    return options;
}

} // namespace trixel::ui
