// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/atlas/handoff_pages.h"
#include "core/base/read_file.h"
#include "core/io/atlas/export_files.h"
#include "core/io/mesh/uv_mesh.h"

#include <algorithm>
#include <utility>

namespace trixel {

namespace {

enum class MeshFile { Glb, Obj, Ply };

std::optional<MeshFile> meshFileOf(const std::string& ending)
{
    return ending == "glb"   ? std::optional(MeshFile::Glb)
           : ending == "obj" ? std::optional(MeshFile::Obj)
           : ending == "ply" ? std::optional(MeshFile::Ply)
                             : std::nullopt;
}

struct HandOffPlan
{
    MeshFile mesh{};
    std::shared_ptr<const FilterSurface> surface;
    HandOffLayout layout;
    PageKind kind;
    std::vector<ColorSpace> texelColors; ///< what the pages are made of
    std::vector<std::string> pageFiles;
};

Result<HandOffPlan> planHandOff(const std::filesystem::path& path,
                                const Project& project,
                                const HandOffExportOptions& options)
{
    const auto mesh = meshFileOf(endingOf(path));
    if (!mesh) {
        return contentsError(path.string() + ": expected a name that ends in .glb, .obj or .ply");
    }
    if (project.texels.faceCount() == 0) {
        return contentsError(path.string() + ": there is no face to export");
    }
    const std::string ending = *mesh == MeshFile::Glb ? "png" : options.imageEnding;
    HandOffPlan plan;
    plan.mesh = *mesh;
    auto kind = pageKind(ending, project, options.image);
    if (!kind) {
        return prefixed(path.string(), kind.error());
    }
    plan.kind = std::move(*kind);
    plan.texelColors = plan.kind.colors;
    if (*mesh == MeshFile::Glb) {
        std::ranges::replace(plan.kind.colors, ColorSpace::Linear, ColorSpace::SRgb);
    }
    plan.surface = std::make_shared<const FilterSurface>(
        FilterSurface::fromMesh(project.surface->mesh(), project.surface->adjacency()));
    auto layout = HandOffLayout::plan(
        handOffIntervals(project.texels, *plan.surface, options.layout), options.layout);
    if (!layout) {
        return prefixed(path.string(), layout.error());
    }
    plan.layout = std::move(*layout);
    plan.pageFiles = pageNames(path.stem().string(), ending, plan.layout.pages().size());
    if (*mesh == MeshFile::Ply && plan.pageFiles.size() > 1) {
        return contentsError(path.string() + ": a PLY file names one texture, and this needs " +
                             std::to_string(plan.pageFiles.size()) +
                             " pages: allow larger ones, or write .glb or .obj");
    }
    if (Status usable =
            checkPages(path.parent_path(), plan.pageFiles, plan.layout.pages(), plan.kind.format);
        !usable) {
        return tl::unexpected(usable.error());
    }
    return plan;
}

FaceMap<FaceUvs> uvsOf(const HandOffLayout& layout)
{
    constexpr std::array<glm::dvec2, 3> kCorners = {
        glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1)};
    FaceMap<FaceUvs> uvs(layout.faceCount());
    for (std::size_t f = 0; f < layout.faceCount(); ++f) {
        const FaceId face = faceId(f);
        const std::uint32_t page = layout.place(face).page;
        uvs[face].texture = page;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec2 at = layout.position(face, kCorners[k]);
            uvs[face].corners[k] = glm::vec2(at.x / layout.pages()[page].width,
                                             1 - at.y / layout.pages()[page].height);
        }
    }
    return uvs;
}

Result<std::vector<Image>> drawPages(const Project& project,
                                     HandOffPlan& plan,
                                     const HandOffExportOptions& options,
                                     Progress& progress)
{
    StageProgress preparing(progress, 0, 0.2);
    const auto scene =
        FilterScene::build(plan.surface, project.texels, options.image.threads, preparing);
    if (!scene) {
        return tl::unexpected(scene.error());
    }
    if (const Status whole = project.texels.checkWhole(); !whole) {
        return tl::unexpected(whole.error());
    }
    StageProgress drawing(progress, 0.2, 1);
    return handOffPages(plan.layout,
                        *scene,
                        *makeMethod(options.method),
                        plan.kind.format,
                        {plan.kind.colors, plan.texelColors},
                        options.image.threads,
                        drawing);
}

