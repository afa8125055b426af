// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/atlas/atlas_description.h"

#include "core/atlas/atlas_address.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>

namespace trixel {

namespace {

constexpr int kVersion = 1;
constexpr std::uint32_t kLargestPage = std::uint32_t{1} << 17U;

std::string_view nameOf(AtlasPacking packing)
{
    return packing == AtlasPacking::Bands ? "bands" : "shelves";
}

Json describeLevel(const AtlasLayout& layout, Level level)
{
    Json grids = Json::array();
    for (const AtlasGrid& grid : layout.grids(level)) {
        grids.push_back({{"first", grid.first},
                         {"count", grid.count},
                         {"perRow", grid.perRow},
                         {"page", grid.page},
                         {"x", grid.origin.x},
                         {"y", grid.origin.y}});
    }
    return {{"level", level.log2()},
            {"tile", layout.tile(level).side()},
            {"finerFaces", layout.finerFaces(level)},
            {"grids", grids}};
}

Json describeFaces(const AtlasLayout& layout)
{
    std::array<Json, 5> columns;
    columns.fill(Json::array());
    for (std::size_t f = 0; f < layout.faceCount(); ++f) {
        const Level level = layout.level(faceId(f));
        const AtlasPlace place = layout.place(faceId(f), level);
        columns[0].push_back(level.log2());
        columns[1].push_back(layout.rank(faceId(f)));
        columns[2].push_back(place.page);
        columns[3].push_back(place.origin.x);
        columns[4].push_back(place.origin.y);
    }
    return {{"level", columns[0]},
            {"rank", columns[1]},
            {"page", columns[2]},
            {"x", columns[3]},
            {"y", columns[4]}};
}

/// A whole number in [0, most].
Result<std::uint32_t> count(const JsonFields& fields, const char* name, std::uint32_t most)
{
    const auto field = fields.need(name);
    if (!field) {
        return tl::unexpected(field.error());
    }
    const Json& value = **field;
    if (!value.is_number_integer() || value.get<double>() < 0 || value.get<double>() > most) {
        return fields.error(name, "a whole number from 0 to " + std::to_string(most), value);
    }
    return value.get<std::uint32_t>();
}

Result<std::string> text(const JsonFields& fields, const char* name)
{
    const auto field = fields.need(name);
    if (!field) {
        return tl::unexpected(field.error());
    }
    if (!(*field)->is_string()) {
        return fields.error(name, "a text", **field);
    }
    return (*field)->get<std::string>();
}

Result<TexelFormat> parseFormat(const JsonFields& fields)
{
    const auto typeName = text(fields, "type");
    if (!typeName) {
        return tl::unexpected(typeName.error());
    }
    const auto type = texelTypeFromName(*typeName);
    if (!type) {
        return fields.error("type", "uint8, uint16, half or float", *typeName);
    }
    const auto channels = count(fields, "channels", TexelFormat::kMaxChannels);
    if (!channels || *channels == 0) {
        return channels ? fields.error("channels", "1 to 1024", *channels)
                        : tl::unexpected(channels.error());
    }
    TexelFormat format{*type, static_cast<std::uint16_t>(*channels), std::nullopt};
    if (const Json* alpha = fields.find("alpha"); alpha != nullptr && !alpha->is_null()) {
        const auto channel = count(fields, "alpha", *channels - 1);
        if (!channel) {
            return tl::unexpected(channel.error());
        }
        format.alpha = static_cast<std::uint16_t>(*channel);
    }
    return format;
}

Result<std::vector<ColorSpace>> parseColors(const JsonFields& fields, const TexelFormat& format)
{
    const auto list = fields.array("colors");
    if (!list) {
        return tl::unexpected(list.error());
    }
    std::vector<ColorSpace> colors;
    for (const Json& name : **list) {
        const auto color =
            name.is_string() ? colorSpaceFromName(name.get<std::string>()) : std::nullopt;
        if (!color) {
            return fields.error("colors", "raw, linear or srgb", name);
        }
        colors.push_back(*color);
    }
    if (colors.size() != format.channels) {
        return fields.error(
            "colors", "one for each of " + std::to_string(format.channels) + " channels", **list);
    }
    return colors;
}

Result<AtlasPageFile> parsePage(const Json& json, std::size_t number)
{
    const auto fields = JsonFields::of(json, "page " + std::to_string(number));
    if (!fields) {
        return tl::unexpected(fields.error());
    }
    auto file = text(*fields, "file");
    const auto width = count(*fields, "width", kLargestPage);
    const auto height = count(*fields, "height", kLargestPage);
    if (!file || !width || !height) {
        return tl::unexpected(!file ? file.error() : !width ? width.error() : height.error());
    }
    if (file->empty() || *file == "." || *file == ".." ||
        std::filesystem::path(*file).filename() != *file) {
        return fields->error("file", "the name of a file beside this one", *file);
    }
    return AtlasPageFile{std::move(*file), {*width, *height}};
}

/// One number of every face.
Result<std::vector<std::uint32_t>>
column(const JsonFields& fields, const char* name, std::uint32_t most)
{
    const auto list = fields.array(name);
    if (!list) {
        return tl::unexpected(list.error());
    }
    std::vector<std::uint32_t> numbers;
    numbers.reserve((*list)->size());
    for (const Json& value : **list) {
        if (!value.is_number_integer() || value.get<double>() < 0 || value.get<double>() > most) {
            return fields.error(name,
                                "whole numbers from 0 to " + std::to_string(most) + " (face " +
                                    std::to_string(numbers.size()) + ")",
                                value);
        }
        numbers.push_back(value.get<std::uint32_t>());
    }
    return numbers;
}

Result<FaceMap<PackedFace>>
parseFaces(const JsonFields& whole, AtlasBorder border, std::span<const AtlasPageFile> pages)
{
    const auto json = whole.need("faces");
    if (!json) {
        return tl::unexpected(json.error());
    }
    const auto fields = JsonFields::of(**json, "faces");
    if (!fields) {
        return tl::unexpected(fields.error());
    }
    if (pages.empty()) {
        return contentsError("pages: expected at least one");
    }
    const auto levels = column(*fields, "level", Level::kMax);
    const auto numbers = column(*fields, "page", static_cast<std::uint32_t>(pages.size() - 1));
    const auto x = column(*fields, "x", kLargestPage);
    const auto y = column(*fields, "y", kLargestPage);
    for (const auto* each : {&levels, &numbers, &x, &y}) {
        if (!*each) {
            return tl::unexpected(each->error());
        }
        if ((*each)->size() != levels->size()) {
            return contentsError("faces: level, page, x and y are not as many");
        }
    }
    std::uint64_t pixels = 0;
    for (const AtlasPageFile& page : pages) {
        pixels += std::uint64_t{page.size.width} * page.size.height;
    }
    FaceMap<PackedFace> faces(levels->size());
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const Level level(static_cast<int>((*levels)[f]));
        const AtlasPage& page = pages[(*numbers)[f]].size;
        const std::uint32_t side = AtlasTile(level, border).side();
        if ((*x)[f] + side > page.width || (*y)[f] + side > page.height) {
            return contentsError("faces: the tile of face " + std::to_string(f) +
                                 " does not lie on its page");
        }
        // Tiles of an atlas do not overlap; ones that did could stand for any number of texels.
        if (const std::uint64_t area = std::uint64_t{side} * side; area <= pixels) {
            pixels -= area;
        } else {
            return contentsError("faces: the tiles up to that of face " + std::to_string(f) +
                                 " take more pixels than the pages have");
        }
        faces[faceId(f)] = {level, {(*numbers)[f], {(*x)[f], (*y)[f]}}};
    }
    return faces;
}

} // namespace

