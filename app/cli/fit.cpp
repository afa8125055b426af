// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/arguments.h"
#include "app/cli/file_kind.h"
#include "app/cli/output.h"
#include "app/cli/verb.h"
#include "core/base/read_file.h"
#include "core/layers/compose.h"
#include "core/layers/layer_edits.h"
#include "core/study/fit/scene_fit.h"
#include "core/texture/level_change.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

namespace trixel::app {
namespace {

struct Arguments
{
    std::string project;
    std::string cameras;
    std::string tolerance = "1/255";
    std::string unseen{nameOf(UnseenFaces::OneTexel)};
    std::string output;
    bool json = false;
    bool dryRun = false;
};

/// A number, or two with a slash between them.
Result<double> toleranceOf(const std::string& text)
{
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos) {
        return positiveNumber("--tolerance", text);
    }
    const auto above = positiveNumber("--tolerance", text.substr(0, slash));
    const auto below = positiveNumber("--tolerance", text.substr(slash + 1));
    if (!above || !below) {
        return above ? below : above;
    }
    return *above / *below;
}

Result<UnseenFaces> unseenNamed(std::string_view name)
{
    const auto found =
        std::ranges::find(kUnseenFaces, name, [](UnseenFaces unseen) { return nameOf(unseen); });
    if (found == kUnseenFaces.end()) {
        return contentsError("--unseen: expected one-texel or by-distance, found '" +
                             std::string(name) + "'.");
    }
    return *found;
}

Result<SceneViews> readCameras(const std::string& path)
{
    const auto text = readFile(path);
    if (!text) {
        return tl::unexpected(text.error());
    }
    auto views = parseCameras(*text);
    if (!views) {
        return prefixed(path, views.error());
    }
    return views;
}

std::string decimal(double number, int digits)
{
    std::array<char, 64> text{};
    const int length = std::snprintf(text.data(), text.size(), "%.*g", digits, number);
    return {text.data(), static_cast<std::size_t>(std::max(length, 0))};
}

nlohmann::json toJson(const SceneFit& fit, double tolerance, const std::string& unseen)
{
    const FitPlan& plan = fit.plan;
    nlohmann::json json = {{"texelsBefore", plan.cost.texelsBefore},
                           {"texelsAfter", plan.cost.texelsAfter},
                           {"bytesBefore", plan.cost.bytesBefore},
                           {"bytesAfter", plan.cost.bytesAfter},
                           {"facesChanged", plan.cost.changedFaces},
                           {"unseen", unseen},
                           {"facesUnseen", plan.unseenFaces},
                           {"texelsUnseenBefore", plan.unseenTexelsBefore},
                           {"texelsUnseenAfter", plan.unseenTexelsAfter},
                           {"tolerance", tolerance},
                           {"rms", plan.rms},
                           {"worstPart", plan.worstPart},
                           {"worstFace", plan.worstFace}};
    if (fit.method) {
        json["method"] = {{"name", toText(fit.method->method)},
                          {"nanoseconds", fit.method->nanoseconds},
                          {"rms", fit.method->rms}};
    }
    json["subdivision"] = nlohmann::json::array();
    for (const SubdivisionError& error : fit.subdivision) {
        json["subdivision"].push_back(
            {{"steps", error.steps}, {"faces", error.faces}, {"pixels", error.pixels}});
    }
    return json;
}

void print(const SceneFit& fit, double tolerance)
{
    const FitPlan& plan = fit.plan;
    const LevelCost& cost = plan.cost;
    const double times =
        static_cast<double>(cost.texelsBefore) / static_cast<double>(cost.texelsAfter);
    std::cout << "texels       " << grouped(cost.texelsBefore) << " -> "
              << grouped(cost.texelsAfter) << " (" << decimal(times, 3) << " times fewer)\n"
              << "memory       " << byteSizeText(cost.bytesBefore) << " -> "
              << byteSizeText(cost.bytesAfter) << "\n"
              << "faces        " << grouped(cost.changedFaces) << " change\n"
              << "unseen       " << grouped(plan.unseenFaces) << " faces, whose texels go "
              << grouped(plan.unseenTexelsBefore) << " -> " << grouped(plan.unseenTexelsAfter)
              << "\n"
              << "error        RMS " << decimal(plan.rms, 3) << " over the mesh, "
              << decimal(plan.worstPart, 3) << " in its worst part; the tolerance is "
              << decimal(tolerance, 3) << "\n";
    if (fit.method) {
        std::cout << "filter       " << toText(fit.method->method) << " is the fastest within "
                  << "the tolerance: " << decimal(fit.method->nanoseconds, 3) << " ns a pixel, RMS "
                  << decimal(fit.method->rms, 2) << "\n";
    }
    if (!fit.subdivision.empty()) {
        const SubdivisionError& last = fit.subdivision.back();
        std::cout << "subdivision  as a Loop cage, "
                  << (last.pixels <= kSubdivisionPixels ? "" : "more than ")
                  << counted(static_cast<std::uint64_t>(last.steps), "step") << " ("
                  << grouped(last.faces) << " faces, " << decimal(last.pixels, 2)
                  << " pixels off the limit surface)\n";
    }
}

Status checkOutput(const Arguments& arguments)
{
    if (arguments.output.empty()) {
        return arguments.dryRun ? Status() : contentsError("fit: expected -o FILE or --dry-run.");
    }
    return expectEnding(arguments.output, FileKind::Project);
}

/// The fitted texels, or, of a project with layers, all of these at the fitted levels.
Status takeLevels(Project& project, const TexelStore& fitted, Progress& progress)
{
    if (project.layers.isPlain()) {
        project.texels = fitted;
        return {};
    }
    StageProgress changing(progress, 0, 0.6);
    StageProgress composing(progress, 0.6, 1);
    return withLevels(std::move(project.layers),
                      project.surface->adjacency(),
                      levelsOf(fitted),
                      Threads::all(),
                      changing)
        .and_then([&](LayerStack&& layers) {
            return composed(std::move(layers), Threads::all(), composing);
        })
        .map([&](Layered&& layered) {
            project.texels = std::move(layered.shown);
            project.layers = std::move(layered.layers);
        });
}

Result<Outcome> runFit(const Arguments& arguments, Progress& progress)
{
    if (const Status output = checkOutput(arguments); !output) {
        return tl::unexpected(output.error());
    }
    const auto tolerance = toleranceOf(arguments.tolerance);
    if (!tolerance) {
        return tl::unexpected(tolerance.error());
    }
    const auto unseen = unseenNamed(arguments.unseen);
    if (!unseen) {
        return tl::unexpected(unseen.error());
    }
    const auto views = readCameras(arguments.cameras);
    if (!views) {
        return tl::unexpected(views.error());
    }
    StageProgress opening(progress, 0, 0.05);
    auto project = openPainted(arguments.project, opening);
    if (!project) {
        return tl::unexpected(project.error());
    }
    StageProgress fitting(progress, 0.05, 0.97);
    auto fitted = fitScene(
        *project->surface, project->texels, {*views, *tolerance, *unseen}, Threads::all(), fitting);
    if (!fitted) {
        return tl::unexpected(fitted.error());
    }
    if (!arguments.dryRun) {
        StageProgress taking(progress, 0.97, 0.98);
        if (const Status taken = takeLevels(*project, fitted->fitted, taking); !taken) {
            return tl::unexpected(taken.error());
        }
        StageProgress saving(progress, 0.98, 1);
        if (const Status saved = saveProject(arguments.output, *project, saving); !saved) {
            return tl::unexpected(saved.error());
        }
    }
    if (arguments.json) {
        printJson(toJson(*fitted, *tolerance, arguments.unseen));
    } else {
        print(*fitted, *tolerance);
    }
    return Outcome::Done;
}

} // namespace

