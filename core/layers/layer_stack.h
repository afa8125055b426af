// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/layer.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace trixel {

/// A base and the layers over it, bottom to top. A value: copies share texels until one is painted.
///
/// A *plain* stack has no layers, and then no base either: the texels that are shown are all there
/// is, and are painted themselves (see `Layered` in compose.h).
class LayerStack
{
public:
    /// Layers beside the base; what files may hold of channels sets a bound, too.
    static constexpr std::size_t kMaxLayers = 64;

    /// Plain.
    LayerStack() = default;
    /// A base to put layers on; plain until there is one.
    explicit LayerStack(TexelStore base);

    bool isPlain() const { return m_layers.empty(); }
    const TexelStore& base() const { return m_base; }
    /// Bottom to top.
    std::span<const Layer> layers() const { return m_layers; }

    /// The place of a layer from the bottom; nothing for the base and unknown ones.
    std::optional<std::size_t> indexOf(LayerId layer) const;
    /// Whether it is the base or one of the layers.
    bool has(LayerId layer) const;
    const TexelStore& texels(LayerId layer) const;
    /// To be painted: of the layer or the base (checked).
    TexelStore& texels(LayerId layer);
    /// Of a layer, not the base (checked).
    const LayerSettings& settings(LayerId layer) const;

    /// Whether another fits: `kMaxLayers`, and the channels of all within those of a format.
    bool hasRoom() const;
    /// A layer that covers nothing, at a place from the bottom. \param index  at most the number of
    /// layers (checked); there is room (checked)
    LayerId insert(std::size_t index, LayerSettings settings);
    /// The same of given texels. \param texels  of `layerFormat` and the base's levels (format and
    /// number of faces are checked)
    LayerId insert(std::size_t index, LayerSettings settings, TexelStore texels);
    /// A layer, not the base (checked).
    void remove(LayerId layer);
    /// \param index  below the number of layers (checked)
    void move(LayerId layer, std::size_t index);
    /// \param settings  opacity in [0,1] (checked)
    void set(LayerId layer, LayerSettings settings);

private:
    Layer& find(LayerId layer);
    const Layer& find(LayerId layer) const;

    TexelStore m_base;
    std::vector<Layer> m_layers;
    std::uint32_t m_lastId = 0;
};

} // namespace trixel
