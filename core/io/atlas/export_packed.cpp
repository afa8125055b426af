// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/atlas/packed_pages.h"
#include "core/io/atlas/atlas_description.h"
#include "core/io/atlas/export_files.h"
#include "core/texture/convert.h"

#include <utility>

namespace trixel {

namespace {

FaceMap<Level> levelsOf(const TexelStore& store)
{
    FaceMap<Level> levels(store.faceCount());
    for (std::uint32_t f = 0; f < store.faceCount(); ++f) {
        levels[faceId(f)] = store.face(faceId(f)).level();
    }
    return levels;
}

struct PackedPlan
{
    AtlasLayout layout;
    PageKind kind;
    std::vector<std::string> pageFiles;
    std::string description; ///< file names
    std::string shader;
};

Result<PackedPlan> planPacked(const std::filesystem::path& path,
                              const Project& project,
                              const PackedExportOptions& options)
{
    const std::string ending = endingOf(path);
    if (ending != "exr" && ending != "tif" && ending != "tiff" && ending != "png") {
        return contentsError(path.string() + ": expected a name that ends in .exr, .tif or .png");
    }
    if (project.texels.faceCount() == 0) {
        return contentsError(path.string() + ": there is no face to export");
    }
    auto kind = pageKind(ending, project, options.image);
    if (!kind) {
        return prefixed(path.string(), kind.error());
    }
    auto layout = AtlasLayout::plan(levelsOf(project.texels), options.layout);
    if (!layout) {
        return prefixed(path.string(), layout.error());
    }
    const std::string stem = path.stem().string();
    std::vector<std::string> pages =
        pageNames(stem, path.extension().string().substr(1), layout->pages().size());
    PackedPlan plan{
        std::move(*layout), std::move(*kind), std::move(pages), stem + ".json", stem + ".glsl"};
    if (Status usable =
            checkPages(path.parent_path(), plan.pageFiles, plan.layout.pages(), plan.kind.format);
        !usable) {
        return tl::unexpected(usable.error());
    }
    return plan;
}

Status writePacked(const ImageWorker& worker,
                   StagedFiles& files,
                   const Project& project,
                   const PackedPlan& plan,
                   Threads threads,
                   Progress& progress)
{
    StageProgress converting(progress, 0, 0.1);
    const auto texels = converted(project.texels, plan.kind.format.type, threads, converting);
    if (!texels) {
        return tl::unexpected(texels.error());
    }
    StageProgress drawing(progress, 0.1, 0.3);
    const auto pages = packedPages(
        plan.layout, *texels, project.surface->adjacency(), plan.kind.colors, threads, drawing);
    if (!pages) {
        return tl::unexpected(pages.error());
    }
    std::vector<std::filesystem::path> paths;
    for (const std::string& name : plan.pageFiles) {
        paths.push_back(files.add(name));
    }
    ImageWriteOptions writing;
    writing.multipliesByAlpha = false; // texels to the bit
    writing.threads = threads;
    StageProgress pagesWritten(progress, 0.3, 1);
    if (Status written = writePages(worker, paths, *pages, writing, pagesWritten); !written) {
        return written;
    }
    if (Status written = writeText(files.add(plan.shader), atlasShader()); !written) {
        return written;
    }
    return writeText(
        files.add(plan.description),
        describeAtlas(
            plan.layout, project.texels.format(), plan.kind.colors, plan.pageFiles, plan.shader));
}

} // namespace

Result<AtlasEstimate> estimatePackedAtlas(const std::filesystem::path& path,
                                          const Project& project,
                                          const PackedExportOptions& options)
{
    const auto plan = planPacked(path, project, options);
    if (!plan) {
        return tl::unexpected(plan.error());
    }
    PackedExportOptions other = options;
    other.layout.packing =
        options.layout.packing == AtlasPacking::Bands ? AtlasPacking::Shelves : AtlasPacking::Bands;
    const auto otherPlan = planPacked(path, project, other);
    AtlasEstimate estimate{{plan->layout.pages().begin(), plan->layout.pages().end()},
                           plan->pageFiles,
                           plan->kind.format,
                           plan->layout.occupancy(),
                           otherPlan ? std::optional(otherPlan->layout.occupancy()) : std::nullopt};
    estimate.files.insert(estimate.files.end(), {plan->shader, plan->description});
    return estimate;
}

Status exportPackedAtlas(const ImageWorker& worker,
                         const std::filesystem::path& path,
                         const Project& project,
                         const PackedExportOptions& options,
                         Progress& progress)
{
    const auto plan = planPacked(path, project, options);
    if (!plan) {
        return tl::unexpected(plan.error());
    }
    auto files = StagedFiles::beside(path.parent_path());
    if (!files) {
        return tl::unexpected(files.error());
    }
    if (const Status written =
            writePacked(worker, *files, project, *plan, options.image.threads, progress);
        !written) {
        return tl::unexpected(files->told(written.error()));
    }
    if (!progress.report(1)) {
        return cancelled();
    }
    return files->commit();
}

} // namespace trixel
