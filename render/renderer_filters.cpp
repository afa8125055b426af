// SPDX-License-Identifier: GPL-3.0-or-later
//
// What ways of filtering need on the card beside texels.
#include "core/base/check.h"
#include "render/renderer.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace trixel::render {

void Renderer::setFilterMesh(std::shared_ptr<const FilterMesh> mesh)
{
    check(!mesh || mesh->faceCount() == m_faceCount, "of the mesh that is drawn");
    m_surface->setFilterMesh(mesh);
    m_filterMesh = std::move(mesh);
    for (Layer& layer : m_layers) {
        clearFilters(layer);
    }
}

void Renderer::clearFilters(Layer& layer)
{
    layer.vertices.clear();
    layer.atlas.clear();
}

void Renderer::wantFilterings(std::span<const Filtering> filterings)
{
    m_wanted = {};
    for (const Filtering filtering : filterings) {
        m_wanted[static_cast<std::size_t>(sourceOf(filtering))] = true;
    }
    for (Layer& layer : m_layers) {
        if (!wants(FilterSource::Vertices)) {
            layer.vertices.clear();
        }
        if (!wants(FilterSource::Atlas)) {
            layer.atlas.clear();
        }
    }
    shareBudget();
}

std::size_t Renderer::uploadFilters(const TexelStore& store, std::size_t byteBudget, Side side)
{
    if (!m_filterMesh) {
        return 0;
    }
    Layer& sent = layer(side);
    const CardChannels& channels = sent.display.channels();
    std::size_t bytes = 0;
    if (wants(FilterSource::Vertices)) {
        const std::uint64_t most = mostTexels(texelBytes(sent.display.format()));
        bytes +=
            sent.vertices.upload(m_filterMesh, store, channels, sent.mipDrop, most, byteBudget);
    }
    if (wants(FilterSource::Atlas)) {
        const std::uint64_t most = mostTexels(1); // bytes
        bytes += sent.atlas.upload(m_filterMesh, store, channels, sent.mipDrop, most, byteBudget);
    }
    return bytes;
}

bool Renderer::hasFilterWork(Side side) const
{
    const Layer& layer = m_layers[static_cast<std::size_t>(side)];
    return m_filterMesh != nullptr &&
           ((wants(FilterSource::Vertices) && layer.vertices.hasWork()) ||
            (wants(FilterSource::Atlas) && layer.atlas.hasWork()));
}

bool Renderer::isFilterReady(Filtering filtering, Side side) const
{
    const Layer& layer = m_layers[static_cast<std::size_t>(side)];
    switch (sourceOf(filtering)) {
    case FilterSource::Texels:
        return true;
    case FilterSource::Vertices:
        return m_filterMesh != nullptr && layer.vertices.isReady();
    case FilterSource::Atlas:
        break;
    }
    return m_filterMesh != nullptr && layer.atlas.isReady();
}

} // namespace trixel::render
