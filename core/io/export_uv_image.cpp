// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/export_uv_image.h"

#include "core/filter/filter_scene.h"
#include "core/image/image_levels.h"
#include "core/io/channel_colors.h"
#include "core/io/commit_file.h"
#include "core/io/image/write_image.h"
#include "core/io/staged_files.h"
#include "core/resample/uv_image.h"
#include "core/texture/opacity.h"

#include <memory>
#include <string>
#include <utility>

namespace trixel {

namespace {

namespace fs = std::filesystem;

bool isInteger(TexelType type)
{
    return type == TexelType::UInt8 || type == TexelType::UInt16;
}

/// A type that the kind of file can hold, nearest to that of the texels.
TexelType typeFor(const fs::path& path, TexelType texels)
{
    const std::string ending = path.extension().string();
    if (ending == ".png") {
        return isInteger(texels) ? texels : TexelType::UInt16;
    }
    if (ending == ".exr") {
        return isInteger(texels) ? TexelType::Half : texels;
    }
    return texels == TexelType::Half && ending != ".tx" ? TexelType::Float : texels;
}

std::vector<ColorSpace> imageColors(const Project& project, const UvExportOptions& options)
{
    const TexelFormat& format = project.texels.format();
    if (options.space) {
        return uniformColors(*options.space, format.channels, format.alpha);
    }
    return channelColors(project).value_or(
        uniformColors(isInteger(format.type) ? ColorSpace::SRgb : ColorSpace::Linear,
                      format.channels,
                      format.alpha));
}

fs::path fileOf(const fs::path& pattern, UdimTile tile)
{
    std::string name = pattern.filename().string();
    if (const std::size_t at = name.find(kUdimPlace); at != std::string::npos) {
        name.replace(at, kUdimPlace.size(), std::to_string(tile.number()));
    }
    return pattern.parent_path() / name;
}

Result<std::vector<UdimTile>> tilesFor(const fs::path& path, const TriangleMesh& mesh)
{
    auto tiles = uvTiles(mesh);
    if (!tiles) {
        return tl::unexpected(tiles.error());
    }
    const bool several = path.filename().string().find(kUdimPlace) != std::string::npos;
    if (!several && (tiles->size() > 1 || !(tiles->front() == UdimTile{}))) {
        return contentsError(
            path.string() + ": the mesh's uvs reach " + std::to_string(tiles->size()) +
            (tiles->size() == 1 ? " tile" : " tiles") + " up to " +
            std::to_string(tiles->back().number()) + ", expected <UDIM> in the name");
    }
    return tiles;
}

/// Draws the tiles of one project, one after the other, and writes them to where they are staged.
class TileWriter
{
public:
    TileWriter(const ImageWorker& worker,
               const FilterScene& scene,
               const Project& project,
               UvImageOptions options,
               bool levels)
        : m_worker(worker)
        , m_scene(scene)
        , m_project(project)
        , m_options(std::move(options))
        , m_levels(levels)
    {
    }

