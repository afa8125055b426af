// SPDX-License-Identifier: GPL-3.0-or-later
//
// A .trixel project is a .ptx whose metadata hold the mesh and the project's version, until the
// project file proper takes its place behind this interface. Its texels are what is shown, or, of a
// project with layers, these side by side (layered_texels.h).
#include "core/io/project.h"

#include "core/io/layered_texels.h"
#include "core/io/layers_metadata.h"
#include "core/io/open_paint.h"
#include "core/io/project_metadata.h"
#include "core/io/ptx_file.h"
#include "core/io/ptx_mesh_match.h"
#include "core/io/ptx_metadata.h"
#include "core/io/ptx_reader.h"
#include "core/io/sharpness_metadata.h"

#include <string>

namespace trixel {

namespace {

// A file that was opened but not yet read, with its metadata.
struct OpenedFile
{
    MemoryBudget budget;
    PtxFile file;
    std::vector<PtxMetadata> metadata;
};

tl::unexpected<Error> inFile(const std::filesystem::path& path, const Error& error)
{
    return error.kind == ErrorKind::Contents ? prefixed(path.string(), error)
                                             : tl::unexpected(error);
}

Result<OpenedFile> openFile(const std::filesystem::path& path)
{
    MemoryBudget budget;
    auto file = openPtxFile(path, budget);
    if (!file) {
        return tl::unexpected(file.error());
    }
    auto metadata = file->metadata(budget);
    if (!metadata) {
        return inFile(path, metadata.error());
    }
    return OpenedFile{budget, std::move(*file), std::move(*metadata)};
}

Status compareWithMesh(const PtxFile& file, const Surface& surface)
{
    std::string difference;
    matchPtxWithMesh(file.infos(),
                     surface.adjacency(),
                     surface.report().nonManifoldEdges,
                     [&](std::string sentence) {
                         difference = std::move(sentence);
                         return false;
                     });
    return difference.empty() ? Status() : contentsError("does not fit the mesh: " + difference);
}

// Puts the texture onto the mesh; errors do not name the file.
Result<Project> assemble(const std::filesystem::path& path,
                         OpenedFile opened,
                         TriangleMesh mesh,
                         const OpenOptions& options,
                         Progress& progress)
{
    const Result<CreaseAngle> creases = creaseAngleOf(opened.metadata);
    if (!creases) {
        return tl::unexpected(creases.error());
    }
    StageProgress building(progress, 0, 0.4);
    auto surface = Surface::build(std::move(mesh), building);
    if (!surface) {
        return tl::unexpected(surface.error());
    }
    if (Status status = compareWithMesh(opened.file, **surface); !status) {
        return tl::unexpected(status.error());
    }
    StageProgress reading(progress, 0.4, 1);
    auto paint = openPaint(
        std::move(opened.file), path.string(), opened.metadata, options, opened.budget, reading);
    if (!paint) {
        return tl::unexpected(paint.error());
    }
    return Project{std::move(*surface),
                   std::move(paint->texels),
                   withoutMesh(std::move(opened.metadata)),
                   std::move(paint->faces),
                   *creases,
                   std::move(paint->layers)};
}

Result<Project> openWithOwnMesh(const std::filesystem::path& path,
                                OpenedFile opened,
                                const OpenOptions& options,
                                Progress& progress)
{
    auto mesh = meshOf(opened.metadata, opened.file.faceCount());
    if (!mesh) {
        return inFile(path, mesh.error());
    }
    auto project = assemble(path, std::move(opened), std::move(*mesh), options, progress);
    return project ? std::move(project) : inFile(path, project.error());
}

PtxContents contentsOf(const Project& project)
{
    PtxContents contents;
    contents.texels = project.texels;
    contents.adjacency = project.surface->adjacency();
    contents.metadata = withoutMesh(project.metadata);
    for (PtxMetadata& item : metadataOf(project.surface->mesh())) {
        contents.metadata.push_back(std::move(item));
    }
    if (project.creaseAngle) {
        contents.metadata.push_back({kCreaseAngleKey, std::vector<float>{*project.creaseAngle}});
    }
    return contents;
}

} // namespace

Result<Project>
openProject(const std::filesystem::path& path, Progress& progress, const OpenOptions& options)
{
    auto opened = openFile(path);
    if (!opened) {
        return tl::unexpected(opened.error());
    }
    const std::optional<int> version = projectVersionOf(opened->metadata);
    if (!version) {
        return contentsError(path.string() + ": is a .ptx texture, not a Trixel project");
    }
    if (*version < 1 || *version > kProjectVersion) {
        return contentsError(path.string() + ": is a project of version " +
                             std::to_string(*version) + ", this Trixel opens versions up to " +
                             std::to_string(kProjectVersion));
    }
    if (*version >= kLayersVersion && findMetadata(opened->metadata, kLayersKey) == nullptr) {
        return contentsError(path.string() + ": is a project of version " +
                             std::to_string(*version) + ", but does not name its layers (" +
                             kLayersKey + ")");
    }
    return openWithOwnMesh(path, std::move(*opened), options, progress);
}

Status saveProject(const std::filesystem::path& path, const Project& project, Progress& progress)
{
    PtxContents contents = contentsOf(project);
    const bool isPlain = project.layers.isPlain();
    if (!isPlain) {
        contents.texels = sideBySide(project.layers);
        contents.metadata.push_back(metadataOf(project.layers.layers()));
    }
    contents.metadata.push_back(
        {kProjectVersionKey, std::vector<std::int32_t>{isPlain ? kPlainVersion : kLayersVersion}});
    return writePtx(path, contents, {.mips = false}, progress);
}

Result<Project>
openPtx(const std::filesystem::path& path, Progress& progress, const OpenOptions& options)
{
    auto opened = openFile(path);
    if (!opened) {
        return tl::unexpected(opened.error());
    }
    if (!carriesMesh(opened->metadata)) {
        return contentsError(path.string() +
                             ": does not carry its mesh; open it together with the mesh it was "
                             "painted on");
    }
    return openWithOwnMesh(path, std::move(*opened), options, progress);
}

Result<Project> openPtxOnMesh(const std::filesystem::path& path,
                              TriangleMesh mesh,
                              Progress& progress,
                              const OpenOptions& options)
{
    auto opened = openFile(path);
    if (!opened) {
        return tl::unexpected(opened.error());
    }
    if (mesh.faceCount() != opened->file.faceCount()) {
        return contentsError(path.string() + ": is a texture of " +
                             std::to_string(opened->file.faceCount()) + " faces, the mesh has " +
                             std::to_string(mesh.faceCount()));
    }
    auto project = assemble(path, std::move(*opened), std::move(mesh), options, progress);
    return project ? std::move(project) : inFile(path, project.error());
}

Result<OpenedTexels>
openPtxTexels(const std::filesystem::path& path, Progress& progress, const OpenOptions& options)
{
    auto opened = openFile(path);
    if (!opened) {
        return tl::unexpected(opened.error());
    }
    auto paint = openPaint(std::move(opened->file),
                           path.string(),
                           opened->metadata,
                           options,
                           opened->budget,
                           progress);
    if (!paint) {
        return inFile(path, paint.error());
    }
    return OpenedTexels{std::move(paint->texels), std::move(paint->faces)};
}

Status exportPtx(const std::filesystem::path& path,
                 const Project& project,
                 const PtxWriteOptions& options,
                 Progress& progress)
{
    PtxContents contents = contentsOf(project);
    removeMetadata(contents.metadata, kViewsKey); // of the project, not of its texture
    return writePtx(path, contents, options, progress);
}

} // namespace trixel
