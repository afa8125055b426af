// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Qt>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace trixel::ui {

/// Sorts numbers of rows by what `key` gives for each; equal ones by number, in either order.
template <class Key>
void sortRows(std::vector<std::uint32_t>& rows, Qt::SortOrder order, const Key& key)
{
    std::ranges::sort(rows, [&](std::uint32_t a, std::uint32_t b) {
        const auto first = key(a);
        const auto second = key(b);
        if (first != second) {
            return order == Qt::AscendingOrder ? first < second : second < first;
        }
        return a < b;
    });
}

} // namespace trixel::ui
