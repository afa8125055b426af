// SPDX-License-Identifier: GPL-3.0-or-later
//
// For methods that answer one query at a time: what surrounds the answer is the same for all.
#pragma once

#include "core/filter/filter_method.h"
#include "core/filter/query_ellipse.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <utility>

namespace trixel {

/// Four channels of one answer.
using GroupValue = std::array<float, kGroupChannels>;

/// What a query cost and where it read.
struct QueryCost
{
    float level = 0;
    std::uint32_t taps = 0;
};

/// Puts the channels that exist into the results.
inline void storeAnswer(const FilterResults& results,
                        std::size_t query,
                        int group,
                        int channels,
                        const GroupValue& value)
{
    const int first = group * kGroupChannels;
    for (int c = first; c < std::min(first + kGroupChannels, channels); ++c) {
        results.values[static_cast<std::size_t>(c) * results.stride + query] =
            value[static_cast<std::size_t>(c - first)];
    }
}

inline void storeCost(const FilterResults& results, std::size_t query, const QueryCost& cost)
{
    if (!results.levels.empty()) {
        results.levels[query] = cost.level;
    }
    if (!results.taps.empty()) {
        results.taps[query] = cost.taps;
    }
}

/// That there is room for the answers.
inline void
checkRoom(const FilterScene& scene, const FilterQueries& queries, const FilterResults& results)
{
    check(results.values.size() >=
              static_cast<std::size_t>(scene.channels() - 1) * results.stride + queries.size(),
          "room for every value");
}

/// Calls answer(ellipse, face, group, value) → QueryCost for every query with a finite centre and
/// every group of four channels; the others get their face's average. A refused query (taps ==
/// kRefusedTaps) gets the average too.
template <class Answer>
void filterEach(const FilterScene& scene,
                const FilterQueries& queries,
                const FilterResults& results,
                const Answer& answer)
{
    checkRoom(scene, queries, results);
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
            storeAnswer(results, i, group, scene.channels(), value);
        }
        storeCost(results, i, cost);
    }
}

/// A method that is nothing but such an answer.
/// \param answer  (scene, ellipse, face, group, value) → QueryCost; no state that a call changes
template <class Answer>
std::unique_ptr<const FilterMethod> perQueryMethod(Answer answer)
{
    class PerQuery final : public FilterMethod
    {
    public:
        explicit PerQuery(Answer one)
            : m_answer(std::move(one))
        {
        }

        void filter(const FilterScene& scene,
                    const FilterQueries& queries,
                    const FilterResults& results) const override
        {
            filterEach(scene,
                       queries,
                       results,
                       [&](const QueryEllipse& ellipse, FaceId face, int group, GroupValue& value) {
                           return m_answer(scene, ellipse, face, group, value);
                       });
        }

    private:
        Answer m_answer;
    };
    return std::make_unique<PerQuery>(std::move(answer));
}

} // namespace trixel
