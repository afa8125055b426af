// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/layer_argument.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <vector>

namespace trixel::app {
namespace {

std::string quoted(const std::string& name)
{
    return '"' + name + '"';
}

/// "0 (the base), 1 "Lines", 2 "Shade""
std::string listOf(const LayerStack& layers)
{
    std::string list = "0 (the base)";
    std::size_t number = 0;
    for (const Layer& layer : layers.layers()) {
        list += ", " + std::to_string(++number) + ' ' + quoted(layer.settings.name);
    }
    return list;
}

tl::unexpected<Error>
fault(std::string_view option, const std::string& what, const LayerStack& layers)
{
    return contentsError(std::string(option) + ": " + what + "; the layers are " + listOf(layers));
}

bool isNumber(const std::string& text)
{
    return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

Result<LayerId> numbered(std::string_view option, const std::string& text, const LayerStack& layers)
{
    std::size_t number = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
    if (read.ec != std::errc() || number > layers.layers().size()) {
        return fault(option, "there is no layer " + text, layers);
    }
    return number == 0 ? kBaseLayer : layers.layers()[number - 1].id;
}

} // namespace

Result<LayerId> layerOf(std::string_view option, const std::string& text, const LayerStack& layers)
{
    if (isNumber(text)) {
        return numbered(option, text, layers);
    }
    std::vector<LayerId> found;
    for (const Layer& layer : layers.layers()) {
        if (layer.settings.name == text) {
            found.push_back(layer.id);
        }
    }
    if (found.empty()) {
        return fault(option, "there is no layer " + quoted(text), layers);
    }
    if (found.size() > 1) {
        return fault(option,
                     std::to_string(found.size()) + " layers are called " + quoted(text) +
                         ", expected the number of one",
                     layers);
    }
    return found.front();
}

void addLayerOption(CLI::App& verb, std::optional<std::string>& layer)
{
    verb.add_option("--layer",
                    layer,
                    "One layer alone, its coverage as opacity: a name, or a number from the "
                    "bottom, 0 being the base; else what is shown")
        ->type_name("LAYER");
}

} // namespace trixel::app
