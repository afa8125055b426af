// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/filter_layer.h"

#include <utility>

namespace trixel::render {

namespace {

class UntilStopped final : public Progress
{
public:
    explicit UntilStopped(const std::stop_token& stop)
        : m_stop(stop)
    {
    }
    bool report(double /*fraction*/) override { return !m_stop.stop_requested(); }

private:
    const std::stop_token& m_stop;
};

} // namespace

template <class Layout, class Update, class Card>
void FilterForm<Layout, Update, Card>::clear()
{
    m_making.reset();
    m_layout.reset();
    m_since.clear();
    m_madeIsOld = false;
    m_hasFailed = false;
    m_card.clear(0);
}

template <class Layout, class Update, class Card>
std::size_t FilterForm<Layout, Update, Card>::upload(const std::shared_ptr<const FilterMesh>& mesh,
                                                     const TexelStore& store,
                                                     const CardChannels& channels,
                                                     int mipDrop,
                                                     std::uint64_t most,
                                                     std::size_t byteBudget)
{
    if (m_layout) {
        if (!m_layout->hasWork()) {
            return 0;
        }
        const Update update = m_layout->take(store, byteBudget);
        m_card.upload(update, m_layout->records(), m_layout->format());
        return update.bytes.size();
    }
    if (m_madeIsOld) {
        clear();
    }
    if (m_hasFailed) {
        return 0;
    }
    if (!m_making) {
        m_card.clear(store.faceCount());
        m_channels = channels;
        m_most = most;
        m_making = std::make_unique<BackgroundLayout<Layout, Update>>(
            store,
            [mesh, channels, mipDrop, most](
                Layout& layout, const TexelStore& texels, const std::stop_token& stop) {
                UntilStopped progress(stop);
                layout.showChannels(channels);
                return layout.reset(mesh, texels, mipDrop, most, progress).has_value();
            });
    }
    std::size_t sent = 0;
    while (sent < byteBudget) {
        auto update = m_making->next();
        if (!update) {
            break;
        }
        m_card.begin(*update, m_making->layout().format());
        update->fresh = false;
        m_card.upload(*update, m_making->layout().records(), m_making->layout().format());
        sent += update->bytes.size();
    }
    if (m_making->hasFailed()) {
        clear();
        m_hasFailed = m_tellsFailure = true;
    } else if (m_making->isDone()) {
        m_layout.emplace(m_making->take());
        m_making.reset();
        touch(store, std::exchange(m_since, {}));
    }
    return sent;
}

template <class Layout, class Update, class Card>
void FilterForm<Layout, Update, Card>::touch(const TexelStore& store,
                                             std::span<const TouchedRect> rects)
{
    if (m_layout) {
        if (!m_layout->touch(store, rects)) {
            clear();
        }
    } else if (m_making) {
        m_since.insert(m_since.end(), rects.begin(), rects.end());
    }
}

template <class Layout, class Update, class Card>
void FilterForm<Layout, Update, Card>::touchAll()
{
    if (m_layout) {
        if (!m_layout->touchAll()) {
            clear();
        }
    } else if (m_making) {
        m_madeIsOld = true;
    }
}

template <class Layout, class Update, class Card>
void FilterForm<Layout, Update, Card>::showChannels(const CardChannels& channels)
{
    if (m_layout) {
        m_layout->showChannels(channels);
    } else if (m_making && channels != m_channels) {
        m_madeIsOld = true;
    }
}

template <class Layout, class Update, class Card>
void FilterForm<Layout, Update, Card>::setMost(std::uint64_t most)
{
    const bool takesMore = m_layout && most < m_most && bytes() > most;
    const bool couldBeFiner = m_layout && most > m_most && m_layout->isReduced();
    if (takesMore || couldBeFiner) {
        clear();
    } else if (m_making && most != m_most) {
        m_madeIsOld = true;
    }
}

template class FilterForm<DisplayAtlas, AtlasUpdate, SurfaceAtlas>;

} // namespace trixel::render
