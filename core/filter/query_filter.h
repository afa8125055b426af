// SPDX-License-Identifier: GPL-3.0-or-later
//
// For methods that answer one query at a time: what surrounds the answer is the same for all.
#pragma once

#include "core/filter/filter_method.h"
#include "core/filter/query_ellipse.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace trixel {

/// Four channels of one answer.
using GroupValue = std::array<float, kGroupChannels>;

/// What a query cost and where it read.
struct QueryCost
{
    float level = 0;
    std::uint32_t taps = 0;
};

/// Calls answer(ellipse, face, group, value) → QueryCost for every query with a finite centre and
/// every group of four channels; the others get their face's average. A refused query (taps ==
/// kRefusedTaps) gets the average too.
template <class Answer>
void filterEach(const FilterScene& scene,
                const FilterQueries& queries,
                const FilterResults& results,
                const Answer& answer)
{
    const int channels = scene.channels();
    check(results.values.size() >=
              static_cast<std::size_t>(channels - 1) * results.stride + queries.size(),
          "room for every value");
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const QueryEllipse ellipse = queryEllipse(scene, queries, i);
        const FaceId face = queries.face[i];
        QueryCost cost;
        for (int group = 0; group < scene.mips().groups(); ++group) {
            GroupValue value{};
            if (ellipse.hasCentre) {
                cost = answer(ellipse, face, group, value);
            } else {
                cost = {0, 1};
            }
            if (!ellipse.hasCentre || cost.taps == kRefusedTaps) {
                std::copy_n(scene.mips().average(face, group), kGroupChannels, value.begin());
            }
            const int first = group * kGroupChannels;
            for (int c = first; c < std::min(first + kGroupChannels, channels); ++c) {
                results.values[static_cast<std::size_t>(c) * results.stride + i] =
                    value[static_cast<std::size_t>(c - first)];
            }
        }
        if (!results.levels.empty()) {
            results.levels[i] = cost.level;
        }
        if (!results.taps.empty()) {
            results.taps[i] = cost.taps;
        }
    }
}

} // namespace trixel
