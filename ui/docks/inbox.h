// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>
#include <utility>
#include <vector>

namespace trixel::ui {

/// Things on their way from the thread that measures to the one that shows.
template <class T>
class Inbox
{
public:
    void put(const T& thing)
    {
        const std::scoped_lock lock(m_mutex);
        m_things.push_back(thing);
    }
    /// All that came since the last time, in their order.
    std::vector<T> take()
    {
        const std::scoped_lock lock(m_mutex);
        return std::exchange(m_things, {});
    }

private:
    std::mutex m_mutex;
    std::vector<T> m_things;
};

} // namespace trixel::ui
