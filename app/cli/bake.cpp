// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mapping/bake.h"

#include "app/cli/arguments.h"
#include "app/cli/bake_images.h"
#include "app/cli/bake_mapping.h"
#include "app/cli/file_kind.h"
#include "app/cli/paint_layer.h"
#include "app/cli/verb.h"
#include "core/io/channel_colors.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

namespace trixel::app {
namespace {

struct Arguments
{
    std::string project;
    std::string output;
    BakeImageArguments images;
    BakeMappingArguments mapping;
    std::optional<std::string> as;
    std::optional<std::string> threads;
};

/// What the project's channels are to mean: as said here, else as the project says, else nothing,
/// so that the image's numbers pass.
Result<std::vector<ColorSpace>> targetColors(const Arguments& arguments, Project& project)
{
    const TexelFormat& format = project.texels.format();
    if (!arguments.as) {
        return channelColors(project).value_or(std::vector<ColorSpace>());
    }
    const auto space = colorSpace("--as", *arguments.as);
    if (!space) {
        return tl::unexpected(space.error());
    }
    std::vector<ColorSpace> colors = uniformColors(*space, format.channels, format.alpha);
    declareChannelColors(project, colors);
    return colors;
}

Status bakeInto(Project& project, const Arguments& arguments, MappingKind kind, Progress& progress)
{
    const auto count = threads("--threads", arguments.threads);
    if (!count) {
        return tl::unexpected(count.error());
    }
    BakeOptions options;
    options.threads = *count;
    auto colors = targetColors(arguments, project);
    if (!colors) {
        return tl::unexpected(colors.error());
    }
    options.colors = std::move(*colors);
    // What costs little to refuse comes before the images.
    const auto mapping = makeMapping(kind, arguments.mapping, *project.surface);
    if (!mapping) { // of uvs the mesh is at fault, of the others an option
        return kind == MappingKind::Uv ? Status(prefixed(arguments.project, mapping.error()))
                                       : tl::unexpected(mapping.error());
    }
    StageProgress reading(progress, 0, 0.3);
    const auto images = readBakeImages(arguments.images, kind, *count, reading);
    if (!images) {
        return tl::unexpected(images.error());
    }
    if (kind == MappingKind::Uv) {
        const Status reach =
            checkUvs(project.surface->mesh(), images->tiles.tiles(), images->repeats);
        if (!reach) {
            return prefixed(arguments.project, reach.error());
        }
    }
    std::vector<FaceId> faces;
    for (std::uint32_t k = 0; k < project.texels.faceCount(); ++k) {
        faces.push_back(faceId(k));
    }
    StageProgress baking(progress, 0.3, 0.95);
    TexelStore painted = project.texels;
    const auto patch = bake(painted, faces, **mapping, images->tiles, options, baking);
    StageProgress taking(progress, 0.95, 1);
    const Status taken = patch ? takePaint(project, std::move(painted), "Image", taking)
                               : tl::unexpected(patch.error());
    return taken || taken.error().kind == ErrorKind::Cancelled
               ? taken
               : Status(prefixed(arguments.project, taken.error()));
}

Result<Outcome> bakeVerb(const Arguments& arguments, Progress& progress)
{
    if (const Status ending = expectEnding(arguments.output, FileKind::Project); !ending) {
        return tl::unexpected(ending.error());
    }
    const auto kind = mappingKind(arguments.mapping);
    if (!kind) {
        return tl::unexpected(kind.error());
    }
    StageProgress opening(progress, 0, 0.2);
    auto project = openPainted(arguments.project, opening);
    if (!project) {
        return tl::unexpected(project.error());
    }
    StageProgress baking(progress, 0.2, 0.8);
    if (const Status baked = bakeInto(*project, arguments, *kind, baking); !baked) {
        return tl::unexpected(baked.error());
    }
    StageProgress saving(progress, 0.8, 1);
    return saveProject(arguments.output, *project, saving).map([] { return Outcome::Done; });
}

} // namespace

void addBake(CLI::App& parser, Work& chosen)
{
    auto arguments = std::make_shared<Arguments>();
    CLI::App* verb = parser.add_subcommand("bake", "Bring a 2D image onto the faces");
    verb->add_option("PROJECT", arguments->project, "Project, or .ptx that carries its mesh")
        ->required()
        ->type_name("FILE");
    verb->add_option("-o,--output", arguments->output, "Project to write (.trixel)")
        ->required()
        ->type_name("FILE");
    addBakeImageOptions(*verb, arguments->images);
    addMappingOptions(*verb, arguments->mapping);
    verb->add_option("--as",
                     arguments->as,
                     "What the project's channels mean: srgb, linear or raw; by default what the "
                     "project says, else what the image's mean")
        ->type_name("SPACE");
    verb->add_option("--threads",
                     arguments->threads,
                     "Threads to use, all cores by default; the result is the same")
        ->type_name("N");
    verb->callback([arguments, &chosen] {
        chosen = [arguments](Progress& progress) { return bakeVerb(*arguments, progress); };
    });
}

} // namespace trixel::app
