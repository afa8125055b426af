// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ids.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace trixel {

/// Numbers by face, forgotten all at once. A hash table whose size follows what one query reaches,
/// not the mesh.
class FaceTable
{
public:
    static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

    FaceTable()
        : m_slots(64)
    {
    }

    void clear()
    {
        m_used = 0;
        if (++m_stamp == 0) {
            std::ranges::fill(m_slots, Slot{});
            m_stamp = 1;
        }
    }

    /// kNone where it has none.
    std::uint32_t find(FaceId face) const
    {
        const Slot& slot = m_slots[placeOf(face)];
        return slot.stamp == m_stamp ? slot.number : kNone;
    }

    /// The face's number, kNone where it had none: then it now has `fresh`.
    std::uint32_t findOrAdd(FaceId face, std::uint32_t fresh)
    {
        Slot& slot = m_slots[placeOf(face)];
        if (slot.stamp == m_stamp) {
            return slot.number;
        }
        slot = {m_stamp, face, fresh};
        if (2 * ++m_used > m_slots.size()) {
            grow();
        }
        return kNone;
    }

private:
    struct Slot
    {
        std::uint32_t stamp = 0;
        FaceId face{};
        std::uint32_t number = 0;
    };

    /// The face's slot, or the free one where it belongs.
    std::size_t placeOf(FaceId face) const
    {
        const std::size_t mask = m_slots.size() - 1; // a power of two
        std::size_t place = (indexOf(face) * 0x9E3779B97F4A7C15ULL >> 32U) & mask;
        while (m_slots[place].stamp == m_stamp && m_slots[place].face != face) {
            place = (place + 1) & mask;
        }
        return place;
    }

    void grow()
    {
        std::vector<Slot> before(2 * m_slots.size());
        before.swap(m_slots);
        for (const Slot& slot : before) {
            if (slot.stamp == m_stamp) {
                m_slots[placeOf(slot.face)] = slot;
            }
        }
    }

    std::vector<Slot> m_slots;
    std::uint32_t m_stamp = 0;
    std::size_t m_used = 0;
};

} // namespace trixel