std::string describeAtlas(const AtlasLayout& layout,
                          const TexelFormat& format,
                          const std::vector<ColorSpace>& colors,
                          const std::vector<std::string>& pages,
                          const std::string& shader)
{
    check(pages.size() == layout.pages().size() && colors.size() == format.channels,
          "a file for each page and a space for each channel");
    Json pageList = Json::array();
    for (std::size_t k = 0; k < pages.size(); ++k) {
        pageList.push_back({{"file", pages[k]},
                            {"width", layout.pages()[k].width},
                            {"height", layout.pages()[k].height}});
    }
    Json levels = Json::array();
    for (int n = 0; n <= layout.finest().log2(); ++n) {
        levels.push_back(describeLevel(layout, Level(n)));
    }
    Json spaces = Json::array();
    for (const ColorSpace color : colors) {
        spaces.push_back(nameOf(color));
    }
    const AtlasOptions& options = layout.options();
    const Json json = {{"version", kVersion},
                       {"kind", "packed"},
                       {"border", options.border == AtlasBorder::None ? 0 : 1},
                       {"mips", options.mips},
                       {"packing", nameOf(options.packing)},
                       {"type", nameOf(format.type)},
                       {"channels", format.channels},
                       {"alpha", format.alpha ? Json(*format.alpha) : Json()},
                       {"colors", spaces},
                       {"pages", pageList},
                       {"levels", levels},
                       {"faces", describeFaces(layout)},
                       {"table", atlasTable(layout)},
                       {"shader", shader}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<AtlasDescription> parseAtlasDescription(std::string_view text)
{
    const auto json = parseJson(text);
    if (!json) {
        return tl::unexpected(json.error());
    }
    const auto fields = JsonFields::of(*json, "atlas");
    if (!fields) {
        return tl::unexpected(fields.error());
    }
    if (Status known =
            firstError({fields->mustBe("version", kVersion), fields->mustBe("kind", "packed")});
        !known) {
        return tl::unexpected(known.error());
    }
    const auto border = count(*fields, "border", 1);
    const auto format = parseFormat(*fields);
    const auto pages = fields->array("pages");
    if (!border || !format || !pages) {
        return tl::unexpected(!border ? border.error() : !format ? format.error() : pages.error());
    }
    AtlasDescription atlas;
    atlas.border = *border == 0 ? AtlasBorder::None : AtlasBorder::Bilinear;
    atlas.format = *format;
    auto colors = parseColors(*fields, *format);
    if (!colors) {
        return tl::unexpected(colors.error());
    }
    atlas.colors = std::move(*colors);
    std::set<std::string> names;
    for (const Json& page : **pages) {
        auto parsed = parsePage(page, atlas.pages.size());
        if (!parsed) {
            return tl::unexpected(parsed.error());
        }
        if (!names.insert(parsed->file).second) {
            return contentsError("pages: two of them are '" + parsed->file + "'");
        }
        atlas.pages.push_back(std::move(*parsed));
    }
    auto faces = parseFaces(*fields, atlas.border, atlas.pages);
    if (!faces) {
        return tl::unexpected(faces.error());
    }
    atlas.faces = std::move(*faces);
    return atlas;
}

} // namespace trixel
