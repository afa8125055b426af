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

void Renderer::clearVertices(Layer& layer)
{
    if (std::exchange(layer.hasVertices, false)) {
        layer.vertices = DisplayVertices(++m_displays << 16U);
        layer.vertexCard.clear();
    }
}

void Renderer::clearFilters(Layer& layer)
{
    clearVertices(layer);
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
            clearVertices(layer);
        }
        if (!wants(FilterSource::Atlas)) {
            layer.atlas.clear();
        }
    }
    shareBudget();
}

DisplayVertices* Renderer::vertices(const TexelStore& store, Side side)
{
    if (!m_filterMesh || !wants(FilterSource::Vertices)) {
        return nullptr;
    }
    Layer& shown = layer(side);
    if (!std::exchange(shown.hasVertices, true)) {
        shown.vertices.reset(
            m_filterMesh, store, shown.mipDrop, mostTexels(texelBytes(shown.display.format())));
        shown.vertices.showChannels(shown.display.channels());
    }
    return &shown.vertices;
}

std::size_t Renderer::uploadFilters(const TexelStore& store, std::size_t byteBudget, Side side)
{
    std::size_t bytes = uploadAtlas(store, byteBudget, side);
    DisplayVertices* made = vertices(store, side);
    if (made != nullptr && made->hasWork()) {
        const DisplayUpdate update = made->take(store, byteBudget);
        layer(side).vertexCard.upload(update, made->records(), made->format());
        bytes += update.bytes.size();
    }
    return bytes;
}

std::size_t Renderer::uploadAtlas(const TexelStore& store, std::size_t byteBudget, Side side)
{
    if (!m_filterMesh || !wants(FilterSource::Atlas)) {
        return 0;
    }
    Layer& sent = layer(side);
    const std::uint64_t most = mostTexels(1); // bytes
    return sent.atlas.upload(
        m_filterMesh, store, sent.display.channels(), sent.mipDrop, most, byteBudget);
}

bool Renderer::hasFilterWork(Side side) const
{
    const Layer& layer = m_layers[static_cast<std::size_t>(side)];
    const bool hasVertexWork = m_filterMesh && wants(FilterSource::Vertices) &&
                               (!layer.hasVertices || layer.vertices.hasWork());
    return hasVertexWork || hasAtlasWork(side);
}

bool Renderer::hasAtlasWork(Side side) const
{
    const Layer& layer = m_layers[static_cast<std::size_t>(side)];
    return m_filterMesh && wants(FilterSource::Atlas) && layer.atlas.hasWork();
}

bool Renderer::takeAtlasFailure()
{
    const bool first = m_layers.front().atlas.takeFailure();
    return m_layers.back().atlas.takeFailure() || first;
}

bool Renderer::isFilterReady(Filtering filtering, Side side) const
{
    const Layer& layer = m_layers[static_cast<std::size_t>(side)];
    switch (sourceOf(filtering)) {
    case FilterSource::Texels:
        return true;
    case FilterSource::Vertices:
        return m_filterMesh != nullptr && layer.hasVertices && layer.vertices.isShown();
    case FilterSource::Atlas:
        break;
    }
    return m_filterMesh != nullptr && layer.atlas.isReady();
}

} // namespace trixel::render
