// SPDX-License-Identifier: GPL-3.0-or-later
//
// What users read of layers.
#pragma once

#include <QString>

#include "core/layers/layer_stack.h"

namespace trixel::ui {

/// "Multiply"
QString titleOf(LayerBlend blend);

/// "60 %"
QString opacityText(float opacity);

/// The name of a layer of the stack, or "Base".
QString layerName(const LayerStack& layers, LayerId layer);

/// How a layer is set where that is not as layers begin: "Multiply · 60 %", or nothing.
QString settingsHint(const LayerSettings& settings);

/// Why strokes on a layer of the stack are refused, or not seen; empty where they are.
QString whyUnseen(const LayerStack& layers, LayerId layer);

/// The pattern with the least number that makes a name which no layer has: "Layer 3".
/// \param pattern  with a %1
QString freeLayerName(const LayerStack& layers, const QString& pattern);

} // namespace trixel::ui
