// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/texel_report.h"

#include "core/base/check.h"
#include "core/texture/reduced_texel.h"
#include "core/texture/texel_address.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <utility>

namespace trixel {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kChannelsInText = 8;

bool isWhole(TexelType type)
{
    return type == TexelType::UInt8 || type == TexelType::UInt16;
}

/// The largest stored number of an integer type.
double top(TexelType type)
{
    return type == TexelType::UInt8 ? 255.0 : 65535.0;
}

/// Independent of the locale.
std::string written(double value, std::chars_format format, int digits)
{
    std::array<char, 64> room{};
    const auto [end, problem] =
        std::to_chars(room.data(), room.data() + room.size(), value, format, digits);
    check(problem == std::errc(), "room for the digits of a number");
    return {room.data(), end};
}

std::string general(double value, int digits)
{
    return written(value, std::chars_format::general, digits);
}

std::string storedNumber(TexelType type, float value)
{
    return isWhole(type) ? std::to_string(std::lround(double{value} * top(type)))
                         : general(double{value}, 7);
}

/// The first few, two spaces between them.
template <class Write>
std::string listed(std::span<const float> values, const Write& write)
{
    std::string text;
    for (const float value : values.first(std::min(values.size(), kChannelsInText))) {
        text += text.empty() ? "" : "  ";
        text += write(value);
    }
    if (values.size() > kChannelsInText) {
        text += "  … (" + std::to_string(values.size()) + " channels)";
    }
    return text;
}

/// As many digits as a screen can tell apart.
std::string shownNumber(float value)
{
    return general(double{value}, 4);
}

/// The number with nine digits, which is as many as a float takes to be read back.
Json jsonNumber(double value)
{
    if (!std::isfinite(value)) {
        return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
    }
    const std::string digits = general(value, 9);
    double rounded = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), rounded);
    return rounded;
}

Json jsonNumbers(std::span<const float> values)
{
    Json all = Json::array();
    for (const float value : values) {
        all.push_back(jsonNumber(double{value}));
    }
    return all;
}

Json jsonStored(TexelType type, std::span<const float> values)
{
    if (!isWhole(type)) {
        return jsonNumbers(values);
    }
    Json all = Json::array();
    for (const float value : values) {
        all.push_back(std::lround(double{value} * top(type)));
    }
    return all;
}

Json jsonNeighbour(std::size_t edge, const std::optional<TexelsAcross>& neighbour)
{
    if (!neighbour) {
        return {{"edge", edge}, {"border", true}};
    }
    return {{"edge", edge},
            {"face", indexOf(neighbour->face)},
            {"level", neighbour->level.log2()},
            {"itsEdge", indexOf(neighbour->edge)},
            {"first", toText(TexelPlace{neighbour->face, neighbour->first})},
            {"last", toText(TexelPlace{neighbour->face, neighbour->last})},
            {"count", neighbour->count}};
}

Json jsonDisplay(const TexelDisplay& display)
{
    return {{"values", jsonNumbers(display.values)}, {"rgba", display.color}};
}

std::string_view nameOf(TexelHalf half)
{
    return half == TexelHalf::Lower ? "lower" : "upper";
}

std::string colorText(const std::array<std::uint8_t, 4>& color)
{
    constexpr TexelFormat kOneChannel{TexelType::UInt8, 1, std::nullopt};
    std::string text(1, '#');
    for (const std::byte& part : std::as_bytes(std::span(color).first<3>())) {
        text += hexText(kOneChannel, {&part, 1});
    }
    return text;
}

std::string fixed(double value)
{
    return written(value, std::chars_format::fixed, 5);
}

} // namespace

TexelReport describePlace(const WalkedSurface& surface, const TexelPlace& place, glm::dvec2 uv)
{
    check(indexOf(place.face) < surface.texels.faceCount(), "a face of the surface");
    const FaceTexels& face = surface.texels.face(place.face);
    TexelReport report;
    report.place = place;
    report.level = surface.level(place.face);
    report.levelsDropped = face.level().log2() - report.level.log2();
    report.index = texelIndex(report.level, place.texel);
    report.pixel = packedPixel(report.level, place.texel);
    report.uv = uv;
    report.format = surface.texels.format();
    for (const LocalEdge edge : kLocalEdges) {
        report.neighbours[indexOf(edge)] = texelsAcross(surface, place, edge);
    }
    return report;
}

TexelReport describe(const WalkedSurface& surface,
                     const TexelPlace& place,
                     glm::dvec2 uv,
                     std::span<const std::byte> stored)
{
    TexelReport report = describePlace(surface, place, uv);
    report.stored.assign(stored.begin(), stored.end());
    if (stored.empty()) {
        report.stored.resize(report.format.texelBytes());
        reducedTexel(report.format,
                     surface.texels.face(place.face),
                     report.levelsDropped,
                     report.index,
                     report.stored);
    }
    report.values.resize(report.format.channels);
    decode(report.format.type, report.stored, report.values);
    return report;
}

