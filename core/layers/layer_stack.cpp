// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layer_stack.h"

#include "core/base/check.h"
#include "core/texture/level_change.h"

#include <algorithm>
#include <utility>

namespace trixel {

TexelFormat layerFormat(const TexelFormat& base)
{
    TexelFormat format = base;
    format.alpha = base.channels;
    ++format.channels;
    return format;
}

std::vector<std::byte> uncoveredTexel(const TexelFormat& base)
{
    return std::vector<std::byte>(layerFormat(base).texelBytes());
}

LayerStack::LayerStack(TexelStore base)
    : m_base(std::move(base))
{
}

std::optional<std::size_t> LayerStack::indexOf(LayerId layer) const
{
    const auto found = std::ranges::find(m_layers, layer, &Layer::id);
    if (found == m_layers.end()) {
        return std::nullopt;
    }
    return static_cast<std::size_t>(found - m_layers.begin());
}

bool LayerStack::has(LayerId layer) const
{
    return layer == kBaseLayer || indexOf(layer).has_value();
}

const Layer& LayerStack::find(LayerId layer) const
{
    const std::optional<std::size_t> index = indexOf(layer);
    check(index.has_value(), "a layer of the stack");
    return m_layers[*index];
}

Layer& LayerStack::find(LayerId layer)
{
    return const_cast<Layer&>(std::as_const(*this).find(layer));
}

const TexelStore& LayerStack::texels(LayerId layer) const
{
    return layer == kBaseLayer ? m_base : find(layer).texels;
}

TexelStore& LayerStack::texels(LayerId layer)
{
    return layer == kBaseLayer ? m_base : find(layer).texels;
}

const LayerSettings& LayerStack::settings(LayerId layer) const
{
    return find(layer).settings;
}

bool LayerStack::hasRoom() const
{
    const std::size_t channels = m_base.format().channels;
    const std::size_t all = channels + (m_layers.size() + 1) * (channels + 1);
    return m_layers.size() < kMaxLayers && all <= TexelFormat::kMaxChannels;
}

LayerId LayerStack::insert(std::size_t index, LayerSettings settings)
{
    const TexelFormat& format = m_base.format();
    return insert(index,
                  std::move(settings),
                  TexelStore(layerFormat(format), levelsOf(m_base), uncoveredTexel(format)));
}

LayerId LayerStack::insert(std::size_t index, LayerSettings settings, TexelStore texels)
{
    check(index <= m_layers.size() && hasRoom(), "a place for a layer");
    check(texels.faceCount() == m_base.faceCount() &&
              texels.format() == layerFormat(m_base.format()),
          "a layer of the base's faces");
    const LayerId id{++m_lastId};
    m_layers.insert(m_layers.begin() + static_cast<std::ptrdiff_t>(index),
                    Layer{id, {}, std::move(texels)});
    set(id, std::move(settings));
    return id;
}

void LayerStack::remove(LayerId layer)
{
    m_layers.erase(m_layers.begin() + (&find(layer) - m_layers.data()));
}

void LayerStack::move(LayerId layer, std::size_t index)
{
    check(index < m_layers.size(), "a place among the layers");
    Layer moved = std::move(find(layer));
    m_layers.erase(m_layers.begin() + static_cast<std::ptrdiff_t>(*indexOf(layer)));
    m_layers.insert(m_layers.begin() + static_cast<std::ptrdiff_t>(index), std::move(moved));
}

void LayerStack::set(LayerId layer, LayerSettings settings)
{
    check(settings.opacity >= 0 && settings.opacity <= 1, "an opacity");
    find(layer).settings = std::move(settings);
}

} // namespace trixel
