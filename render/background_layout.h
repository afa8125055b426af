// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/texture/texel_store.h"

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

namespace trixel::render {

/// Makes the first filling of a layout (`DisplayAtlas`) on a thread of its own,
/// slice by slice; the window's thread sends slices to the card as they come, and has the layout
/// when all have been taken. Stops and waits for the slice at hand when it is destroyed, or for
/// what begins to see that it is to stop.
template <class Layout, class Update>
class BackgroundLayout
{
public:
    /// Begins a layout with a store. \return  false where it was to stop, or found no memory
    using Begin = std::function<bool(Layout&, const TexelStore&, const std::stop_token&)>;

    /// \param store  a snapshot
    BackgroundLayout(TexelStore store, Begin begin)
        : m_state(std::make_shared<State>())
        , m_thread([state = m_state, texels = std::move(store), begin = std::move(begin)](
                       const std::stop_token& stop) { run(*state, texels, begin, stop); })
    {
    }

    /// What is to be sent next, if there is any yet. The records it names may be read until the
    /// layout is taken; others may not.
    std::optional<Update> next()
    {
        const std::lock_guard lock(m_state->mutex);
        if (m_state->ready.empty()) {
            return std::nullopt;
        }
        Update update = std::move(m_state->ready.front());
        m_state->ready.pop_front();
        m_state->room.notify_one();
        return update;
    }
    const Layout& layout() const { return m_state->layout; }

    /// Whether all has been made and taken: then `take` gives the layout.
    bool isDone() const
    {
        const std::lock_guard lock(m_state->mutex);
        return m_state->done && m_state->ready.empty();
    }
    Layout take() { return std::move(m_state->layout); }
    /// Whether there was no memory for it: it will never be done.
    bool hasFailed() const
    {
        const std::lock_guard lock(m_state->mutex);
        return m_state->failed;
    }

private:
    static constexpr std::size_t kSliceBytes = 512U << 10U;
    static constexpr std::size_t kMostReady = 16; // slices

    struct State
    {
        mutable std::mutex mutex;
        std::condition_variable_any room;
        std::deque<Update> ready;
        bool done = false;
        bool failed = false;
        Layout layout;
    };

    static void
    run(State& state, const TexelStore& store, const Begin& begin, const std::stop_token& stop)
    {
        bool isWhole = false;
        try {
            isWhole = begin(state.layout, store, stop) && fill(state, store, stop);
        } catch (const std::bad_alloc&) {
            // Not whole is all there is to say of it.
        }
        const std::lock_guard lock(state.mutex);
        state.done = isWhole;
        state.failed = !isWhole && !stop.stop_requested();
    }

    /// \return  whether all has been made
    static bool fill(State& state, const TexelStore& store, const std::stop_token& stop)
    {
        while (state.layout.hasWork()) {
            if (stop.stop_requested()) {
                return false;
            }
            Update update = state.layout.take(store, kSliceBytes);
            std::unique_lock lock(state.mutex);
            state.room.wait(lock, stop, [&] { return state.ready.size() < kMostReady; });
            state.ready.push_back(std::move(update));
        }
        return true;
    }

    std::shared_ptr<State> m_state;
    std::jthread m_thread; // after what it works on
};

} // namespace trixel::render
