// SPDX-License-Identifier: GPL-3.0-or-later
//
// Documents with layers, and what holds of them at any time.
#pragma once

#include "tests/ui/fixtures.h"
#include "ui/document/document.h"

#include <array>
#include <string>
#include <vector>

namespace trixel::ui {

inline constexpr std::array<float, 4> kLayerBlue{0, 0, 1, 1};

/// What is being edited: the layers there are, or the base of the first.
inline LayerStack stackOf(const Document& document)
{
    return document.layers().isPlain() ? LayerStack(document.texels()) : document.layers();
}

/// Adds a layer above the active one, to be painted from now on.
inline LayerId addLayer(Document& document, const std::string& name, LayerSettings settings = {})
{
    LayerStack next = stackOf(document);
    const auto below = next.indexOf(document.activeLayer());
    settings.name = name;
    const LayerId layer = next.insert(below ? *below + 1 : 0, settings);
    document.editLayers(std::move(next), layer, QStringLiteral("Add layer"));
    return layer;
}

inline bool setLayer(Document& document, LayerId layer, LayerSettings settings, bool goesOn = false)
{
    LayerStack next = document.layers();
    next.set(layer, std::move(settings));
    return document.editLayers(
        std::move(next), document.activeLayer(), QStringLiteral("Settings"), goesOn);
}

inline bool setOpacity(Document& document, LayerId layer, float opacity, bool goesOn = false)
{
    LayerSettings settings = document.layers().settings(layer);
    settings.opacity = opacity;
    return setLayer(document, layer, std::move(settings), goesOn);
}

inline bool setVisible(Document& document, LayerId layer, bool isVisible)
{
    LayerSettings settings = document.layers().settings(layer);
    settings.isVisible = isVisible;
    return setLayer(document, layer, std::move(settings));
}

inline bool removeLayer(Document& document, LayerId layer)
{
    LayerStack next = document.layers();
    next.remove(layer);
    const LayerId active = next.isPlain() ? kBaseLayer : next.layers().back().id;
    return document.editLayers(std::move(next), active, QStringLiteral("Remove layer"));
}

/// What is shown is what the layers look like.
inline bool isShown(const Document& document)
{
    if (document.layers().isPlain()) {
        return document.activeLayer() == kBaseLayer;
    }
    NoProgress progress;
    const auto all = composed(document.layers(), Threads::all(), progress);
    return all && allTexels(all->shown) == allTexels(document.texels());
}

/// All that undo has to bring back: what is shown, and each layer with its settings.
struct LayersPicture
{
    std::vector<std::byte> shown;
    std::vector<std::vector<std::byte>> texels; ///< of the base and the layers
    std::vector<LayerSettings> settings;
    std::vector<LayerId> ids;

    bool operator==(const LayersPicture&) const = default;
};

inline LayersPicture pictureOf(const Document& document)
{
    LayersPicture picture;
    picture.shown = allTexels(document.texels());
    picture.texels.push_back(allTexels(document.layers().base()));
    for (const Layer& layer : document.layers().layers()) {
        picture.texels.push_back(allTexels(layer.texels));
        picture.settings.push_back(layer.settings);
        picture.ids.push_back(layer.id);
    }
    return picture;
}

} // namespace trixel::ui
