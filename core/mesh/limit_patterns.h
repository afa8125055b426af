// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a face is cut into triangles, in its own (u,v).
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

namespace trixel {

/// Pieces along each edge, and along the sides of the triangles within; 1 to kMaxRate.
struct CutRates
{
    std::array<std::uint8_t, 3> edges{1, 1, 1};
    std::uint8_t inside = 1;

    bool operator==(const CutRates&) const = default;
};

inline constexpr int kMaxRate = 128;

/// First the points of the border, counter-clockwise from V0: with rates a, b, c, V1 is point a and
/// V2 is point a + b. Then the points within.
struct CutPattern
{
    std::vector<glm::dvec2> points;
    std::vector<std::array<std::uint16_t, 3>> triangles; ///< counter-clockwise
};

/// Makes each pattern once. Patterns stay where they are while the cutter lives.
class PatternCutter
{
public:
    const CutPattern& pattern(const CutRates& rates);

private:
    std::unordered_map<std::uint32_t, std::unique_ptr<CutPattern>> m_patterns;
};

} // namespace trixel
