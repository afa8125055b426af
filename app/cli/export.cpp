// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/arguments.h"
#include "app/cli/file_kind.h"
#include "app/cli/layer_argument.h"
#include "app/cli/output.h"
#include "app/cli/verb.h"
#include "core/io/export_project.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

namespace trixel::app {
namespace {

/// What the name of the output asks for.
enum class Target { Ptx, Packed, HandOff };

struct Arguments
{
    std::string project;
    std::string output;
    std::optional<std::string> type;
    std::optional<std::string> colors;
    std::optional<std::string> threads;
    std::optional<std::string> page;
    std::optional<std::string> packing;
    bool noBorder = false;
    bool mips = false;
    std::optional<std::string> samples;
    std::optional<std::string> padding;
    std::optional<std::string> image;
    bool powerOfTwo = false;
    std::optional<std::string> faces;
    std::optional<std::string> channels;
    std::optional<std::string> layer;
    bool estimate = false;
    bool json = false;
};

struct Options
{
    PackedExportOptions packed;
    HandOffExportOptions handOff;
};

Result<Target> targetOf(const std::string& output)
{
    std::string ending = std::filesystem::path(output).extension().string();
    std::ranges::transform(
        ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (ending == ".ptx") {
        return Target::Ptx;
    }
    for (const char* packed : {".exr", ".tif", ".tiff", ".png"}) {
        if (ending == packed) {
            return Target::Packed;
        }
    }
    for (const char* mesh : {".glb", ".obj", ".ply"}) {
        if (ending == mesh) {
            return Target::HandOff;
        }
    }
    return contentsError(output + ": expected .ptx, a packed atlas (.exr, .tif, .png) or a mesh "
                                  "with uvs (.glb, .obj, .ply)");
}

/// Fails on an option that means nothing for the target: it would be passed over in silence.
Status checkOptions(const Arguments& arguments, Target target)
{
    struct Use
    {
        const char* option;
        bool isGiven;
        bool packed;
        bool handOff;
    };
    const std::array uses = {
        Use{"--type", arguments.type.has_value(), true, true},
        Use{"--colors", arguments.colors.has_value(), true, true},
        Use{"--threads", arguments.threads.has_value(), true, true},
        Use{"--page", arguments.page.has_value(), true, true},
        Use{"--estimate", arguments.estimate, true, true},
        Use{"--packing", arguments.packing.has_value(), true, false},
        Use{"--no-border", arguments.noBorder, true, false},
        Use{"--mips", arguments.mips, true, false},
        Use{"--samples", arguments.samples.has_value(), false, true},
        Use{"--padding", arguments.padding.has_value(), false, true},
        Use{"--image", arguments.image.has_value(), false, true},
        Use{"--power-of-two", arguments.powerOfTwo, false, true},
    };
    for (const Use& use : uses) {
        const bool fits = target == Target::Packed    ? use.packed
                          : target == Target::HandOff ? use.handOff
                                                      : false;
        if (use.isGiven && !fits) {
            return contentsError(std::string(use.option) + ": means nothing for " +
                                 arguments.output);
        }
    }
    return {};
}

/// One for all channels, or one for each.
Result<std::vector<ColorSpace>> colorsOf(const std::string& text, const TexelFormat& format)
{
    const auto colors = colorSpacesFromText(text);
    if (!colors || (colors->size() != 1 && colors->size() != format.channels)) {
        return contentsError("--colors: expected raw, linear or srgb, for all channels or for "
                             "each of " +
                             std::to_string(format.channels) + ", found " + text);
    }
    return colors->size() == 1 ? uniformColors(colors->front(), format.channels, format.alpha)
                               : *colors;
}

/// A whole number, if the option is given.
Status take(const char* option,
            const std::optional<std::string>& text,
            std::int64_t low,
            std::int64_t high,
            std::uint32_t& value)
{
    if (!text) {
        return {};
    }
    const auto number = wholeNumber(option, *text, low, high);
    if (!number) {
        return tl::unexpected(number.error());
    }
    value = static_cast<std::uint32_t>(*number);
    return {};
}

/// One of several words, if the option is given: its place among them.
Result<std::optional<std::size_t>> choice(const char* option,
                                          const std::optional<std::string>& text,
                                          std::initializer_list<const char*> words)
{
    if (!text) {
        return std::nullopt;
    }
    std::string known;
    std::size_t number = 0;
    for (const char* word : words) {
        if (*text == word) {
            return number;
        }
        known += (number++ == 0 ? "" : number == words.size() ? " or " : ", ") + std::string(word);
    }
    return contentsError(std::string(option) + ": expected " + known + ", found " + *text);
}

/// All that does not need the project.
Result<Options> optionsOf(const Arguments& arguments)
{
    Options options;
    AtlasImageOptions image;
    const auto count = threads("--threads", arguments.threads);
    if (!count) {
        return tl::unexpected(count.error());
    }
    image.threads = *count;
    if (arguments.type) {
        const auto type = texelType("--type", *arguments.type);
        if (!type) {
            return tl::unexpected(type.error());
        }
        image.type = *type;
    }
    options.packed.image = options.handOff.image = image;
    const auto packing = choice("--packing", arguments.packing, {"bands", "shelves"});
    const auto ending = choice("--image", arguments.image, {"png", "tif", "exr"});
    if (!packing || !ending) {
        return tl::unexpected(packing ? ending.error() : packing.error());
    }
    if (*packing) {
        options.packed.layout.packing = static_cast<AtlasPacking>(**packing);
    }
    options.handOff.imageEnding = arguments.image.value_or("png");
    options.packed.layout.border = arguments.noBorder ? AtlasBorder::None : AtlasBorder::Bilinear;
    options.packed.layout.mips = arguments.mips;
    options.handOff.layout.powerOfTwo = arguments.powerOfTwo;
    constexpr std::int64_t kLargestPage = 65536;
    for (const Status& taken :
         {take("--page", arguments.page, 1, kLargestPage, options.packed.layout.largestPage),
          take("--page", arguments.page, 1, kLargestPage, options.handOff.layout.largestPage),
          take("--samples", arguments.samples, 1, 16, options.handOff.layout.samplesPerTexel),
          take("--padding", arguments.padding, 1, 64, options.handOff.layout.padding)}) {
        if (!taken) {
            return tl::unexpected(taken.error());
        }
    }
    return options;
}

void print(const AtlasEstimate& estimate, bool asJson)
{
    if (asJson) {
        nlohmann::json pages = nlohmann::json::array();
        for (const AtlasPage& page : estimate.pages) {
            pages.push_back({page.width, page.height});
        }
        nlohmann::json json = {{"pages", pages},
                               {"files", estimate.files},
                               {"type", nameOf(estimate.format.type)},
                               {"channels", estimate.format.channels},
                               {"bytes", estimate.bytes()},
                               {"occupancy", estimate.occupancy}};
        if (estimate.otherOccupancy) {
            json["otherOccupancy"] = *estimate.otherOccupancy;
        }
        printJson(json);
        return;
    }
    for (const AtlasPage& page : estimate.pages) {
        std::printf("%u × %u pixels\n", page.width, page.height);
    }
    std::printf("%s, %s before compression, %.1f %% of the pixels used\n",
                counted(estimate.pages.size(), "page").c_str(),
                byteSizeText(estimate.bytes()).c_str(),
                100 * estimate.occupancy);
    if (estimate.otherOccupancy) {
        std::printf("%.1f %% in the other packing\n", 100 * *estimate.otherOccupancy);
    }
}

/// "0,2" or "3-9,12": whole numbers and ranges of them, ascending, each once.
Result<std::vector<std::int64_t>> numbersOf(const char* option, const std::string& text)
{
    std::vector<std::int64_t> numbers;
    constexpr std::int64_t kMost = std::numeric_limits<std::uint32_t>::max() - 1;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string item = text.substr(begin, end - begin);
        const std::size_t dash = item.find('-');
        const auto first = wholeNumber(option, item.substr(0, dash), 0, kMost);
        const auto last = dash == std::string::npos
                              ? first
                              : wholeNumber(option, item.substr(dash + 1), 0, kMost);
        if (!first || !last) {
            return tl::unexpected(first ? last.error() : first.error());
        }
        constexpr std::int64_t kMostNumbers = std::int64_t{1} << 28U;
        if (*last < *first || *last - *first > kMostNumbers) {
            return contentsError(std::string(option) + ": expected numbers and ranges, as in " +
                                 "0-9,12, found " + item);
        }
        for (std::int64_t k = *first; k <= *last; ++k) {
            numbers.push_back(k);
        }
        begin = end + 1;
    }
    return numbers;
}

Result<ProjectPart> projectPart(const Arguments& arguments)
{
    ProjectPart part;
    if (arguments.faces) {
        auto faces = numbersOf("--faces", *arguments.faces);
        if (!faces) {
            return tl::unexpected(faces.error());
        }
        std::ranges::sort(*faces);
        const auto repeated = std::ranges::unique(*faces);
        faces->erase(repeated.begin(), repeated.end());
        for (const std::int64_t face : *faces) {
            part.faces.push_back(faceId(static_cast<std::size_t>(face)));
        }
    }
    if (arguments.channels) {
        const auto channels = numbersOf("--channels", *arguments.channels);
        if (!channels) {
            return tl::unexpected(channels.error());
        }
        if (channels->size() > TexelFormat::kMaxChannels) {
            return contentsError("--channels: expected at most 1,024 of them");
        }
        for (const std::int64_t channel : *channels) {
            part.channels.push_back(static_cast<std::uint16_t>(
                std::min<std::int64_t>(channel, std::numeric_limits<std::uint16_t>::max())));
        }
    }
    return part;
}

/// Says what will be written, and writes it unless only that was asked for.
template <class Export>
Result<Outcome>
sayAndWrite(const Result<Export>& plan, const Arguments& arguments, Progress& progress)
{
    if (!plan) {
        return tl::unexpected(plan.error());
    }
    print(plan->estimate(), arguments.json);
    if (arguments.estimate) {
        return Outcome::Done;
    }
    const auto written = plan->write(ImageWorker(), progress);
    if (!written) {
        return tl::unexpected(written.error());
    }
    if constexpr (requires { written->largestJump; }) {
        if (!arguments.json) {
            std::printf("largest jump across an edge: %.2f of 255\n", 255 * written->largestJump);
        }
    }
    return Outcome::Done;
}

Result<Outcome> exportAtlas(const Arguments& arguments,
                            const Project& project,
                            const ProjectPart& wanted,
                            Target target,
                            Options options,
                            Progress& progress)
{
    StageProgress parting(progress, 0, 0.1);
    const auto part = partOf(project, wanted, options.packed.image.threads, parting);
    if (!part) {
        return part.error().kind == ErrorKind::Contents ? prefixed(arguments.project, part.error())
                                                        : tl::unexpected(part.error());
    }
    if (arguments.colors) {
        const auto colors = colorsOf(*arguments.colors, part->texels.format());
        if (!colors) {
            return tl::unexpected(colors.error());
        }
        options.packed.image.colors = options.handOff.image.colors = *colors;
    }
    StageProgress writing(progress, 0.1, 1);
    return target == Target::Packed
               ? sayAndWrite(PackedExport::plan(arguments.output, *part, options.packed),
                             arguments,
                             writing)
               : sayAndWrite(HandOffExport::plan(arguments.output, *part, options.handOff),
                             arguments,
                             writing);
}

Result<Outcome> exportAs(const Arguments& arguments, Progress& progress)
{
    const auto target = targetOf(arguments.output);
    if (!target) {
        return tl::unexpected(target.error());
    }
    if (const Status usable = checkOptions(arguments, *target); !usable) {
        return tl::unexpected(usable.error());
    }
    const auto options = optionsOf(arguments);
    auto part = projectPart(arguments);
    if (!options || !part) {
        return tl::unexpected(options ? part.error() : options.error());
    }
    StageProgress opening(progress, 0, 0.2);
    const auto project = openPainted(arguments.project, opening);
    if (!project) {
        return tl::unexpected(project.error());
    }
    if (arguments.layer) {
        const auto layer = layerOf("--layer", *arguments.layer, project->layers);
        if (!layer) {
            return prefixed(arguments.project, layer.error());
        }
        part->layer = *layer;
    }
    StageProgress writing(progress, 0.2, 1);
    if (*target != Target::Ptx) {
        return exportAtlas(arguments, *project, *part, *target, *options, writing);
    }
    const ExportRequest request{arguments.output, PtxExportOptions(), *part};
    return exportProject(ImageWorker(), *project, request, writing).map([](const ExportOutcome&) {
        return Outcome::Done;
    });
}

void addAtlasOptions(CLI::App& verb, Arguments& arguments)
{
    verb.add_option(
            "--type", arguments.type, "Of the pixels; else as near to the texels' as can be")
        ->type_name("TYPE")
        ->group("Atlases");
    verb.add_option("--colors",
                    arguments.colors,
                    "raw, linear or srgb, for all channels or each; else srgb for integers, "
                    "linear for floats")
        ->type_name("C,C,...")
        ->group("Atlases");
    verb.add_option("--page", arguments.page, "Most pixels of a page along a side")
        ->type_name("N")
        ->group("Atlases");
    verb.add_option("--threads", arguments.threads, "How many; else all cores")
        ->type_name("N")
        ->group("Atlases");
    verb.add_flag("--estimate", arguments.estimate, "Say sizes and pages, write nothing")
        ->group("Atlases");
    verb.add_flag("--json", arguments.json, "Say them as JSON")->group("Atlases");
    verb.add_option("--packing", arguments.packing, "shelves (the default) or bands")
        ->type_name("NAME")
        ->group("Packed atlas");
    verb.add_flag("--no-border", arguments.noBorder, "Texels alone, for shaders that fetch")
        ->group("Packed atlas");
    verb.add_flag("--mips", arguments.mips, "Coarser levels of every face too")
        ->group("Packed atlas");
    verb.add_option("--samples", arguments.samples, "Along an edge for every texel; 2 unless given")
        ->type_name("N")
        ->group("Mesh with uvs");
    verb.add_option("--padding", arguments.padding, "Pixels about every face; 2 unless given")
        ->type_name("N")
        ->group("Mesh with uvs");
    verb.add_option("--image", arguments.image, "png, tif or exr, beside .obj and .ply")
        ->type_name("ENDING")
        ->group("Mesh with uvs");
    verb.add_flag("--power-of-two", arguments.powerOfTwo, "Pages of sides that are powers of two")
        ->group("Mesh with uvs");
}

} // namespace

void addExport(CLI::App& parser, Work& chosen)
{
    auto arguments = std::make_shared<Arguments>();
    CLI::App* verb = parser.add_subcommand(
        "export", "Write a project as .ptx, as a packed atlas, or as a mesh with uvs");
    verb->add_option("PROJECT", arguments->project, "Project, or .ptx that carries its mesh")
        ->required()
        ->type_name("FILE");
    verb->add_option("-o,--output",
                     arguments->output,
                     "File to write: .ptx; .exr, .tif or .png for a packed atlas with its JSON; "
                     ".glb, .obj or .ply for a mesh with uvs and textures")
        ->required()
        ->type_name("FILE");
    verb->add_option("--faces", arguments->faces, "Only these, as in 0-99,120; else all")
        ->type_name("N,N-N,...");
    verb->add_option("--channels", arguments->channels, "Only these, from 0; else all")
        ->type_name("N,N,...");
    addLayerOption(*verb, arguments->layer);
    addAtlasOptions(*verb, *arguments);
    verb->callback([arguments, &chosen] {
        chosen = [arguments](Progress& progress) { return exportAs(*arguments, progress); };
    });
}

} // namespace trixel::app
