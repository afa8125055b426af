// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/background_layout.h"
#include "render/display_atlas.h"
#include "render/filtering.h"
#include "render/surface_atlas.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace trixel::render {

/// What ways of filtering read beside the texels themselves.
enum class FilterSource { Texels, Vertices, Atlas };

constexpr FilterSource sourceOf(Filtering filtering)
{
    switch (filtering) {
    case Filtering::Seamless:
    case Filtering::Anisotropic:
        return FilterSource::Vertices;
    case Filtering::PackedAtlas:
        return FilterSource::Atlas;
    case Filtering::Texels:
    case Filtering::LowerHalf:
        break;
    }
    return FilterSource::Texels;
}

/// Whether a way of filtering reads texels: anisotropic sums do where pixels are about as wide.
constexpr bool readsTexels(Filtering filtering)
{
    return filtering != Filtering::Seamless;
}

/// One derived form of a store's texels on the card: made in the background when it is first
/// wanted, kept up to date after strokes while it is, given up when it is not.
/// \tparam Layout  `DisplayAtlas`
template <class Layout, class Update, class Card>
class FilterForm
{
public:
    explicit FilterForm(Gl& gl)
        : m_card(gl)
    {
    }

    /// Gives up everything.
    void clear();
    /// Sends what there is to send, `byteBudget` at most; begins where nothing was. What there was
    /// no memory for is not begun again before all is given up.
    /// \param most  what `Layout::reset` takes as its bound
    /// \return bytes sent
    std::size_t upload(const std::shared_ptr<const FilterMesh>& mesh,
                       const TexelStore& store,
                       const CardChannels& channels,
                       int mipDrop,
                       std::uint64_t most,
                       std::size_t byteBudget);
    void touch(const TexelStore& store, std::span<const TouchedRect> rects);
    void touchAll();
    void showChannels(const CardChannels& channels);
    /// Another bound: begins anew where more is taken, or finer faces could be shown.
    void setMost(std::uint64_t most);
    /// Whether there turned out to be no memory for it, since this was asked last.
    bool takeFailure() { return std::exchange(m_tellsFailure, false); }

    /// Whether all of it is on the card, if not quite up to date.
    bool isReady() const { return m_layout.has_value(); }
    bool hasWork() const { return !m_hasFailed && (!m_layout || m_layout->hasWork()); }
    bool isMaking() const { return m_making != nullptr; }
    Card& card() { return m_card; }
    std::uint64_t bytes() const { return m_card.bytes(); } ///< on the card
    const Layout& layout() const { return *m_layout; }

private:
    Card m_card;
    std::unique_ptr<BackgroundLayout<Layout, Update>> m_making;
    CardChannels m_channels;          ///< of what is being made
    bool m_madeIsOld = false;         ///< what is being made is not what is wanted any more
    std::vector<TouchedRect> m_since; ///< touched since it began
    std::optional<Layout> m_layout;
    std::uint64_t m_most = 0; ///< bound of what is made or being made
    bool m_hasFailed = false;
    bool m_tellsFailure = false;
};

using AtlasForm = FilterForm<DisplayAtlas, AtlasUpdate, SurfaceAtlas>;

} // namespace trixel::render
