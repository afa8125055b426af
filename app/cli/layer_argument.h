// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/layers/layer_stack.h"

#include <optional>
#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace trixel::app {

/// The layer that an option means: a whole number counts from the bottom, 0 being the base; all
/// else is the name of a layer. Errors name the option and list the layers there are.
Result<LayerId> layerOf(std::string_view option, const std::string& text, const LayerStack& layers);

/// "--layer", of verbs that write one layer alone.
void addLayerOption(CLI::App& verb, std::optional<std::string>& layer);

} // namespace trixel::app