void addFit(CLI::App& parser, Work& chosen)
{
    auto arguments = std::make_shared<Arguments>();
    CLI::App* verb =
        parser.add_subcommand("fit", "Lower the levels of faces as far as a scene's views allow");
    verb->add_option("PROJECT", arguments->project, "Project, or .ptx that carries its mesh")
        ->required()
        ->type_name("FILE");
    verb->add_option("--cameras", arguments->cameras, "Cameras file (JSON)")
        ->required()
        ->type_name("FILE");
    verb->add_option("--tolerance",
                     arguments->tolerance,
                     "RMS difference allowed in any picture that the cameras cover, in the unit of "
                     "the values (integers: 0 to 1); 1/255 by default")
        ->type_name("E");
    verb->add_option("--unseen",
                     arguments->unseen,
                     "Faces that no camera sees, outside every picture or hidden: one-texel (the "
                     "default) leaves them their mean, by-distance fits them as if each camera "
                     "turned to them and nothing stood in between")
        ->type_name("WHAT");
    verb->add_option("-o,--output", arguments->output, "Project to write (.trixel)")
        ->type_name("FILE");
    verb->add_flag("--dry-run", arguments->dryRun, "Tell what it would do, write nothing");
    verb->add_flag("--json", arguments->json, "Print one JSON object");
    verb->callback([arguments, &chosen] {
        chosen = [arguments](Progress& progress) { return runFit(*arguments, progress); };
    });
}

} // namespace trixel::app
