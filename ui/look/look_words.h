// SPDX-License-Identifier: GPL-3.0-or-later
//
// Channels, looks and marks as people call them.
#pragma once

#include <QColor>
#include <QString>

#include "core/texture/value_histogram.h"
#include "render/look.h"

#include <vector>

namespace trixel::ui {

/// "Red", "Opacity", "Grey", "Channel 5"
QString channelName(const TexelFormat& format, std::uint16_t channel);
/// "R", "A", "5"
QString channelLetter(const TexelFormat& format, std::uint16_t channel);
/// The colour that a channel is drawn in over a dark ground.
QColor channelColor(const TexelFormat& format, std::uint16_t channel);

/// The number that a look shows, "Red" or "Luminance"; "Colour" where it shows more than one.
QString shownName(const TexelFormat& format, const render::Look& look);

/// What keeps a look from showing values as they are: "Exposure +2 · Red only". Empty for the
/// neutral look.
QString describe(const TexelFormat& format, const render::Look& look);

/// A value as it is written beside scales: up to five significant digits.
QString valueText(double value);
/// "+1.5"
QString stopsText(float stops);

/// "NaN", "Infinite", "Negative", "Clipped"
QString markName(render::Mark mark);
/// One sentence about a mark under a look.
QString markMeaning(render::Mark mark, const render::Look& look);

/// The channels that a look shows, or the luminance: what a histogram is drawn of.
std::vector<TexelNumber> numbersShown(const TexelFormat& format, const render::Look& look);
/// The channels that a look's marks are about.
std::vector<TexelNumber> numbersMarked(const TexelFormat& format, const render::Look& look);
QString numberName(const TexelFormat& format, const TexelNumber& number);

} // namespace trixel::ui
