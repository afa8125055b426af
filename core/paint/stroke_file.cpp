// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/paint/stroke_file.h"

#include "core/base/json_fields.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trixel {

namespace {

constexpr std::array<std::pair<std::string_view, BlendMode>, 2> kBlendNames{
    {{"normal", BlendMode::Normal}, {"erase", BlendMode::Erase}}};

Status parseBlend(const JsonFields& fields, BlendMode& blend)
{
    const Json* field = fields.find("blend");
    if (field == nullptr) {
        return {};
    }
    const auto* known = std::ranges::find_if(
        kBlendNames, [&](const auto& entry) { return *field == Json(std::string(entry.first)); });
    if (known == kBlendNames.end()) {
        return fields.error("blend", "\"normal\" or \"erase\"", *field);
    }
    blend = known->second;
    return {};
}

/// One to four numbers; where fewer than three are given, the last stands for the rest up to the
/// third. The fourth is 1 unless given.
Status parseColor(const JsonFields& fields, std::array<float, 4>& color)
{
    const auto field = fields.need("color");
    if (!field) {
        return tl::unexpected(field.error());
    }
    const Json& values = **field;
    const double limit = std::numeric_limits<float>::max();
    const bool usable = values.is_array() && !values.empty() && values.size() <= color.size() &&
                        std::ranges::all_of(values, [&](const Json& v) {
                            return v.is_number() && std::abs(v.get<double>()) <= limit;
                        });
    if (!usable) {
        return fields.error("color", "an array of 1 to 4 finite numbers", values);
    }
    for (std::size_t k = 0; k < color.size(); ++k) {
        const bool opaque = k == 3 && values.size() < 4;
        color[k] = opaque
                       ? 1.0F
                       : static_cast<float>(values[std::min(k, values.size() - 1)].get<double>());
    }
    return {};
}

Result<Brush> parseBrush(const Json& json, const std::string& place)
{
    const auto fields = JsonFields::of(json, place);
    if (!fields) {
        return tl::unexpected(fields.error());
    }
    Brush brush;
    const auto radius = fields->need("radius");
    const Status needed = radius ? Status() : Status(tl::unexpected(radius.error()));
    const Status status = firstError({fields->onlyHas({"radius",
                                                       "unit",
                                                       "hardness",
                                                       "opacity",
                                                       "flow",
                                                       "spacing",
                                                       "blend",
                                                       "color",
                                                       "pressureToSize",
                                                       "pressureToOpacity",
                                                       "paintThrough"}),
                                      needed,
                                      fields->number("radius", brush.radius),
                                      fields->mustBe("unit", "world"),
                                      fields->number("hardness", brush.hardness),
                                      fields->number("opacity", brush.opacity),
                                      fields->number("flow", brush.flow),
                                      fields->number("spacing", brush.spacing),
                                      parseBlend(*fields, brush.blend),
                                      parseColor(*fields, brush.color),
                                      fields->flag("pressureToSize", brush.pressureToSize),
                                      fields->flag("pressureToOpacity", brush.pressureToOpacity),
                                      fields->flag("paintThrough", brush.paintThrough)});
    if (!status) {
        return tl::unexpected(status.error());
    }
    if (const Status valid = validate(brush); !valid) {
        return prefixed(place, valid.error());
    }
    return brush;
}

Result<StrokeSample> parseSample(const Json& json, const std::string& place, std::size_t faceCount)
{
    const auto fields = JsonFields::of(json, place);
    if (!fields) {
        return tl::unexpected(fields.error());
    }
    StrokeSample sample;
    for (const char* name : {"face", "u", "v"}) {
        if (const auto field = fields->need(name); !field) {
            return tl::unexpected(field.error());
        }
    }
    const Json& face = *fields->find("face");
    if (!face.is_number_unsigned() || face.get<std::uint64_t>() >= faceCount) {
        return fields->error("face",
                             "a whole number below the mesh's " + std::to_string(faceCount) +
                                 " faces",
                             face);
    }
    sample.face = faceId(face.get<std::size_t>());
    const Status status = firstError({fields->onlyHas({"face", "u", "v", "pressure", "time"}),
                                      fields->number("u", sample.uv.x),
                                      fields->number("v", sample.uv.y),
                                      fields->number("pressure", sample.pressure),
                                      fields->number("time", sample.time)});
    if (!status) {
        return tl::unexpected(status.error());
    }
    // A little over: sums of rounded numbers from another program.
    constexpr float kOver = 1e-4F;
    for (const auto& [name, value] : {std::pair("u", sample.uv.x), std::pair("v", sample.uv.y)}) {
        if (value < -kOver || sample.uv.x + sample.uv.y > 1.0F + kOver) {
            return fields->error(name, "u and v from 0 on with a sum up to 1", *fields->find(name));
        }
    }
    if (sample.pressure < 0.0F || sample.pressure > 1.0F) {
        return fields->error("pressure", "a number from 0 to 1", *fields->find("pressure"));
    }
    return sample;
}

Status parseLayer(const JsonFields& fields, std::uint32_t& layer)
{
    const Json* field = fields.find("layer");
    if (field == nullptr) {
        return {};
    }
    if (!field->is_number_unsigned() ||
        field->get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max()) {
        return fields.error("layer", "0 for the base or the number of a layer above it", *field);
    }
    layer = field->get<std::uint32_t>();
    return {};
}

Result<RecordedStroke>
parseStroke(const Json& json, const std::string& place, std::size_t faceCount)
{
    const auto fields = JsonFields::of(json, place);
    if (!fields) {
        return tl::unexpected(fields.error());
    }
    RecordedStroke stroke;
    const Status status = firstError({fields->onlyHas({"layer", "surface", "brush", "samples"}),
                                      parseLayer(*fields, stroke.layer)});
    if (!status) {
        return tl::unexpected(status.error());
    }
    const Json* surface = fields->find("surface");
    if (surface != nullptr && *surface != "cage" && *surface != "limit") {
        return fields->error("surface", "\"cage\" or \"limit\"", *surface);
    }
    const auto brushField = fields->need("brush");
    const auto samples = fields->array("samples");
    if (!brushField || !samples) {
        return tl::unexpected(brushField ? samples.error() : brushField.error());
    }
    const auto brush = parseBrush(**brushField, place + ", brush");
    if (!brush) {
        return tl::unexpected(brush.error());
    }
    stroke.brush = *brush;
    stroke.onLimit = surface != nullptr && *surface == "limit";
    stroke.samples.reserve((*samples)->size());
    for (const Json& entry : **samples) {
        const std::string samplePlace =
            place + ", sample " + std::to_string(stroke.samples.size() + 1);
        const auto sample = parseSample(entry, samplePlace, faceCount);
        if (!sample) {
            return tl::unexpected(sample.error());
        }
        stroke.samples.push_back(*sample);
    }
    return stroke;
}

Json toJson(const RecordedStroke& stroke)
{
    const Brush& brush = stroke.brush;
    const auto* blend = std::ranges::find(
        kBlendNames, brush.blend, &std::pair<std::string_view, BlendMode>::second);
    Json samples = Json::array();
    for (const StrokeSample& sample : stroke.samples) {
        samples.push_back({{"face", static_cast<std::uint32_t>(sample.face)},
                           {"u", sample.uv.x},
                           {"v", sample.uv.y},
                           {"pressure", sample.pressure},
                           {"time", sample.time}});
    }
    Json json{{"layer", stroke.layer},
              {"brush",
               {{"radius", brush.radius},
                {"unit", "world"},
                {"hardness", brush.hardness},
                {"opacity", brush.opacity},
                {"flow", brush.flow},
                {"spacing", brush.spacing},
                {"blend", std::string(blend->first)},
                {"color", brush.color},
                {"pressureToSize", brush.pressureToSize},
                {"pressureToOpacity", brush.pressureToOpacity},
                {"paintThrough", brush.paintThrough}}},
              {"samples", std::move(samples)}};
    if (stroke.onLimit) { // readers from before there were limit surfaces take what they know
        json["surface"] = "limit";
    }
    return json;
}

} // namespace

