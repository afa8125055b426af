// SPDX-License-Identifier: GPL-3.0-or-later
//
// Truth for the sweeps: long double, from the numbers as they are rounded to double.
#pragma once

#include "core/footprint/footprint.h"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace trixel::sweeps {

using LongVec2 = glm::vec<2, long double>;
using LongVec3 = glm::vec<3, long double>;

/// Exact for numbers that were double, but for its own rounding.
inline long double cross(const LongVec2& a, const LongVec2& b)
{
    const long double product = a.y * b.x;
    return std::fma(a.x, b.y, -product) + std::fma(-a.y, b.x, product);
}

inline LongVec3 cross(const LongVec3& a, const LongVec3& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline long double dot(const LongVec3& a, const LongVec3& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Singular values of the matrix with columns a, b.
struct LongLengths
{
    long double major = 0;
    long double minor = 0;

    LongLengths(const LongVec2& a, const LongVec2& b)
    {
        const long double p = (a.x + b.y) / 2;
        const long double q = (a.x - b.y) / 2;
        const long double r = (a.y - b.x) / 2;
        const long double s = (a.y + b.x) / 2;
        major = std::hypot(p, r) + std::hypot(q, s);
        minor = major > 0 ? std::abs(cross(a, b)) / major : 0;
    }
};

inline LongLengths lengthsOf(const Footprint& f)
{
    return {LongVec2(f.w1), LongVec2(f.w2)};
}

} // namespace trixel::sweeps
