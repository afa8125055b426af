// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a document does with layers other than painting on them.
#include "core/base/check.h"
#include "ui/document/document.h"
#include "ui/document/swap_layers.h"

#include <utility>

namespace trixel::ui {

namespace {

/// The one layer whose settings differ, if nothing else does between stacks of which one was made
/// from the other.
std::optional<LayerId> layerSet(const LayerStack& before, const LayerStack& after)
{
    if (before.layers().size() != after.layers().size()) {
        return std::nullopt;
    }
    std::optional<LayerId> set;
    for (std::size_t k = 0; k < after.layers().size(); ++k) {
        const Layer& one = after.layers()[k];
        const Layer& other = before.layers()[k];
        const bool differs = !(one.settings == other.settings);
        if (one.id != other.id || (differs && set)) {
            return std::nullopt;
        }
        set = differs ? one.id : set;
    }
    return set;
}

} // namespace

void Document::setActiveLayer(LayerId layer)
{
    check(layers().has(layer), "a layer of the stack");
    if (layer == m_activeLayer) {
        return;
    }
    endStroke();
    m_activeLayer = layer;
    emit activeLayerChanged();
}

bool Document::editLayers(LayerStack next, LayerId active, const QString& text, bool goesOn)
{
    if (!isOpen()) {
        return false;
    }
    check(next.base().faceCount() == texels().faceCount(), "a stack of the same faces");
    check(next.has(active) && (!next.isPlain() || active == kBaseLayer), "a layer of the stack");
    endStroke();
    if (isSettling() || !m_later.empty()) {
        emit notice(tr("%1: the last stroke is still being painted, nothing was done.").arg(text));
        return false;
    }
    const std::optional<LayerId> set = layerSet(layers(), next);
    NoProgress progress;
    Result<Layered> made = composed(std::move(next), Threads::all(), progress);
    if (!made) {
        emit notice(tr("%1: %2").arg(text, QString::fromStdString(made.error().message)));
        return false;
    }
    LayersState state{std::move(made->layers), std::move(made->shown), active};
    const StateId id{++m_lastState, this->state().views};
    m_undo.push(new SwapLayers(*this, std::move(state), {set, goesOn}, id, text)); // owned by it
    return true;
}

void Document::swapLayers(LayersState& state)
{
    cancelStroke();
    std::swap(m_project.layers, state.layers);
    std::swap(m_project.texels, *state.shown);
    std::swap(m_activeLayer, state.active);
    emit changed({});
    emit layersChanged();
    if (m_activeLayer != state.active) {
        emit activeLayerChanged();
    }
}

} // namespace trixel::ui