Result<std::vector<RecordedStroke>> parseStrokes(std::string_view text, std::size_t faceCount)
{
    const auto json = parseJson(text);
    if (!json) {
        return tl::unexpected(json.error());
    }
    const auto fields = JsonFields::of(*json, "stroke file");
    if (!fields) {
        return tl::unexpected(fields.error());
    }
    const auto version = fields->need("version");
    const auto list = fields->array("strokes");
    const Status status = firstError({version ? Status() : Status(tl::unexpected(version.error())),
                                      fields->mustBe("version", 1),
                                      fields->onlyHas({"version", "strokes"}),
                                      list ? Status() : Status(tl::unexpected(list.error()))});
    if (!status) {
        return tl::unexpected(status.error());
    }
    std::vector<RecordedStroke> strokes;
    for (const Json& entry : **list) {
        auto stroke = parseStroke(entry, "stroke " + std::to_string(strokes.size() + 1), faceCount);
        if (!stroke) {
            return tl::unexpected(stroke.error());
        }
        strokes.push_back(std::move(*stroke));
    }
    return strokes;
}

std::string writeStrokes(std::span<const RecordedStroke> strokes)
{
    Json list = Json::array();
    for (const RecordedStroke& stroke : strokes) {
        list.push_back(toJson(stroke));
    }
    return Json{{"version", 1}, {"strokes", std::move(list)}}.dump(1) + "\n";
}

} // namespace trixel
