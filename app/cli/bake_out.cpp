// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/arguments.h"
#include "app/cli/bake_images.h"
#include "app/cli/file_kind.h"
#include "app/cli/layer_argument.h"
#include "app/cli/output.h"
#include "app/cli/verb.h"
#include "core/io/export_uv_image.h"
#include "core/io/project_part.h"
#include "core/resample/uv_image.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <optional>

namespace trixel::app {
namespace {

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
    std::optional<std::string> layer;
};

/// "2048" or "2048x1024".
Status readSize(const std::string& text, UvExportOptions& options)
{
    const std::size_t cross = text.find('x');
    const auto side = [](std::string_view part) {
        return wholeNumber("--size", part, 1, UvExportOptions::kMostPixels);
    };
    const auto width = side(std::string_view(text).substr(0, cross));
    const auto height =
        cross == std::string::npos ? width : side(std::string_view(text).substr(cross + 1));
    if (!width || !height) {
        return tl::unexpected(width ? height.error() : width.error());
    }
    options.width = static_cast<int>(*width);
    options.height = static_cast<int>(*height);
    return {};
}

Result<UvExportOptions> optionsOf(const Arguments& arguments)
{
    UvExportOptions options;
    options.levels = arguments.levels;
    if (const Status size = readSize(arguments.size, options); !size) {
        return tl::unexpected(size.error());
    }
    const auto gutter = wholeNumber("--gutter", arguments.gutter, 0, UvExportOptions::kMostGutter);
    if (!gutter) {
        return tl::unexpected(gutter.error());
    }
    options.gutter = static_cast<int>(*gutter);
    if (arguments.type) {
        const auto type = texelType("--type", *arguments.type);
        if (!type) {
            return tl::unexpected(type.error());
        }
        options.type = *type;
    }
    if (arguments.as) {
        const auto space = colorSpace("--as", *arguments.as);
        if (!space) {
            return tl::unexpected(space.error());
        }
        options.space = *space;
    }
    return options;
}

void print(const UvTileOutcome& tile)
{
    std::cout << tile.file.string() << ": " << tile.insidePixels << " of " << tile.pixels
              << " pixels lie on faces";
    if (tile.facesWithoutPixel > 0) {
        std::cout << "; " << counted(tile.facesWithoutPixel, "face") << " too small to hold one";
    }
    std::cout << '\n';
}

/// What is shown, or the layer that is asked for.
Result<Project>
partToBake(const Project& project, const Arguments& arguments, Threads threads, Progress& progress)
{
    ProjectPart part;
    if (arguments.layer) {
        const auto layer = layerOf("--layer", *arguments.layer, project.layers);
        if (!layer) {
            return prefixed(arguments.project, layer.error());
        }
        part.layer = *layer;
    }
    return partOf(project, part, threads, progress);
}

Result<Outcome> bakeOut(const Arguments& arguments, Progress& progress)
{
    const auto options = optionsOf(arguments);
    const auto count = threads("--threads", arguments.threads);
    if (!options || !count) {
        return tl::unexpected(options ? count.error() : options.error());
    }
    StageProgress opening(progress, 0, 0.1);
    const auto project = openPainted(arguments.project, opening);
    if (!project) {
        return tl::unexpected(project.error());
    }
    if (const auto usable = uvTiles(project->surface->mesh()); !usable) {
        return prefixed(arguments.project, usable.error());
    }
    StageProgress parting(progress, 0.1, 0.15);
    const auto part = partToBake(*project, arguments, *count, parting);
    if (!part) {
        return tl::unexpected(part.error());
    }
    StageProgress writing(progress, 0.15, 1);
    const auto tiles =
        exportUvImages(ImageWorker(), arguments.output, *part, *options, *count, writing);
    if (!tiles) {
        return tl::unexpected(tiles.error());
    }
    for (const UvTileOutcome& tile : *tiles) {
        print(tile);
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
    addLayerOption(*verb, arguments->layer);
    verb->add_option("--threads",
                     arguments->threads,
                     "Threads to use, all cores by default; the result is the same")
        ->type_name("N");
    verb->callback([arguments, &chosen] {
        chosen = [arguments](Progress& progress) { return bakeOut(*arguments, progress); };
    });
}

} // namespace trixel::app
