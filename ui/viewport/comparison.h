// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/filter_method.h"
#include "render/filtering.h"

namespace trixel::ui {

/// In what the part of a split view right of its line (B) differs from the one left of it (A).
enum class ComparedBy {
    Nothing,  ///< the view is not split
    Method,   ///< filtered by another method
    Level,    ///< shown some levels coarser
    Before,   ///< as the texels were before
    Filtering ///< filtered otherwise by the graphics card
};

/// A split view. A value: compared and copied.
struct Comparison
{
    ComparedBy by = ComparedBy::Nothing;
    MethodChoice method;                                       ///< of B, by Method
    render::Filtering filtering = render::Filtering::Seamless; ///< of B, by Filtering
    int levelsDropped = 1; ///< by B more than by A, by Level (>= 1)
    double split = 0.5;    ///< where the line stands, in parts of the view's width

    bool isOn() const { return by != ComparedBy::Nothing; }

    bool operator==(const Comparison&) const = default;
};

} // namespace trixel::ui
