// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRgb>

#include "core/texture/mip_comparison.h"

#include <cstdint>
#include <optional>
#include <span>

namespace trixel::ui {

/// Colour of a signed number on a scale from -1 (blue) over 0 (near white) to 1 (vermilion): its
/// size by lightness, its sign by a pair of hues that every kind of eye tells apart. Beyond the
/// ends it gets theirs; no number is dark grey.
QRgb differenceColor(double position);

/// What the box made of a texel less what is right: of the chosen channel, else of that which
/// differs most.
double signedDifference(std::span<const float> right,
                        std::span<const float> box,
                        std::optional<std::uint16_t> channel);

/// The format of what `differenceTexels` gives.
inline constexpr TexelFormat kDifferenceFormat{TexelType::UInt8, 3, std::nullopt};

/// Colours of the differences at a level as drawn (`MipComparison::drawn`).
/// \param range  of the scale's ends; above 0 unless nothing differs
FaceTexels differenceTexels(const MipComparison& levels,
                            Level level,
                            std::optional<std::uint16_t> channel,
                            double range);

} // namespace trixel::ui
