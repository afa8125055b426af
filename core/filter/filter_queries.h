// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ids.h"

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace trixel {

/// N footprints to filter, structure of arrays, all spans of one length. Every bit pattern of the
/// floats is allowed; faces exist.
struct FilterQueries
{
    std::span<const FaceId> face;
    std::span<const float> u, v;     ///< centre
    std::span<const float> uw1, vw1; ///< W1, in (u,v) of the face
    std::span<const float> uw2, vw2; ///< W2

    std::size_t size() const { return face.size(); }
    FilterQueries subspan(std::size_t begin, std::size_t count) const
    {
        return {face.subspan(begin, count),
                u.subspan(begin, count),
                v.subspan(begin, count),
                uw1.subspan(begin, count),
                vw1.subspan(begin, count),
                uw2.subspan(begin, count),
                vw2.subspan(begin, count)};
    }
};

/// Taps of a query that was refused because it would need more than its method's cap; the value is
/// then the face's average.
inline constexpr std::uint32_t kRefusedTaps = 0xFFFFFFFFU;

/// Room for the answers.
struct FilterResults
{
    /// Channel c of query i at c * stride + i; channels of the scene (checked).
    std::span<float> values;
    std::size_t stride = 0;
    /// Level that was read, 0 the face's coarsest; the finer of two. Empty, or one a query.
    std::span<float> levels;
    /// Texels or vertices read. Empty, or one a query.
    std::span<std::uint32_t> taps;
};

/// Queries that own their arrays.
struct QueryArrays
{
    std::vector<FaceId> face;
    std::vector<float> u, v, uw1, vw1, uw2, vw2;

    std::size_t size() const { return face.size(); }
    void add(FaceId f, glm::vec2 uv, glm::vec2 w1, glm::vec2 w2)
    {
        face.push_back(f);
        u.push_back(uv.x);
        v.push_back(uv.y);
        uw1.push_back(w1.x);
        vw1.push_back(w1.y);
        uw2.push_back(w2.x);
        vw2.push_back(w2.y);
    }
    FilterQueries queries() const { return {face, u, v, uw1, vw1, uw2, vw2}; }
};

/// Results that own their arrays.
struct ResultArrays
{
    ResultArrays(std::size_t count, int channels)
        : values(count * static_cast<std::size_t>(channels))
        , levels(count)
        , taps(count)
    {
    }

    std::vector<float> values;
    std::vector<float> levels;
    std::vector<std::uint32_t> taps;

    FilterResults results() { return {values, levels.size(), levels, taps}; }
};

} // namespace trixel
