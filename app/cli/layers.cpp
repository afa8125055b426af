// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/arguments.h"
#include "app/cli/file_kind.h"
#include "app/cli/layer_argument.h"
#include "app/cli/verb.h"
#include "core/layers/compose.h"
#include "core/layers/layer_edits.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <optional>

namespace trixel::app {
namespace {

struct Arguments
{
    std::string project;
    std::string output;
    std::optional<std::string> add;
    std::optional<std::string> remove;
    std::optional<std::string> merge;
    std::optional<std::string> layer;
    std::optional<std::string> name;
    std::optional<std::string> opacity;
    std::optional<std::string> blend;
    std::optional<std::string> place;
    bool hide = false;
    bool show = false;
};

Result<float> opacityOf(const std::string& text)
{
    const auto number = channelValues("--opacity", text, 1);
    if (!number) {
        return tl::unexpected(number.error());
    }
    if (!(number->front() >= 0 && number->front() <= 1)) {
        return contentsError("--opacity: expected a number from 0 to 1, found " + text);
    }
    return number->front();
}

Result<LayerBlend> blendOf(const std::string& text)
{
    if (const auto blend = layerBlendFromName(text)) {
        return *blend;
    }
    std::string known;
    for (const LayerBlend blend : kLayerBlends) {
        known += (known.empty() ? "" : ", ") + std::string(nameOf(blend));
    }
    return contentsError("--blend: expected one of " + known + ", found " + text);
}

/// The settings with those that are given in their place.
Result<LayerSettings> changed(LayerSettings settings, const Arguments& arguments)
{
    settings.name = arguments.name.value_or(settings.name);
    settings.isVisible = arguments.show || (settings.isVisible && !arguments.hide);
    if (arguments.opacity) {
        const auto opacity = opacityOf(*arguments.opacity);
        if (!opacity) {
            return tl::unexpected(opacity.error());
        }
        settings.opacity = *opacity;
    }
    if (arguments.blend) {
        const auto blend = blendOf(*arguments.blend);
        if (!blend) {
            return tl::unexpected(blend.error());
        }
        settings.blend = *blend;
    }
    return settings;
}

/// One of the layers, not the base.
Result<LayerId> overlay(std::string_view option, const std::string& text, const LayerStack& layers)
{
    const auto layer = layerOf(option, text, layers);
    return layer && *layer == kBaseLayer
               ? contentsError(std::string(option) + ": expected a layer above the base, found " +
                               text)
               : layer;
}

Status place(LayerStack& layers, LayerId layer, const Arguments& arguments)
{
    if (!arguments.place) {
        return {};
    }
    const auto most = static_cast<std::int64_t>(layers.layers().size());
    const auto place = wholeNumber("--place", *arguments.place, 1, most);
    if (!place) {
        return tl::unexpected(place.error());
    }
    layers.move(layer, static_cast<std::size_t>(*place - 1));
    return {};
}

Status set(LayerStack& layers, LayerId layer, const Arguments& arguments)
{
    auto settings = changed(layers.settings(layer), arguments);
    if (!settings) {
        return tl::unexpected(settings.error());
    }
    layers.set(layer, std::move(*settings));
    return place(layers, layer, arguments);
}

Status add(LayerStack& layers, const Arguments& arguments)
{
    if (!layers.hasRoom()) {
        return contentsError("--add: " + std::to_string(layers.layers().size()) +
                             " layers are as many as texels of " +
                             std::to_string(layers.base().format().channels) +
                             " channels can have");
    }
    const LayerId layer = layers.insert(layers.layers().size(), {*arguments.add});
    return set(layers, layer, arguments);
}

/// \param layers  with a base
Result<LayerStack> edited(LayerStack layers, const Arguments& arguments, Progress& progress)
{
    if (arguments.add) {
        return add(layers, arguments).map([&] { return std::move(layers); });
    }
    if (arguments.remove) {
        return overlay("--remove", *arguments.remove, layers).map([&](LayerId layer) {
            layers.remove(layer);
            return std::move(layers);
        });
    }
    if (arguments.merge) {
        const auto layer = overlay("--merge", *arguments.merge, layers);
        if (!layer) {
            return tl::unexpected(layer.error());
        }
        if (!layers.settings(*layer).isVisible) {
            return contentsError("--merge: the layer is hidden");
        }
        const std::size_t place = *layers.indexOf(*layer);
        if (place > 0 && !layers.layers()[place - 1].settings.isVisible) {
            return contentsError("--merge: the layer below is hidden, the paint would be, too");
        }
        return mergedDown(std::move(layers), *layer, Threads::all(), progress);
    }
    return overlay("--layer", arguments.layer.value_or(""), layers)
        .and_then([&](LayerId layer) { return set(layers, layer, arguments); })
        .map([&] { return std::move(layers); });
}

Status checkArguments(const Arguments& arguments)
{
    const int edits = (arguments.add ? 1 : 0) + (arguments.remove ? 1 : 0) +
                      (arguments.merge ? 1 : 0) + (arguments.layer ? 1 : 0);
    if (edits != 1) {
        return contentsError("layers: expected one of --add, --layer, --remove and --merge");
    }
    const bool sets = arguments.name || arguments.opacity || arguments.blend || arguments.place ||
                      arguments.hide || arguments.show;
    if (sets && (arguments.remove || arguments.merge)) {
        return contentsError("layers: nothing is set of a layer that is removed or merged");
    }
    return expectEnding(arguments.output, FileKind::Project);
}

Result<Outcome> editLayers(const Arguments& arguments, Progress& progress)
{
    if (const Status usable = checkArguments(arguments); !usable) {
        return tl::unexpected(usable.error());
    }
    StageProgress opening(progress, 0, 0.3);
    auto project = openPainted(arguments.project, opening);
    if (!project) {
        return tl::unexpected(project.error());
    }
    LayerStack before =
        project->layers.isPlain() ? LayerStack(project->texels) : std::move(project->layers);
    StageProgress editing(progress, 0.3, 0.5);
    auto layers = edited(std::move(before), arguments, editing);
    if (!layers) {
        return layers.error().kind == ErrorKind::Contents
                   ? prefixed(arguments.project, layers.error())
                   : tl::unexpected(layers.error());
    }
    StageProgress composing(progress, 0.5, 0.6);
    auto layered = composed(std::move(*layers), Threads::all(), composing);
    if (!layered) {
        return tl::unexpected(layered.error());
    }
    project->texels = std::move(layered->shown);
    project->layers = std::move(layered->layers);
    StageProgress saving(progress, 0.6, 1);
    return saveProject(arguments.output, *project, saving).map([] { return Outcome::Done; });
}

} // namespace

void addLayers(CLI::App& parser, Work& chosen)
{
    auto arguments = std::make_shared<Arguments>();
    CLI::App* verb = parser.add_subcommand("layers", "Add, set, remove or merge layers");
    verb->add_option("PROJECT", arguments->project, "Project, or .ptx that carries its mesh")
        ->required()
        ->type_name("FILE");
    verb->add_option("-o,--output", arguments->output, "Project to write (.trixel)")
        ->required()
        ->type_name("FILE");
    verb->add_option("--add", arguments->add, "A layer of that name on top")->type_name("NAME");
    verb->add_option("--layer", arguments->layer, "The one to set")->type_name("LAYER");
    verb->add_option("--remove", arguments->remove, "One of them")->type_name("LAYER");
    verb->add_option("--merge", arguments->merge, "Into what lies right below it")
        ->type_name("LAYER");
    verb->add_option("--name", arguments->name, "Of the layer")->type_name("NAME");
    verb->add_option("--opacity", arguments->opacity, "From 0 to 1")->type_name("X");
    verb->add_option("--blend", arguments->blend, "normal, multiply, screen, ...")
        ->type_name("MODE");
    verb->add_option("--place", arguments->place, "From the bottom, 1 right above the base")
        ->type_name("N");
    CLI::Option* hide = verb->add_flag("--hide", arguments->hide, "Keep it, but do not show it");
    verb->add_flag("--show", arguments->show, "Show it again")->excludes(hide);
    verb->footer("LAYER is a name, or a number from the bottom. 'trixel info' lists them.");
    verb->callback([arguments, &chosen] {
        chosen = [arguments](Progress& progress) { return editLayers(*arguments, progress); };
    });
}

} // namespace trixel::app
