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

struct PackedExport::Plan
{
    std::filesystem::path path;
    Project project;
    PackedExportOptions options;
    PackedPlan packed;
};

PackedExport::PackedExport(std::shared_ptr<const Plan> plan)
    : m_plan(std::move(plan))
{
}

Result<PackedExport> PackedExport::plan(const std::filesystem::path& path,
                                        const Project& project,
                                        const PackedExportOptions& options)
{
    return planPacked(path, project, options).map([&](PackedPlan packed) {
        return PackedExport(
            std::make_shared<const Plan>(Plan{path, project, options, std::move(packed)}));
    });
}

std::vector<std::string> PackedExport::files() const
{
    std::vector<std::string> files = m_plan->packed.pageFiles;
    files.insert(files.end(), {m_plan->packed.shader, m_plan->packed.description});
    return files;
}

AtlasEstimate PackedExport::estimate() const
{
    const AtlasLayout& layout = m_plan->packed.layout;
    PackedExportOptions other = m_plan->options;
    other.layout.packing =
        other.layout.packing == AtlasPacking::Bands ? AtlasPacking::Shelves : AtlasPacking::Bands;
    const auto otherPlan = planPacked(m_plan->path, m_plan->project, other);
    return {{layout.pages().begin(), layout.pages().end()},
            files(),
            m_plan->packed.kind.format,
            layout.occupancy(),
            otherPlan ? std::optional(otherPlan->layout.occupancy()) : std::nullopt};
}

Status PackedExport::write(const ImageWorker& worker, Progress& progress) const
{
    // First of all, so that what cannot be written to is noticed before the work.
    const std::filesystem::path folder = m_plan->path.parent_path();
    auto staged = StagedFiles::beside(folder);
    if (!staged) {
        return tl::unexpected(staged.error());
    }
    if (Status free = checkReplaceable(folder, files()); !free) {
        return free;
    }
    if (const Status written = writePacked(worker,
                                           *staged,
                                           m_plan->project,
                                           m_plan->packed,
                                           m_plan->options.image.threads,
                                           progress);
        !written) {
        return tl::unexpected(staged->told(written.error()));
    }
    if (!progress.report(1)) {
        return cancelled();
    }
    return staged->commit();
}

Result<AtlasEstimate> estimatePackedAtlas(const std::filesystem::path& path,
                                          const Project& project,
                                          const PackedExportOptions& options)
{
    return PackedExport::plan(path, project, options).map([](const PackedExport& plan) {
        return plan.estimate();
    });
}

Status exportPackedAtlas(const ImageWorker& worker,
                         const std::filesystem::path& path,
                         const Project& project,
                         const PackedExportOptions& options,
                         Progress& progress)
{
    return PackedExport::plan(path, project, options).and_then([&](const PackedExport& plan) {
        return plan.write(worker, progress);
    });
}

} // namespace trixel
