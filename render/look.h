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
    /// One channel alone, as grey; nothing, or one that the format lacks: all as a colour.
    std::optional<std::uint16_t> channel;
    float exposure = 0; ///< stops: values count 2^exposure times, before the range
    float low = 0;      ///< what is shown black
    float high = 1;     ///< what is shown white; other than `low`
    /// Without a chosen channel: the luminance of the first three instead of their colour.
    bool luminance = false;
    bool falseColor = false; ///< the number in the colours of `mapColor`; of a colour its luminance
    bool marks = false;      ///< values that no colour can show stand out, see `Mark`
    bool opaque = false;     ///< as if there were no opacity channel

    /// The values shown black and white, exposure counted in.
    float blackValue() const;
    float whiteValue() const;

    bool operator==(const Look&) const = default;
};

/// What is wrong with a texel under a look, in its worst channel of those shown; worse ones are
/// greater.
enum class Mark : std::uint8_t {
    None,
    Clipped,   ///< above the range; for opacity above 1
    Negative,  ///< below zero, whatever the range
    Infinite,  ///< of either sign
    NotANumber ///< NaN
};

inline constexpr std::array<Mark, 4> kMarks{
    Mark::NotANumber, Mark::Infinite, Mark::Negative, Mark::Clipped};

/// The colours that a mark fills a texel with, for every kind of eye. Marks also differ by the
/// pattern that their ink draws: see `hasInk`.
Rgba markColor(Mark mark);
inline constexpr Rgba kMarkInk{0, 0, 0, 255};

/// Whether a pixel of a marked texel has the pattern's ink instead of the mark's colour: a checker,
/// level stripes, stripes that fall and stripes that rise to the right.
/// \param x, y  from the upper left, in pixels of 1/96 inch
bool hasInk(Mark mark, int x, int y);

/// What a look means for texels of one format, ready for use on processor and graphics card.
struct LookRule
{
    enum class Kind {
        Colors,    ///< the first three channels, of one or two the first three times
        Grey,      ///< a number
        FalseColor ///< a number
    };
    static constexpr int kLuminance = -1;

    static LookRule of(const TexelFormat& format, const Look& look);

    Kind kind = Kind::Colors;
    int number = 0;   ///< the channel that is the number, or kLuminance; not for Colors
    int opacity = -1; ///< the channel that is opacity; none where all is opaque
    float black = 0;  ///< a value is shown at (value - black) · scale, in [0, 1]
    float scale = 1;
    float most = 1; ///< larger values are clipped
    bool marks = false;

    bool operator==(const LookRule&) const = default;
};

/// Luminance of red, green and blue as they are stored. Source: ITU-R BT.709.
inline constexpr std::array<float, 3> kLuminanceWeights{0.2126F, 0.7152F, 0.0722F};
inline float luminance(float red, float green, float blue)
{
    return kLuminanceWeights[0] * red + kLuminanceWeights[1] * green + kLuminanceWeights[2] * blue;
}

/// The worst mark that a texel deserves, whether the look shows marks or not.
/// \param values  one a channel of the format (checked)
Mark markOf(const TexelFormat& format, std::span<const float> values, const Look& look);

/// Whether any channel shown deserves a mark, whatever worse ones it deserves.
/// \param values  one a channel of the format that the rule was made for
bool deserves(const LookRule& rule, std::span<const float> values, Mark mark);

/// The number that a rule shows of a texel; of colours their luminance, of one or two channels the
/// first.
float numberOf(const LookRule& rule, std::span<const float> values);

/// Screen colour of a texel: one or two channels as grey, of more the first three; with the
/// format's opacity, but where one number is shown. NaN is black without marks, and of no colour of
/// the scale in false colour. For many texels make a `TexelShader`.
/// \param values  one a channel of the format (checked)
Rgba shade(const TexelFormat& format, std::span<const float> values, const Look& look);
/// The same by the rule made from format and look.
Rgba shade(const LookRule& rule, std::span<const float> values);

} // namespace trixel::render
