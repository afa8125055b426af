// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/arguments.h"
#include "app/cli/file_kind.h"
#include "app/cli/output.h"
#include "app/cli/verb.h"
#include "core/io/atlas/export_atlas.h"
#include "core/io/channel_colors.h"
#include "core/io/new_project.h"
#include "core/mesh/mesh_reader.h"

#include <CLI/CLI.hpp>
#include <limits>
#include <memory>
#include <optional>

namespace trixel::app {
namespace {

struct Arguments
{
    std::string mesh;
    std::string output;
    std::optional<std::string> level;
    std::optional<std::string> density;
    std::optional<std::string> texels;
    std::optional<std::string> atlas;
    std::string type = "uint8";
    std::string channels = "3";
    std::string fill = "0.8";
};

struct Texture
{
    TexelFormat format;
    std::vector<float> fill;
};

Result<Texture> textureOf(const Arguments& arguments)
{
    const auto type = texelType("--type", arguments.type);
    if (!type) {
        return tl::unexpected(type.error());
    }
    const auto channels =
        wholeNumber("--channels", arguments.channels, 1, TexelFormat::kMaxChannels);
    if (!channels) {
        return tl::unexpected(channels.error());
    }
    auto fill = channelValues("--fill", arguments.fill, static_cast<int>(*channels));
    if (!fill) {
        return tl::unexpected(fill.error());
    }
    return Texture{TexelFormat{*type, static_cast<std::uint16_t>(*channels), std::nullopt},
                   std::move(*fill)};
}

Result<LevelPlan> planOf(const Arguments& arguments, const TriangleMesh& mesh)
{
    if (arguments.density) {
        return positiveNumber("--density", *arguments.density).and_then([&](double density) {
            return planByDensity(mesh, density);
        });
    }
    if (arguments.texels) {
        return wholeNumber(
                   "--texels", *arguments.texels, 1, std::numeric_limits<std::int64_t>::max())
            .and_then([&](std::int64_t total) {
                return planByTotal(mesh, static_cast<std::uint64_t>(total));
            });
    }
    if (arguments.level) {
        return level("--level", *arguments.level).map([&](Level each) {
            return planUniform(mesh.faceCount(), each);
        });
    }
    return planByTotal(mesh, defaultTexelTotal(mesh.faceCount()));
}

/// Refuses arguments before the mesh is read, which may take long.
Status checkArguments(const Arguments& arguments)
{
    if (const Status ending = expectEnding(arguments.mesh, FileKind::Mesh); !ending) {
        return ending;
    }
    if (const Status ending = expectEnding(arguments.output, FileKind::Project); !ending) {
        return ending;
    }
    // No mesh has no faces: what remains to fail is the value itself.
    const auto plan = !arguments.texels ? planOf(arguments, {}) : Result<LevelPlan>{};
    if (!plan) {
        return tl::unexpected(plan.error());
    }
    return {};
}

Result<Project>
filled(const Arguments& arguments, TriangleMesh mesh, const Texture& texture, Progress& progress)
{
    const auto plan = planOf(arguments, mesh);
    return plan ? newProject(std::move(mesh), *plan, texture.format, texture.fill, progress)
                : tl::unexpected(plan.error());
}

/// Texels of a packed atlas, on the mesh that it was made of.
Result<Project> fromAtlas(const std::string& atlas, TriangleMesh mesh, Progress& progress)
{
    StageProgress reading(progress, 0, 0.7);
    auto read = readPackedAtlas(ImageWorker(), atlas, Threads::all(), reading);
    if (!read) {
        return tl::unexpected(read.error());
    }
    if (read->texels.faceCount() != mesh.faceCount()) {
        return contentsError(atlas + ": it has " + counted(read->texels.faceCount(), "face") +
                             ", the mesh " + grouped(mesh.faceCount()));
    }
    StageProgress building(progress, 0.7, 1);
    auto surface = Surface::build(std::move(mesh), building);
    if (!surface) {
        return tl::unexpected(surface.error());
    }
    Project project{std::move(*surface), std::move(read->texels), {}};
    const TexelFormat& format = project.texels.format();
    if (read->colors != usualColors(format)) {
        declareChannelColors(project, read->colors);
    }
    return project;
}

Result<Outcome> makeNew(const Arguments& arguments, Progress& progress)
{
    if (const Status usable = checkArguments(arguments); !usable) {
        return tl::unexpected(usable.error());
    }
    const auto texture = textureOf(arguments);
    if (!texture) {
        return tl::unexpected(texture.error());
    }
    StageProgress reading(progress, 0, 0.4);
    auto mesh = readMesh(arguments.mesh, reading);
    if (!mesh) {
        return tl::unexpected(mesh.error());
    }
    StageProgress building(progress, 0.4, 0.7);
    const auto project = arguments.atlas ? fromAtlas(*arguments.atlas, std::move(*mesh), building)
                                         : filled(arguments, std::move(*mesh), *texture, building);
    if (!project) {
        return tl::unexpected(project.error());
    }
    StageProgress saving(progress, 0.7, 1);
    return saveProject(arguments.output, *project, saving).map([] { return Outcome::Done; });
}

} // namespace

void addNew(CLI::App& parser, Work& chosen)
{
    auto arguments = std::make_shared<Arguments>();
    CLI::App* verb = parser.add_subcommand("new", "Make a project from a mesh");
    verb->add_option("MESH", arguments->mesh, "Mesh: .obj, .ply, .stl or .off")
        ->required()
        ->type_name("FILE");
    verb->add_option("-o,--output", arguments->output, "Project to write (.trixel)")
        ->required()
        ->type_name("FILE");
    verb->add_option("--type", arguments->type, "uint8, uint16, half or float")
        ->capture_default_str()
        ->type_name("TYPE");
    verb->add_option("--channels", arguments->channels, "Channels of a texel, 1 to 1024")
        ->capture_default_str()
        ->type_name("N");
    verb->add_option("--fill", arguments->fill, "Colour to start with: one value a channel, or one")
        ->capture_default_str()
        ->type_name("V,V,...");
    CLI::Option* level =
        verb->add_option("--level", arguments->level, "4^N texels for every face, N from 0 to 12")
            ->type_name("N");
    CLI::Option* density =
        verb->add_option("--density", arguments->density, "Texels along one world unit")
            ->type_name("N")
            ->excludes(level);
    verb->add_option("--texels",
                     arguments->texels,
                     "Texels in all, at most; the default, with N "
                     "about four million")
        ->type_name("N")
        ->excludes(level)
        ->excludes(density);
    CLI::Option* atlas =
        verb->add_option("--atlas",
                         arguments->atlas,
                         "Take levels, type and texels from a packed atlas (its .json)")
            ->type_name("FILE");
    for (const char* other :
         {"--level", "--density", "--texels", "--type", "--channels", "--fill"}) {
        atlas->excludes(verb->get_option(other));
    }
    verb->callback([arguments, &chosen] {
        chosen = [arguments](Progress& progress) { return makeNew(*arguments, progress); };
    });
}

} // namespace trixel::app
