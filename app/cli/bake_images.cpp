// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/bake_images.h"

#include "core/io/image/read_image.h"
#include "core/io/image/tile_files.h"

#include <CLI/CLI.hpp>
#include <vector>

namespace trixel::app {
namespace {

template <class Value>
struct Named
{
    std::string_view name;
    Value value;
};

template <class Value, std::size_t N>
Result<Value>
oneOf(std::string_view option, std::string_view text, const Named<Value> (&choices)[N])
{
    std::string names;
    for (const Named<Value>& choice : choices) {
        if (choice.name == text) {
            return choice.value;
        }
        names += (names.empty() ? "" : ", ") + std::string(choice.name);
    }
    return contentsError(std::string(option) + ": expected one of " + names + ", found '" +
                         std::string(text) + "'");
}

constexpr Named<ImageLookup> kLookups[] = {{"nearest", ImageLookup::Nearest},
                                           {"bilinear", ImageLookup::Bilinear},
                                           {"mip", ImageLookup::Mip},
                                           {"footprint", ImageLookup::Footprint}};
constexpr Named<TableIndex> kIndices[] = {{"centres", TableIndex::Centres},
                                          {"corners", TableIndex::Corners}};
constexpr Named<ColorSpace> kColors[] = {
    {"srgb", ColorSpace::SRgb}, {"linear", ColorSpace::Linear}, {"raw", ColorSpace::Raw}};

Result<SamplerOptions> samplerOptions(const BakeImageArguments& arguments, MappingKind mapping)
{
    const auto lookup = oneOf("--lookup", arguments.lookup, kLookups);
    const auto index = oneOf("--index", arguments.index, kIndices);
    if (!lookup || !index) {
        return tl::unexpected(lookup ? index.error() : lookup.error());
    }
    SamplerOptions options;
    options.lookup = *lookup;
    options.index = *index;
    // Round a sphere the image goes on by itself.
    options.wrapS =
        arguments.repeats || mapping == MappingKind::Sphere ? ImageWrap::Repeat : ImageWrap::Clamp;
    options.wrapT = arguments.repeats ? ImageWrap::Repeat : ImageWrap::Clamp;
    return options;
}

} // namespace

Result<ColorSpace> colorSpace(std::string_view option, std::string_view text)
{
    return oneOf(option, text, kColors);
}

void addBakeImageOptions(CLI::App& verb, BakeImageArguments& arguments)
{
    verb.add_option("--image",
                    arguments.image,
                    "Image: PNG, JPEG, TIFF, OpenEXR, HDR, TGA, BMP or WebP; <UDIM> in its name "
                    "stands for the tiles' numbers")
        ->required()
        ->type_name("FILE");
    verb.add_option("--lookup",
                    arguments.lookup,
                    "How the image is looked up: nearest, bilinear, mip, or footprint, the "
                    "average over each texel's own area")
        ->capture_default_str()
        ->type_name("WAY");
    verb.add_option("--index",
                    arguments.index,
                    "Whether the image's area ends at the border of its corner pixels (centres) or "
                    "at their middles (corners)")
        ->capture_default_str()
        ->type_name("WAY");
    verb.add_option("--color",
                    arguments.color,
                    "What the image's channels mean: srgb, linear or raw; by default what its file "
                    "says")
        ->type_name("SPACE");
    verb.add_flag("--repeat", arguments.repeats, "The image goes on beyond its borders");
}

Result<BakeImages> readBakeImages(const BakeImageArguments& arguments,
                                  MappingKind mapping,
                                  Threads threads,
                                  Progress& progress)
{
    const auto options = samplerOptions(arguments, mapping);
    const auto color = arguments.color
                           ? colorSpace("--color", *arguments.color).map([](ColorSpace space) {
                                 return std::optional(space);
                             })
                           : Result<std::optional<ColorSpace>>(std::nullopt);
    if (!options || !color) {
        return tl::unexpected(options ? color.error() : options.error());
    }
    const auto files = tileFiles(arguments.image);
    if (!files) {
        return tl::unexpected(files.error());
    }
    const ImageWorker worker;
    std::vector<TileImage> images;
    for (std::size_t k = 0; k < files->size(); ++k) {
        const auto part = [&](std::size_t n) {
            return 0.7 * static_cast<double>(n) / static_cast<double>(files->size());
        };
        StageProgress stage(progress, part(k), part(k + 1));
        auto image = readImage(worker, (*files)[k].path, stage);
        if (!image) {
            return tl::unexpected(image.error());
        }
        if (*color) {
            const TexelFormat& format = image->format();
            *image = image->declared(uniformColors(**color, format.channels, format.alpha));
        }
        images.push_back({(*files)[k].tile, std::move(*image), (*files)[k].path.string()});
    }
    StageProgress levels(progress, 0.7, 1);
    return ImageTiles::make(std::move(images), *options, threads, levels)
        .map([&](ImageTiles tiles) {
            return BakeImages{std::move(tiles), arguments.repeats};
        });
}

} // namespace trixel::app