std::string storedText(TexelType type, std::span<const float> values)
{
    return listed(values, [type](float value) { return storedNumber(type, value); });
}

std::string hexText(const TexelFormat& format, std::span<const std::byte> stored)
{
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text;
    for (std::size_t k = 0; k < stored.size(); ++k) {
        if (k > 0 && k % byteSize(format.type) == 0) {
            text += ' ';
        }
        const auto byte = std::to_integer<unsigned>(stored[k]);
        text += kDigits[byte >> 4U];
        text += kDigits[byte & 15U];
    }
    return text;
}

std::string neighbourText(const std::optional<TexelsAcross>& neighbour)
{
    if (!neighbour) {
        return "border";
    }
    const std::string first = toText(TexelPlace{neighbour->face, neighbour->first});
    return neighbour->count == 1
               ? first
               : first + " to " + toText(TexelPlace{neighbour->face, neighbour->last}) + " (" +
                     std::to_string(neighbour->count) + ")";
}

std::vector<ReportLine> linesOf(const TexelReport& report)
{
    std::vector<ReportLine> lines;
    const auto add = [&lines](std::string name, std::string value) {
        lines.push_back({std::move(name), std::move(value)});
    };
    const std::string resolution = std::to_string(report.level.resolution());
    add("Address", toText(report.place));
    add("Face",
        std::to_string(indexOf(report.place.face)) +
            (report.polygon ? std::string(" · polygon ") + std::to_string(*report.polygon) : ""));
    add("Level",
        std::to_string(report.level.log2()) + " · " + resolution + " × " + resolution +
            (report.levelsDropped > 0 ? std::string(" · ") + std::to_string(report.levelsDropped) +
                                            " below the face's own"
                                      : ""));
    add("Texel",
        std::string("(") + std::to_string(report.place.texel.i) + ", " +
            std::to_string(report.place.texel.j) + ") " +
            std::string(nameOf(report.place.texel.half)));
    add("Stored at",
        std::string("pixel ") + std::to_string(report.pixel.x) + ", " +
            std::to_string(report.pixel.y) + " · index " + std::to_string(indexOf(report.index)));
    add("u v w", fixed(report.uv.x) + "  " + fixed(report.uv.y) + "  " + fixed(report.w()));
    if (report.position) {
        add("Position",
            general(double{report.position->x}, 7) + "  " + general(double{report.position->y}, 7) +
                "  " + general(double{report.position->z}, 7));
    }
    if (!report.stored.empty()) {
        add("Stored", storedText(report.format.type, report.values));
        add("Bytes", toHex(report));
    }
    if (report.display) {
        add("Shown", listed(report.display->values, shownNumber));
        add("Colour", colorText(report.display->color));
    }
    for (std::size_t edge = 0; edge < report.neighbours.size(); ++edge) {
        add(std::string("Edge ") + std::to_string(edge), neighbourText(report.neighbours[edge]));
    }
    return lines;
}

std::string toText(const TexelReport& report)
{
    std::string text;
    for (const ReportLine& line : linesOf(report)) {
        text.append(line.name).append(": ").append(line.value).append("\n");
    }
    return text;
}

std::string toHex(const TexelReport& report)
{
    return hexText(report.format, report.stored);
}

std::string toJson(const TexelReport& report)
{
    Json json = {{"address", toText(report.place)},
                 {"face", indexOf(report.place.face)},
                 {"level", report.level.log2()},
                 {"resolution", report.level.resolution()},
                 {"levelsDropped", report.levelsDropped},
                 {"i", report.place.texel.i},
                 {"j", report.place.texel.j},
                 {"half", nameOf(report.place.texel.half)},
                 {"index", indexOf(report.index)},
                 {"pixel", {report.pixel.x, report.pixel.y}},
                 {"uvw", {report.uv.x, report.uv.y, report.w()}},
                 {"type", trixel::nameOf(report.format.type)},
                 {"channels", report.format.channels}};
    if (!report.stored.empty()) {
        json["stored"] = jsonStored(report.format.type, report.values);
        json["bytes"] = toHex(report);
    }
    if (report.format.alpha) {
        json["alpha"] = *report.format.alpha;
    }
    if (report.polygon) {
        json["polygon"] = *report.polygon;
    }
    if (report.position) {
        json["position"] =
            jsonNumbers(std::array{report.position->x, report.position->y, report.position->z});
    }
    if (report.display) {
        json["display"] = jsonDisplay(*report.display);
    }
    Json neighbours = Json::array();
    for (std::size_t edge = 0; edge < report.neighbours.size(); ++edge) {
        neighbours.push_back(jsonNeighbour(edge, report.neighbours[edge]));
    }
    json["neighbours"] = std::move(neighbours);
    return json.dump(2) + "\n";
}

} // namespace trixel