    Result<UvTileOutcome>
    write(UdimTile tile, const fs::path& file, const fs::path& staged, Progress& progress)
    {
        m_options.tile = tile;
        StageProgress drawing(progress, 0, 0.6);
        auto made = makeUvImage(
            m_scene, m_project.surface->mesh(), m_project.texels.format(), m_options, drawing);
        if (!made) {
            return tl::unexpected(made.error());
        }
        UvTileOutcome outcome{file,
                              made->insidePixels,
                              static_cast<std::uint64_t>(m_options.width) *
                                  static_cast<std::uint64_t>(m_options.height),
                              made->facesWithoutPixel};
        std::vector<Image> levels;
        if (m_levels) {
            levels = imageLevels(std::move(made->image), m_options.threads);
        } else {
            levels.push_back(std::move(made->image));
        }
        ImageWriteOptions options;
        options.threads = m_options.threads;
        StageProgress writing(progress, 0.6, 1);
        return writeImage(m_worker, staged, levels, options, writing).map([&] { return outcome; });
    }

private:
    const ImageWorker& m_worker;
    const FilterScene& m_scene;
    const Project& m_project;
    UvImageOptions m_options;
    bool m_levels;
};

/// The texels as light, weighed by their opacity: ready to be filtered.
Result<FilterScene> sceneOf(const Project& project,
                            const std::vector<ColorSpace>& imageColors,
                            Threads threads,
                            Progress& progress)
{
    StageProgress linear(progress, 0, 0.35);
    // Where the project does not say what its numbers mean, they are what the image's will be.
    const auto texels =
        linearStore(project.texels, channelColors(project).value_or(imageColors), threads, linear);
    if (!texels) {
        return tl::unexpected(texels.error());
    }
    StageProgress weighing(progress, 0.35, 0.5);
    const auto filterable = weighed(*texels, threads, weighing);
    if (!filterable) {
        return tl::unexpected(filterable.error());
    }
    StageProgress building(progress, 0.5, 1);
    return FilterScene::build(std::make_shared<const FilterSurface>(FilterSurface::fromMesh(
                                  project.surface->mesh(), project.surface->adjacency())),
                              *filterable,
                              threads,
                              building);
}

} // namespace

std::uint64_t UvExportPlan::bytes(const UvExportOptions& options) const
{
    const std::uint64_t base = pixels * format.texelBytes();
    return options.levels ? base + base / 3 : base;
}

Result<UvExportPlan>
planUvExport(const fs::path& path, const Project& project, const UvExportOptions& options)
{
    UvExportPlan plan;
    plan.format = project.texels.format();
    plan.format.type = options.type.value_or(typeFor(path, plan.format.type));
    plan.colors = imageColors(project, options);
    const Status holds =
        checkImageTarget(path, plan.format, options.width, options.height, options.levels);
    if (!holds) {
        return tl::unexpected(holds.error());
    }
    auto tiles = tilesFor(path, project.surface->mesh());
    if (!tiles) {
        return tl::unexpected(tiles.error());
    }
    plan.tiles = std::move(*tiles);
    for (const UdimTile& tile : plan.tiles) {
        plan.files.push_back(fileOf(path, tile));
    }
    plan.pixels = std::uint64_t{plan.tiles.size()} * static_cast<std::uint64_t>(options.width) *
                  static_cast<std::uint64_t>(options.height);
    return plan;
}

Result<std::vector<UvTileOutcome>> exportUvImages(const ImageWorker& worker,
                                                  const fs::path& path,
                                                  const Project& project,
                                                  const UvExportOptions& options,
                                                  Threads threads,
                                                  Progress& progress)
{
    const auto plan = planUvExport(path, project, options);
    if (!plan) {
        return tl::unexpected(plan.error());
    }
    for (const fs::path& file : plan->files) { // said before the work, and again after it
        if (const Status replaceable = checkReplaceable(file); !replaceable) {
            return tl::unexpected(replaceable.error());
        }
    }
    auto staged = StagedFiles::beside(path.parent_path());
    if (!staged) {
        return prefixed(path.string() + ": its folder cannot be written to", staged.error());
    }
    StageProgress preparing(progress, 0, 0.3);
    const auto scene = sceneOf(project, plan->colors, threads, preparing);
    if (!scene) {
        return tl::unexpected(scene.error());
    }
    UvImageOptions image;
    image.width = options.width;
    image.height = options.height;
    image.gutter = options.gutter;
    image.type = plan->format.type;
    image.colors = plan->colors;
    image.threads = threads;
    TileWriter writer(worker, *scene, project, image, options.levels);
    std::vector<UvTileOutcome> outcomes;
    for (std::size_t k = 0; k < plan->tiles.size(); ++k) {
        const auto part = [&](std::size_t done) {
            return 0.3 + 0.7 * static_cast<double>(done) / static_cast<double>(plan->tiles.size());
        };
        StageProgress stage(progress, part(k), part(k + 1));
        auto outcome = writer.write(
            plan->tiles[k], plan->files[k], staged->add(plan->files[k].filename().string()), stage);
        if (!outcome) {
            return tl::unexpected(staged->told(outcome.error()));
        }
        outcomes.push_back(std::move(*outcome));
    }
    if (const Status committed = staged->commit(); !committed) {
        return tl::unexpected(committed.error());
    }
    return outcomes;
}

} // namespace trixel
