// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/study_scene.h"

namespace trixel::ui {

Result<std::shared_ptr<const FilterScene>> studyScene(const Project& project, Progress& progress)
{
    auto surface = std::make_shared<const FilterSurface>(
        FilterSurface::fromMesh(project.surface->mesh(), project.surface->adjacency()));
    return FilterScene::build(std::move(surface), project.texels, Threads::all(), progress)
        .map([](FilterScene&& scene) {
            return std::make_shared<const FilterScene>(std::move(scene));
        });
}

} // namespace trixel::ui
