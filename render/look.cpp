// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/look.h"

#include "core/base/check.h"
#include "render/color_map.h"

#include <algorithm>
#include <cmath>

namespace trixel::render {

namespace {

std::uint8_t toByte(float position)
{
    const float inside = position > 0.0F ? std::min(position, 1.0F) : 0.0F; // NaN becomes 0
    return static_cast<std::uint8_t>(inside * 255.0F + 0.5F);
}

Mark markOf(float value, float most)
{
    if (std::isnan(value)) {
        return Mark::NotANumber;
    }
    if (std::isinf(value)) {
        return Mark::Infinite;
    }
    return value < 0 ? Mark::Negative : value > most ? Mark::Clipped : Mark::None;
}

std::size_t colorsOf(std::size_t channels)
{
    return channels < 3 ? 1 : 3;
}

} // namespace

float Look::blackValue() const
{
    return low / std::exp2(exposure);
}

float Look::whiteValue() const
{
    return high / std::exp2(exposure);
}

Rgba markColor(Mark mark)
{
    switch (mark) {
    case Mark::NotANumber:
        return {kNoNumber[0], kNoNumber[1], kNoNumber[2], 255};
    case Mark::Infinite:
        return {255, 255, 255, 255};
    case Mark::Negative:
        return {86, 180, 233, 255};
    case Mark::Clipped:
        return {222, 96, 0, 255};
    case Mark::None:
        break;
    }
    return {0, 0, 0, 0};
}

bool hasInk(Mark mark, int x, int y)
{
    constexpr int kPeriod = 8;
    constexpr int kWidth = 3;
    const auto within = [](int along) { return ((along % kPeriod) + kPeriod) % kPeriod < kWidth; };
    switch (mark) {
    case Mark::NotANumber:
        return (((x >> 2) + (y >> 2)) & 1) != 0;
    case Mark::Infinite:
        return within(y);
    case Mark::Negative:
        return within(x - y);
    case Mark::Clipped:
        return within(x + y);
    case Mark::None:
        break;
    }
    return false;
}

LookRule LookRule::of(const TexelFormat& format, const Look& look)
{
    check(look.low != look.high, "a range of some width");
    LookRule rule;
    const bool isIsolated = look.channel && *look.channel < format.channels;
    if (isIsolated || look.luminance || look.falseColor) {
        rule.kind = look.falseColor ? Kind::FalseColor : Kind::Grey;
        rule.number = isIsolated ? *look.channel : format.channels < 3 ? 0 : kLuminance;
    } else if (format.alpha && !look.opaque) {
        rule.opacity = *format.alpha;
    }
    const float black = look.blackValue();
    const float white = look.whiteValue();
    rule.black = black;
    rule.scale = 1.0F / (white - black);
    rule.most = std::max(black, white);
    rule.marks = look.marks;
    return rule;
}

namespace {

/// Calls take(value, most) for each value that marks are about.
template <class Take>
void forMarkedValues(const LookRule& rule, std::span<const float> values, Take take)
{
    if (rule.kind != LookRule::Kind::Colors && rule.number != LookRule::kLuminance) {
        take(values[static_cast<std::size_t>(rule.number)], rule.most);
        return;
    }
    for (std::size_t c = 0; c < colorsOf(values.size()); ++c) {
        take(values[c], rule.most);
    }
    if (rule.opacity >= 0) {
        take(values[static_cast<std::size_t>(rule.opacity)], 1.0F);
    }
}

Mark markOf(const LookRule& rule, std::span<const float> values)
{
    Mark worst = Mark::None;
    forMarkedValues(rule, values, [&](float value, float most) {
        worst = std::max(worst, markOf(value, most));
    });
    return worst;
}

} // namespace

bool deserves(const LookRule& rule, std::span<const float> values, Mark mark)
{
    bool does = false;
    forMarkedValues(
        rule, values, [&](float value, float most) { does = does || markOf(value, most) == mark; });
    return does;
}

float numberOf(const LookRule& rule, std::span<const float> values)
{
    const bool isSum = rule.kind == LookRule::Kind::Colors ? values.size() >= 3
                                                           : rule.number == LookRule::kLuminance;
    return isSum ? luminance(values[0], values[1], values[2])
                 : values[rule.kind == LookRule::Kind::Colors
                              ? 0
                              : static_cast<std::size_t>(rule.number)];
}

Mark markOf(const TexelFormat& format, std::span<const float> values, const Look& look)
{
    check(values.size() == format.channels, "a value a channel");
    return markOf(LookRule::of(format, look), values);
}

Rgba shade(const LookRule& rule, std::span<const float> values)
{
    if (rule.marks) {
        if (const Mark mark = markOf(rule, values); mark != Mark::None) {
            return markColor(mark);
        }
    }
    const auto position = [&](float value) { return (value - rule.black) * rule.scale; };
    if (rule.kind == LookRule::Kind::Colors) {
        const std::size_t second = values.size() < 3 ? 0 : 1;
        const std::uint8_t opacity = rule.opacity < 0
                                         ? std::uint8_t{255}
                                         : toByte(values[static_cast<std::size_t>(rule.opacity)]);
        return {toByte(position(values[0])),
                toByte(position(values[second])),
                toByte(position(values[2 * second])),
                opacity};
    }
    const float number = numberOf(rule, values);
    if (rule.kind == LookRule::Kind::Grey) {
        const std::uint8_t grey = toByte(position(number));
        return {grey, grey, grey, 255};
    }
    const Rgb color = mapColor(static_cast<double>(position(number)));
    return {color[0], color[1], color[2], 255};
}

Rgba shade(const TexelFormat& format, std::span<const float> values, const Look& look)
{
    check(values.size() == format.channels, "a value a channel");
    return shade(LookRule::of(format, look), values);
}

} // namespace trixel::render