Status writeGlbOf(const std::filesystem::path& path,
                  const UvMesh& uvMesh,
                  const std::vector<std::filesystem::path>& pngs,
                  Progress& progress)
{
    std::vector<std::vector<std::byte>> contents;
    for (const std::filesystem::path& png : pngs) {
        const auto bytes = readFile(png);
        if (!bytes) {
            return tl::unexpected(bytes.error());
        }
        const auto all = std::as_bytes(std::span(*bytes));
        contents.emplace_back(all.begin(), all.end());
    }
    return writeGlb(path, uvMesh, contents, progress);
}

Status writeHandOff(const ImageWorker& worker,
                    StagedFiles& files,
                    const std::filesystem::path& path,
                    const Project& project,
                    const HandOffPlan& plan,
                    std::span<const Image> pages,
                    Threads threads,
                    Progress& progress)
{
    std::vector<std::filesystem::path> paths;
    for (const std::string& name : plan.pageFiles) {
        paths.push_back(plan.mesh == MeshFile::Glb ? files.scratch(name) : files.add(name));
    }
    ImageWriteOptions writing;
    writing.threads = threads;
    StageProgress images(progress, 0, 0.8);
    if (Status written = writePages(worker, paths, pages, writing, images); !written) {
        return written;
    }
    const UvMesh uvMesh{project.surface->mesh(),
                        uvsOf(plan.layout),
                        plan.pageFiles,
                        plan.kind.format.alpha.has_value()};
    StageProgress mesh(progress, 0.8, 1);
    switch (plan.mesh) {
    case MeshFile::Glb:
        return writeGlbOf(files.add(path.filename().string()), uvMesh, paths, mesh);
    case MeshFile::Obj: {
        const std::filesystem::path materials = files.add(path.stem().string() + ".mtl");
        return writeObj(files.add(path.filename().string()), materials, uvMesh, mesh);
    }
    case MeshFile::Ply:
        break;
    }
    return writePly(files.add(path.filename().string()), uvMesh, mesh);
}

} // namespace

Result<AtlasEstimate> estimateHandOff(const std::filesystem::path& path,
                                      const Project& project,
                                      const HandOffExportOptions& options)
{
    const auto plan = planHandOff(path, project, options);
    if (!plan) {
        return tl::unexpected(plan.error());
    }
    AtlasEstimate estimate{{plan->layout.pages().begin(), plan->layout.pages().end()},
                           {},
                           plan->kind.format,
                           plan->layout.occupancy(),
                           std::nullopt};
    if (plan->mesh != MeshFile::Glb) {
        estimate.files = plan->pageFiles;
    }
    if (plan->mesh == MeshFile::Obj) {
        estimate.files.push_back(path.stem().string() + ".mtl");
    }
    estimate.files.push_back(path.filename().string());
    return estimate;
}

Result<HandOffOutcome> exportHandOff(const ImageWorker& worker,
                                     const std::filesystem::path& path,
                                     const Project& project,
                                     const HandOffExportOptions& options,
                                     Progress& progress)
{
    auto plan = planHandOff(path, project, options);
    if (!plan) {
        return tl::unexpected(plan.error());
    }
    // First of all, so that a folder that cannot be written to is noticed before the work.
    auto files = StagedFiles::beside(path.parent_path());
    if (!files) {
        return tl::unexpected(files.error());
    }
    StageProgress drawing(progress, 0, 0.6);
    const auto pages = drawPages(project, *plan, options, drawing);
    if (!pages) {
        return tl::unexpected(pages.error());
    }
    StageProgress writing(progress, 0.6, 0.95);
    const Status written =
        writeHandOff(worker, *files, path, project, *plan, *pages, options.image.threads, writing);
    if (!written) {
        return tl::unexpected(files->told(written.error()));
    }
    StageProgress measuring(progress, 0.95, 1);
    const auto report = measureHandOff(
        plan->layout, *pages, project.surface->adjacency(), 3, options.image.threads, measuring);
    if (!report) {
        return tl::unexpected(report.error());
    }
    if (!progress.report(1)) {
        return cancelled();
    }
    if (Status moved = files->commit(); !moved) {
        return tl::unexpected(moved.error());
    }
    return HandOffOutcome{report->largestJump};
}

} // namespace trixel
