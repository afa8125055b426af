// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/filter_input.h"

#include "app/cli/file_kind.h"
#include "core/io/new_project.h"
#include "core/io/ptx.h"
#include "core/mesh/mesh_reader.h"
#include "core/study/solid_texture.h"

#include <algorithm>

namespace trixel::app {
namespace {

Result<FilterInput> sceneOf(FilterSurface surface,
                            const TexelStore& texels,
                            std::optional<TriangleMesh> mesh,
                            Progress& progress)
{
    return FilterScene::build(std::make_shared<const FilterSurface>(std::move(surface)),
                              texels,
                              Threads::all(),
                              progress)
        .map([&](FilterScene&& scene) {
            return FilterInput{std::make_shared<const FilterScene>(std::move(scene)),
                               std::move(mesh)};
        });
}

Result<FilterInput> sceneOf(const Project& project, Progress& progress)
{
    return sceneOf(FilterSurface::fromMesh(project.surface->mesh(), project.surface->adjacency()),
                   project.texels,
                   project.surface->mesh(),
                   progress);
}

Result<FilterInput> sceneOfMesh(const std::filesystem::path& path, Progress& progress)
{
    StageProgress reading(progress, 0, 0.2);
    const auto mesh = readMesh(path, reading);
    if (!mesh) {
        return tl::unexpected(mesh.error());
    }
    const auto plan = planByTotal(*mesh, defaultTexelTotal(mesh->faceCount()));
    if (!plan) {
        return prefixed(path.string(), plan.error());
    }
    const auto data = parseTestData(storedTestFiles());
    if (!data) {
        return tl::unexpected(data.error());
    }
    StageProgress painting(progress, 0.2, 0.6);
    const auto texels = solidTexture(*mesh, *plan, *data, Threads::all(), painting);
    if (!texels) {
        return tl::unexpected(texels.error());
    }
    StageProgress building(progress, 0.6, 1);
    return sceneOf(
        FilterSurface::fromMesh(*mesh, buildAdjacency(mesh->triangles)), *texels, *mesh, building);
}

bool carriesMesh(const PtxContents& contents)
{
    return std::ranges::any_of(contents.metadata, [](const PtxMetadata& item) {
        return item.key == "PtexFaceVertIndices";
    });
}

Result<FilterInput> sceneOfPtx(const std::filesystem::path& path,
                               const std::optional<std::filesystem::path>& meshPath,
                               Progress& progress)
{
    StageProgress reading(progress, 0, 0.5);
    StageProgress building(progress, 0.5, 1);
    if (meshPath) {
        auto mesh = readMesh(*meshPath, reading);
        if (!mesh) {
            return tl::unexpected(mesh.error());
        }
        const auto project = openPtxOnMesh(path, std::move(*mesh), reading);
        return project ? sceneOf(*project, building) : tl::unexpected(project.error());
    }
    const auto contents = readPtx(path, reading);
    if (!contents) {
        return tl::unexpected(contents.error());
    }
    if (carriesMesh(*contents)) {
        const auto project = openPtx(path, reading);
        return project ? sceneOf(*project, building) : tl::unexpected(project.error());
    }
    return sceneOf(
        FilterSurface::equilateral(contents->adjacency), contents->texels, std::nullopt, building);
}

} // namespace

Result<std::shared_ptr<const FilterScene>>
openFilterScene(const std::filesystem::path& path,
                const std::optional<std::filesystem::path>& mesh,
                Progress& progress)
{
    return openFilterInput(path, mesh, progress).map([](FilterInput&& input) {
        return std::move(input.scene);
    });
}

Result<FilterInput> openFilterInput(const std::filesystem::path& path,
                                    const std::optional<std::filesystem::path>& mesh,
                                    Progress& progress)
{
    const auto kind = expectFileKind(path);
    if (!kind) {
        return tl::unexpected(kind.error());
    }
    if (*kind == FileKind::Ptx) {
        return sceneOfPtx(path, mesh, progress);
    }
    if (mesh) {
        return contentsError("--mesh: " + path.string() +
                             " brings its own mesh; only a .ptx is put on another.");
    }
    if (*kind == FileKind::Mesh) {
        return sceneOfMesh(path, progress);
    }
    StageProgress opening(progress, 0, 0.5);
    const auto project = openProject(path, opening);
    if (!project) {
        return tl::unexpected(project.error());
    }
    StageProgress building(progress, 0.5, 1);
    return sceneOf(*project, building);
}

} // namespace trixel::app
