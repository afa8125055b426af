// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/texture/texel_format.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace trixel::render {

using Rgba = std::array<std::uint8_t, 4>;

/// How texel values are looked at: which become what colours. A value: compared, copied, stored in
/// settings.
struct Look
{
    /// One channel alone, as grey; nothing: all as a colour.
    std::optional<std::uint16_t> channel;
    float exposure = 0; ///< stops: values count 2^exposure times, before the range
    float low = 0;      ///< what is shown black
    float high = 1;     ///< what is shown white; other than `low`

    bool operator==(const Look&) const = default;
};

/// Screen colour of a texel: one or two channels as grey, of more the first three; opaque, but for
/// the format's opacity channel. NaN is shown as 0.
/// \param values  one a channel of the format (checked)
Rgba shade(const TexelFormat& format, std::span<const float> values, const Look& look);

} // namespace trixel::render
