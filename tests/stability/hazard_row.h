// SPDX-License-Identifier: GPL-3.0-or-later
//
// What all rows of the table of hazards have in common.
#pragma once

#include "core/study/stability/stability.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace trixel::test {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInf = std::numeric_limits<double>::infinity();

/// The sweep of the study: every form that is not naive keeps the bound at every value, and the
/// textbook's leaves it somewhere (else the sweep would show nothing).
inline void expectKept(std::string_view name)
{
    const StabilitySweep sweep = runSweep(name);
    ASSERT_FALSE(sweep.values.empty());
    std::size_t bounded = 0;
    for (const StabilityCurve& curve : sweep.curves) {
        ASSERT_EQ(curve.errors.size(), sweep.values.size());
        if (curve.naive) {
            continue;
        }
        ++bounded;
        for (std::size_t k = 0; k < sweep.values.size(); ++k) {
            EXPECT_LE(curve.errors[k], sweep.bound)
                << curve.form << " at " << sweep.axisTitle << " = " << sweep.values[k].label;
        }
    }
    EXPECT_GT(bounded, 0U);
    EXPECT_GT(sweep.naiveFailures(), 0U);
}

/// Numbers for trials beyond the values of the sweep.
struct Random
{
    explicit Random(std::uint32_t seed)
        : engine(seed)
    {
    }
    double in(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(engine);
    }
    /// 10 to the power of a number in between, either sign.
    double ofAnySize(double low, double high)
    {
        return std::copysign(std::pow(10, in(low, high)), in(-1, 1));
    }
    std::mt19937 engine;
};

} // namespace trixel::test
