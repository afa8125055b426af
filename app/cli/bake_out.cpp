// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/arguments.h"
#include "app/cli/bake_images.h"
#include "app/cli/file_kind.h"
#include "app/cli/output.h"
#include "app/cli/verb.h"
#include "core/image/image_levels.h"
#include "core/io/channel_colors.h"
#include "core/io/image/write_image.h"
#include "core/resample/uv_image.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

namespace trixel::app {
namespace {

namespace fs = std::filesystem;

struct Arguments
{
    std::string project;
    std::string output;
    std::string size = "2048";
    std::string gutter = "16";
    std::optional<std::string> type;
    std::optional<std::string> as;
    bool levels = false;
    std::optional<std::string> threads;
};

constexpr std::string_view kUdim = "<UDIM>";
constexpr int kMostPixels = 65536;
constexpr int kMostGutter = 256;

struct Target
{
    UvImageOptions options;
    TexelFormat format; ///< of the image
};

/// "2048" or "2048x1024".
Status readSize(const std::string& text, UvImageOptions& options)
{
    const std::size_t cross = text.find('x');
    const auto width =
        wholeNumber("--size", std::string_view(text).substr(0, cross), 1, kMostPixels);
    const auto height =
        cross == std::string::npos
            ? width
            : wholeNumber("--size", std::string_view(text).substr(cross + 1), 1, kMostPixels);
    if (!width || !height) {
        return tl::unexpected(width ? height.error() : width.error());
    }
    options.width = static_cast<int>(*width);
    options.height = static_cast<int>(*height);
    return {};
}

/// A type that the kind of file can hold, nearest to that of the texels.
TexelType typeFor(const fs::path& output, TexelType texels)
{
    const std::string ending = output.extension().string();
    const bool integers = texels == TexelType::UInt8 || texels == TexelType::UInt16;
    if (ending == ".png") {
        return integers ? texels : TexelType::UInt16;
    }
    if (ending == ".exr") {
        return integers ? TexelType::Half : texels;
    }
    return texels == TexelType::Half && ending != ".tx" ? TexelType::Float : texels;
}

/// What the image's channels mean: as said here; else as the project says; else what files of their
/// type are taken for.
Result<std::vector<ColorSpace>> imageColors(const Arguments& arguments, const Project& project)
{
    const TexelFormat& format = project.texels.format();
    if (arguments.as) {
        return colorSpace("--as", *arguments.as).map([&](ColorSpace space) {
            return uniformColors(space, format.channels, format.alpha);
        });
    }
    const bool integers = format.type == TexelType::UInt8 || format.type == TexelType::UInt16;
    return channelColors(project).value_or(uniformColors(
        integers ? ColorSpace::SRgb : ColorSpace::Linear, format.channels, format.alpha));
}

Result<Target> targetOf(const Arguments& arguments, const Project& project)
{
    Target target;
    if (const Status size = readSize(arguments.size, target.options); !size) {
        return tl::unexpected(size.error());
    }
    const auto gutter = wholeNumber("--gutter", arguments.gutter, 0, kMostGutter);
    const auto count = threads("--threads", arguments.threads);
    const auto type = arguments.type ? texelType("--type", *arguments.type)
                                     : typeFor(arguments.output, project.texels.format().type);
    auto colors = imageColors(arguments, project);
    if (!gutter || !count || !type || !colors) {
        return tl::unexpected(!gutter  ? gutter.error()
                              : !count ? count.error()
                              : !type  ? type.error()
                                       : colors.error());
    }
    target.options.gutter = static_cast<int>(*gutter);
    target.options.threads = *count;
    target.options.type = *type;
    target.options.colors = std::move(*colors);
    target.format = project.texels.format();
    target.format.type = *type;
    const Status holds = checkImageTarget(arguments.output,
                                          target.format,
                                          target.options.width,
                                          target.options.height,
                                          arguments.levels);
    return holds ? Result<Target>(std::move(target)) : tl::unexpected(holds.error());
}

Result<std::vector<UdimTile>> tilesFor(const Arguments& arguments, const TriangleMesh& mesh)
{
    auto tiles = uvTiles(mesh);
    if (!tiles) {
        return prefixed(arguments.project, tiles.error());
    }
    const bool several = arguments.output.find(kUdim) != std::string::npos;
    if (!several && (tiles->size() > 1 || !(tiles->front() == UdimTile{}))) {
        return contentsError(
            arguments.output + ": the mesh's uvs reach " + counted(tiles->size(), "tile") +
            " up to " + std::to_string(tiles->back().number()) + ", expected <UDIM> in the name");
    }
    return tiles;
}

std::string nameOf(const std::string& pattern, UdimTile tile)
{
    const std::size_t at = pattern.find(kUdim);
    return at == std::string::npos ? pattern
                                   : pattern.substr(0, at) + std::to_string(tile.number()) +
                                         pattern.substr(at + kUdim.size());
}

/// What the texels mean, so that they are filtered as light. Where the project does not say, their
/// numbers are taken for what the image's will be.
std::vector<ColorSpace> texelColors(const Project& project, const UvImageOptions& options)
{
    return channelColors(project).value_or(options.colors);
}

Status writeTile(const FilterScene& scene,
                 const Project& project,
                 Target target,
                 UdimTile tile,
                 const Arguments& arguments,
                 Progress& progress)
{
    target.options.tile = tile;
    StageProgress drawing(progress, 0, 0.6);
    auto made = makeUvImage(
        scene, project.surface->mesh(), project.texels.format(), target.options, drawing);
    if (!made) {
        return tl::unexpected(made.error());
    }
    std::vector<Image> levels;
    if (arguments.levels) {
        levels = imageLevels(std::move(made->image), target.options.threads);
    } else {
        levels.push_back(std::move(made->image));
    }
    ImageWriteOptions options;
    options.threads = target.options.threads;
    StageProgress writing(progress, 0.6, 1);
    const std::string name = nameOf(arguments.output, tile);
    return writeImage(ImageWorker(), name, levels, options, writing).map([&] {
        std::cout << name << ": " << made->insidePixels << " of "
                  << std::uint64_t(target.options.width) *
                         static_cast<std::uint64_t>(target.options.height)
                  << " pixels lie on faces";
        if (made->facesWithoutPixel > 0) {
            std::cout << "; " << counted(made->facesWithoutPixel, "face")
                      << " too small to hold one";
        }
        std::cout << '\n';
    });
}

Result<Outcome> bakeOut(const Arguments& arguments, Progress& progress)
{
    StageProgress opening(progress, 0, 0.1);
    const auto project = openPainted(arguments.project, opening);
    if (!project) {
        return tl::unexpected(project.error());
    }
    const auto target = targetOf(arguments, *project);
    if (!target) {
        return tl::unexpected(target.error());
    }
    const auto tiles = tilesFor(arguments, project->surface->mesh());
    if (!tiles) {
        return tl::unexpected(tiles.error());
    }
    StageProgress linear(progress, 0.1, 0.2);
    const Threads count = target->options.threads;
    const auto texels =
        linearStore(project->texels, texelColors(*project, target->options), count, linear);
    if (!texels) {
        return tl::unexpected(texels.error());
    }
    const auto surface = std::make_shared<const FilterSurface>(
        FilterSurface::fromMesh(project->surface->mesh(), project->surface->adjacency()));
    StageProgress building(progress, 0.2, 0.4);
    const auto scene = FilterScene::build(surface, *texels, count, building);
    if (!scene) {
        return tl::unexpected(scene.error());
    }
    for (std::size_t k = 0; k < tiles->size(); ++k) {
        const auto part = [&](std::size_t n) {
            return 0.4 + 0.6 * static_cast<double>(n) / static_cast<double>(tiles->size());
        };
        StageProgress stage(progress, part(k), part(k + 1));
        const Status written = writeTile(*scene, *project, *target, (*tiles)[k], arguments, stage);
        if (!written) {
            return tl::unexpected(written.error());
        }
    }
    return Outcome::Done;
}

} // namespace

void addBakeOut(CLI::App& parser, Work& chosen)
{
    auto arguments = std::make_shared<Arguments>();
    CLI::App* verb =
        parser.add_subcommand("bake-out", "Write what is painted as an image by the mesh's uvs");
    verb->add_option("PROJECT", arguments->project, "Project, or .ptx that carries its mesh")
        ->required()
        ->type_name("FILE");
    verb->add_option("-o,--output",
                     arguments->output,
                     "Image to write (.png, .tif, .exr or .tx); <UDIM> in its name stands for the "
                     "number of each tile")
        ->required()
        ->type_name("FILE");
    verb->add_option("--size", arguments->size, "Pixels: one side of a square, or WIDTHxHEIGHT")
        ->capture_default_str()
        ->type_name("N");
    verb->add_option("--gutter",
                     arguments->gutter,
                     "Pixels beyond each chart that take what lies there on the surface")
        ->capture_default_str()
        ->type_name("N");
    verb->add_option("--type", arguments->type, "uint8, uint16, half or float")->type_name("TYPE");
    verb->add_option("--as",
                     arguments->as,
                     "What the image's channels are to mean: srgb, linear or raw; by default what "
                     "the project says, else srgb for integers")
        ->type_name("SPACE");
    verb->add_flag(
        "--levels", arguments->levels, "With all its halves, as renderers want textures");
    verb->add_option("--threads",
                     arguments->threads,
                     "Threads to use, all cores by default; the result is the same")
        ->type_name("N");
    verb->callback([arguments, &chosen] {
        chosen = [arguments](Progress& progress) { return bakeOut(*arguments, progress); };
    });
}

} // namespace trixel::app
