// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/atlas/handoff_pages.h"
#include "core/base/read_file.h"
#include "core/io/atlas/export_files.h"
#include "core/io/mesh/uv_mesh.h"
#include "core/texture/opacity.h"

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
                                     const HandOffPlan& plan,
                                     HandOffLayout& layout,
                                     const HandOffExportOptions& options,
                                     Progress& progress)
{
    StageProgress weighing(progress, 0, 0.1);
    const auto texels = weighed(project.texels, options.image.threads, weighing);
    if (!texels) {
        return tl::unexpected(texels.error());
    }
    StageProgress preparing(progress, 0.1, 0.2);
    const auto scene = FilterScene::build(plan.surface, *texels, options.image.threads, preparing);
    if (!scene) {
        return tl::unexpected(scene.error());
    }
    if (const Status whole = project.texels.checkWhole(); !whole) {
        return tl::unexpected(whole.error());
    }
    StageProgress drawing(progress, 0.2, 1);
    return handOffPages(layout,
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
                    const HandOffLayout& layout,
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
    const UvMesh uvMesh{
        project.surface->mesh(), uvsOf(layout), plan.pageFiles, plan.kind.format.alpha.has_value()};
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

struct HandOffExport::Plan
{
    std::filesystem::path path;
    Project project;
    HandOffExportOptions options;
    HandOffPlan handOff;
};

HandOffExport::HandOffExport(std::shared_ptr<const Plan> plan)
    : m_plan(std::move(plan))
{
}

Result<HandOffExport> HandOffExport::plan(const std::filesystem::path& path,
                                          const Project& project,
                                          const HandOffExportOptions& options)
{
    return planHandOff(path, project, options).map([&](HandOffPlan handOff) {
        return HandOffExport(
            std::make_shared<const Plan>(Plan{path, project, options, std::move(handOff)}));
    });
}

std::vector<std::string> HandOffExport::files() const
{
    std::vector<std::string> files;
    if (m_plan->handOff.mesh != MeshFile::Glb) {
        files = m_plan->handOff.pageFiles;
    }
    if (m_plan->handOff.mesh == MeshFile::Obj) {
        files.push_back(m_plan->path.stem().string() + ".mtl");
    }
    files.push_back(m_plan->path.filename().string());
    return files;
}

AtlasEstimate HandOffExport::estimate() const
{
    const HandOffLayout& layout = m_plan->handOff.layout;
    return {{layout.pages().begin(), layout.pages().end()},
            files(),
            m_plan->handOff.kind.format,
            layout.occupancy(),
            std::nullopt};
}

Result<HandOffOutcome> HandOffExport::write(const ImageWorker& worker, Progress& progress) const
{
    const HandOffPlan& plan = m_plan->handOff;
    const Threads threads = m_plan->options.image.threads;
    // First of all, so that what cannot be written to is noticed before the work.
    const std::filesystem::path folder = m_plan->path.parent_path();
    auto staged = StagedFiles::beside(folder);
    if (!staged) {
        return tl::unexpected(staged.error());
    }
    if (const Status free = checkReplaceable(folder, files()); !free) {
        return tl::unexpected(free.error());
    }
    HandOffLayout layout = plan.layout; // faces are turned in it
    StageProgress drawing(progress, 0, 0.6);
    const auto pages = drawPages(m_plan->project, plan, layout, m_plan->options, drawing);
    if (!pages) {
        return tl::unexpected(pages.error());
    }
    StageProgress writing(progress, 0.6, 0.95);
    const Status written = writeHandOff(
        worker, *staged, m_plan->path, m_plan->project, plan, layout, *pages, threads, writing);
    if (!written) {
        return tl::unexpected(staged->told(written.error()));
    }
    StageProgress measuring(progress, 0.95, 1);
    const auto report =
        measureHandOff(layout, *pages, m_plan->project.surface->adjacency(), 3, threads, measuring);
    if (!report) {
        return tl::unexpected(report.error());
    }
    if (!progress.report(1)) {
        return cancelled();
    }
    return staged->commit().map([&] { return HandOffOutcome{report->largestJump}; });
}

Result<AtlasEstimate> estimateHandOff(const std::filesystem::path& path,
                                      const Project& project,
                                      const HandOffExportOptions& options)
{
    return HandOffExport::plan(path, project, options).map([](const HandOffExport& plan) {
        return plan.estimate();
    });
}

Result<HandOffOutcome> exportHandOff(const ImageWorker& worker,
                                     const std::filesystem::path& path,
                                     const Project& project,
                                     const HandOffExportOptions& options,
                                     Progress& progress)
{
    return HandOffExport::plan(path, project, options).and_then([&](const HandOffExport& plan) {
        return plan.write(worker, progress);
    });
}

} // namespace trixel
