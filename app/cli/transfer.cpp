// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/arguments.h"
#include "app/cli/file_kind.h"
#include "app/cli/output.h"
#include "app/cli/paint_layer.h"
#include "app/cli/verb.h"
#include "core/io/channel_colors.h"
#include "core/resample/transfer_paint.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <optional>

namespace trixel::app {
namespace {

struct Arguments
{
    std::string from;
    std::string to;
    std::string output;
    std::string distance;
    std::string method = "probes-2";
    std::optional<std::string> threads;
};

Result<TransferOptions> optionsOf(const Arguments& arguments)
{
    TransferOptions options;
    const auto distance = positiveNumber("--distance", arguments.distance);
    if (!distance) {
        return tl::unexpected(distance.error());
    }
    options.maxDistance = static_cast<float>(*distance);
    auto method = parseMethod(arguments.method);
    if (!method) {
        return prefixed("--method", method.error());
    }
    options.method = std::move(*method);
    const auto count = threads("--threads", arguments.threads);
    if (!count) {
        return tl::unexpected(count.error());
    }
    options.threads = *count;
    return options;
}

Result<Outcome> transfer(const Arguments& arguments, Progress& progress)
{
    auto options = optionsOf(arguments);
    const Status ending = expectEnding(arguments.output, FileKind::Project);
    if (!options || !ending) {
        return tl::unexpected(options ? ending.error() : options.error());
    }
    StageProgress openingFrom(progress, 0, 0.15);
    const auto from = openPainted(arguments.from, openingFrom);
    if (!from) {
        return tl::unexpected(from.error());
    }
    StageProgress openingTo(progress, 0.15, 0.3);
    auto to = openPainted(arguments.to, openingTo);
    if (!to) {
        return tl::unexpected(to.error());
    }
    StageProgress preparing(progress, 0.3, 0.5);
    const TransferColors colors = transferColors(
        channelColors(*from), from->texels.format(), channelColors(*to), to->texels.format());
    options->colors = colors.texels;
    const auto paint =
        transferScene(*from->surface, from->texels, colors.paint, options->threads, preparing);
    if (!paint) {
        return prefixed(arguments.from, paint.error());
    }
    StageProgress transferring(progress, 0.5, 0.9);
    auto result =
        transferPaint(*from->surface, *paint, *to->surface, to->texels, *options, transferring);
    if (!result) {
        return tl::unexpected(result.error());
    }
    if (result->reached == 0) {
        return contentsError(arguments.to + ": no texel is within " + arguments.distance + " of " +
                             arguments.from);
    }
    std::printf("%s of %s took paint\n",
                grouped(result->reached).c_str(),
                counted(result->total, "texel").c_str());
    StageProgress taking(progress, 0.9, 0.92);
    if (const Status taken = takePaint(*to, std::move(result->texels), "Transferred paint", taking);
        !taken) {
        return prefixed(arguments.to, taken.error());
    }
    StageProgress saving(progress, 0.92, 1);
    return saveProject(arguments.output, *to, saving).map([] { return Outcome::Done; });
}

} // namespace

void addTransfer(CLI::App& parser, Work& chosen)
{
    auto arguments = std::make_shared<Arguments>();
    CLI::App* verb = parser.add_subcommand(
        "transfer", "Bring paint to another mesh: from the nearest point of the painted one");
    verb->add_option("FROM", arguments->from, "Painted project, or .ptx that carries its mesh")
        ->required()
        ->type_name("FILE");
    verb->add_option("TO", arguments->to, "Project whose texels take the paint")
        ->required()
        ->type_name("FILE");
    verb->add_option("-o,--output", arguments->output, "Project to write (.trixel)")
        ->required()
        ->type_name("FILE");
    verb->add_option("--distance",
                     arguments->distance,
                     "How far a texel looks for the painted surface, in units of the meshes")
        ->required()
        ->type_name("D");
    verb->add_option("--method", arguments->method, "What averages the paint under a texel")
        ->capture_default_str()
        ->type_name("NAME");
    verb->add_option("--threads", arguments->threads, "How many; else all cores")->type_name("N");
    verb->callback([arguments, &chosen] {
        chosen = [arguments](Progress& progress) { return transfer(*arguments, progress); };
    });
}

} // namespace trixel::app
