// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace trixel {

/// Sharpness from which an edge stays a crease for ever; below it the crease is rounded off after
/// so many refinement steps.
inline constexpr float kSharp = 10.0F;

/// An edge of the cage that subdivision does not round off.
struct Crease
{
    std::uint32_t from = 0;   ///< mesh vertex
    std::uint32_t to = 0;     ///< mesh vertex
    float sharpness = kSharp; ///< [0, kSharp]

    bool operator==(const Crease&) const = default;
};

} // namespace trixel
