// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace trixel {

/// Sharpness from which an edge or a vertex stays sharp for ever; below it, it is rounded off after
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

/// A vertex of the cage that subdivision leaves where it is.
struct SharpVertex
{
    std::uint32_t vertex = 0;
    float sharpness = kSharp; ///< [0, kSharp]

    bool operator==(const SharpVertex&) const = default;
};

/// What subdivision of a cage does not round off, beside its borders.
struct Sharpness
{
    std::vector<Crease> creases;
    std::vector<SharpVertex> vertices;

    bool isEmpty() const { return creases.empty() && vertices.empty(); }
    bool operator==(const Sharpness&) const = default;
};

/// Degrees in [0, 180]: edges folded by more are creases. None: an angle makes no crease.
using CreaseAngle = std::optional<float>;

} // namespace trixel
