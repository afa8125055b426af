// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/filter/footprint_clamps.h"
#include "core/texture/texel_format.h"
#include "ui/inspector/footprint_answers.h"
#include "ui/inspector/footprint_probe.h"

#include <array>
#include <optional>

namespace trixel::ui {

/// The numbers of a footprint, one a row.
enum class FootprintRow {
    Place,
    Jacobian,
    First,
    Second,
    Axes,
    Angle,
    Anisotropy,
    Condition,
    Level,
    Clamps,
    Method,
    MethodCost,
    Exact,
    ExactCost,
    Difference,
    Texels,
    Spread
};
inline constexpr std::size_t kFootprintRows = static_cast<std::size_t>(FootprintRow::Spread) + 1;

QString footprintRowName(FootprintRow row);
/// What the number means, for those who see it the first time.
QString footprintRowTip(FootprintRow row);

/// A text as long as the row's usually get, for the room that it needs.
QString footprintRowSample(FootprintRow row);

/// Everything a row's text may be made of; refers to it, for as long as texts are made.
struct FootprintFacts
{
    const ProbedFootprint& probed;
    const FootprintNet& net;
    const FootprintAnswer* answer = nullptr; ///< null where there is none
    QString noAnswer;                        ///< why there is none
    TexelType type{};
};

/// A short line, or more than one; "–" where there is nothing to say, "…" where it may come.
QString footprintRowText(FootprintRow row, const FootprintFacts& facts);

/// One sentence.
QString clampText(const FootprintClamp& clamp);

} // namespace trixel::ui
