// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/layers_metadata.h"

#include "core/base/json_fields.h"
#include "core/io/ptx_metadata.h"
#include "core/layers/layer_stack.h"

#include <string>
#include <utility>

namespace trixel {

namespace {

tl::unexpected<Error> fault(const std::string& what)
{
    return contentsError(std::string(kLayersKey) + " " + what);
}

/// The name up to the last whole character that has room.
std::string cut(const std::string& name)
{
    std::size_t end = std::min(name.size(), kMostLayerNameBytes);
    const auto continues = [&](std::size_t at) {
        return at < name.size() && (static_cast<unsigned char>(name[at]) & 0xC0U) == 0x80U;
    };
    while (end > 0 && continues(end)) {
        --end;
    }
    return name.substr(0, end);
}

Status readName(const JsonFields& fields, std::string& name)
{
    const auto field = fields.need("name");
    if (!field) {
        return tl::unexpected(field.error());
    }
    if (!(*field)->is_string()) {
        return fields.error("name", "a text", **field);
    }
    name = (*field)->get<std::string>();
    return name.size() <= kMostLayerNameBytes
               ? Status()
               : contentsError(fields.place() + ": name: expected at most " +
                               std::to_string(kMostLayerNameBytes) + " bytes, found " +
                               std::to_string(name.size()));
}

Status readOpacity(const JsonFields& fields, float& opacity)
{
    const auto field = fields.need("opacity");
    if (!field) {
        return tl::unexpected(field.error());
    }
    const double value = (*field)->is_number() ? (*field)->get<double>() : -1;
    if (!(value >= 0 && value <= 1)) {
        return fields.error("opacity", "a number from 0 to 1", **field);
    }
    opacity = static_cast<float>(value);
    return {};
}

Status readBlend(const JsonFields& fields, LayerBlend& blend)
{
    const auto field = fields.need("blend");
    if (!field) {
        return tl::unexpected(field.error());
    }
    const auto known =
        (*field)->is_string() ? layerBlendFromName((*field)->get<std::string>()) : std::nullopt;
    if (!known) {
        return fields.error("blend", "the name of a blend mode", **field);
    }
    blend = *known;
    return {};
}

Status readVisible(const JsonFields& fields, bool& isVisible)
{
    const auto field = fields.need("visible");
    return field ? fields.flag("visible", isVisible) : Status(tl::unexpected(field.error()));
}

Result<LayerSettings> settingsOf(const Json& json, const std::string& place)
{
    const auto fields = JsonFields::of(json, place);
    if (!fields) {
        return tl::unexpected(fields.error());
    }
    LayerSettings settings;
    const Status status = firstError({fields->onlyHas({"name", "opacity", "blend", "visible"}),
                                      readName(*fields, settings.name),
                                      readOpacity(*fields, settings.opacity),
                                      readBlend(*fields, settings.blend),
                                      readVisible(*fields, settings.isVisible)});
    return status ? Result<LayerSettings>(std::move(settings)) : tl::unexpected(status.error());
}

} // namespace

Result<std::vector<LayerSettings>> layersOf(std::span<const PtxMetadata> items)
{
    const PtxMetadata* item = findMetadata(items, kLayersKey);
    if (item == nullptr) {
        return std::vector<LayerSettings>();
    }
    const auto* text = std::get_if<std::string>(&item->value);
    if (text == nullptr) {
        return fault("is not a text");
    }
    const auto json = parseJson(*text);
    if (!json) {
        return fault("is " + json.error().message);
    }
    if (!json->is_array() || json->empty() || json->size() > LayerStack::kMaxLayers) {
        return fault("is not an array of 1 to " + std::to_string(LayerStack::kMaxLayers) +
                     " layers");
    }
    std::vector<LayerSettings> layers;
    for (const Json& layer : *json) {
        auto settings = settingsOf(
            layer, std::string(kLayersKey) + ", layer " + std::to_string(layers.size() + 1));
        if (!settings) {
            return tl::unexpected(settings.error());
        }
        layers.push_back(std::move(*settings));
    }
    return layers;
}

PtxMetadata metadataOf(std::span<const Layer> layers)
{
    Json list = Json::array();
    for (const Layer& layer : layers) {
        const LayerSettings& settings = layer.settings;
        list.push_back({{"name", cut(settings.name)},
                        {"opacity", settings.opacity},
                        {"blend", std::string(nameOf(settings.blend))},
                        {"visible", settings.isVisible}});
    }
    return {kLayersKey, list.dump(-1, ' ', false, Json::error_handler_t::ignore)};
}

Result<TexelFormat> baseFormat(const TexelFormat& stored, std::size_t layers)
{
    const std::size_t channels = stored.channels;
    const std::size_t all = channels + 1; // a base with coverage would be as wide as a layer
    if (all % (layers + 1) != 0 || all / (layers + 1) < 2) {
        return fault("names " + std::to_string(layers) + (layers == 1 ? " layer" : " layers") +
                     ", which do not fit texels of " + std::to_string(channels) +
                     (channels == 1 ? " channel" : " channels"));
    }
    TexelFormat base = stored;
    base.channels = static_cast<std::uint16_t>(all / (layers + 1) - 1);
    if (base.alpha && *base.alpha >= base.channels) {
        return fault("leaves the base " + std::to_string(base.channels) +
                     " channels, but the opacity is in channel " + std::to_string(*base.alpha));
    }
    return base;
}

Result<TexelFormat> shownFormat(const TexelFormat& stored, std::span<const PtxMetadata> items)
{
    const auto layers = layersOf(items);
    if (!layers) {
        return tl::unexpected(layers.error());
    }
    return layers->empty() ? stored : baseFormat(stored, layers->size());
}

} // namespace trixel
