// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/look_words.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>

namespace trixel::ui {

namespace {

QString tr(const char* text)
{
    return QCoreApplication::translate("Look", text);
}

bool isIsolated(const TexelFormat& format, const render::Look& look)
{
    return look.channel && *look.channel < format.channels;
}

constexpr QColor kGrey(0xc8, 0xc8, 0xcc);

} // namespace

QString channelName(const TexelFormat& format, std::uint16_t channel)
{
    if (format.alpha == channel) {
        return tr("Opacity");
    }
    if (format.channels < 3 && channel == 0) {
        return tr("Grey");
    }
    if (format.channels >= 3 && channel < 3) {
        return channel == 0 ? tr("Red") : channel == 1 ? tr("Green") : tr("Blue");
    }
    return tr("Channel %1").arg(channel);
}

QString channelLetter(const TexelFormat& format, std::uint16_t channel)
{
    if (format.alpha == channel) {
        return tr("A");
    }
    if (format.channels < 3 && channel == 0) {
        return tr("Grey");
    }
    if (format.channels >= 3 && channel < 3) {
        return channel == 0 ? tr("R") : channel == 1 ? tr("G") : tr("B");
    }
    return QString::number(channel);
}

QColor channelColor(const TexelFormat& format, std::uint16_t channel)
{
    constexpr QColor kColors[] = {
        QColor(0xe8, 0x4c, 0x3d), QColor(0x35, 0xb3, 0x6b), QColor(0x42, 0x86, 0xf4)};
    const bool isColor = format.channels >= 3 && channel < 3 && format.alpha != channel;
    return isColor ? kColors[channel] : kGrey;
}

QString shownName(const TexelFormat& format, const render::Look& look)
{
    const render::LookRule rule = render::LookRule::of(format, look);
    if (rule.kind == render::LookRule::Kind::Colors) {
        return format.channels < 3 ? channelName(format, 0) : tr("Colour");
    }
    return rule.number == render::LookRule::kLuminance
               ? tr("Luminance")
               : channelName(format, static_cast<std::uint16_t>(rule.number));
}

QString describe(const TexelFormat& format, const render::Look& look)
{
    QStringList words;
    if (isIsolated(format, look)) {
        words += tr("%1 only").arg(channelName(format, *look.channel));
    } else if (look.luminance && format.channels >= 3) {
        words += tr("Luminance only");
    }
    if (look.exposure != 0) {
        words += tr("Exposure %1").arg(stopsText(look.exposure));
    }
    if (look.low != 0 || look.high != 1) {
        words += tr("Range %1 to %2").arg(valueText(look.low), valueText(look.high));
    }
    if (look.falseColor) {
        words += tr("False colour");
    }
    if (look.opaque && format.alpha) {
        words += tr("Without opacity");
    }
    if (look.marks) {
        words += tr("Marks");
    }
    return words.join(" · ");
}

QString valueText(double value)
{
    return QString::number(value, 'g', 5);
}

QString stopsText(float stops)
{
    const QString number = QString::number(static_cast<double>(stops), 'g', 4);
    return stops > 0 ? "+" + number : QString(number).replace('-', "−");
}

QString markName(render::Mark mark)
{
    switch (mark) {
    case render::Mark::NotANumber:
        return tr("NaN");
    case render::Mark::Infinite:
        return tr("Infinite");
    case render::Mark::Negative:
        return tr("Negative");
    case render::Mark::Clipped:
        return tr("Clipped");
    case render::Mark::None:
        break;
    }
    return {};
}

QString markMeaning(render::Mark mark, const render::Look& look)
{
    switch (mark) {
    case render::Mark::NotANumber:
        return tr("The outcome of 0/0 and its like: no number at all");
    case render::Mark::Infinite:
        return tr("Infinite values, of either sign");
    case render::Mark::Negative:
        return tr("Values below 0");
    case render::Mark::Clipped:
        return tr("Values above the range, that is above %1")
            .arg(valueText(double{std::max(look.blackValue(), look.whiteValue())}));
    case render::Mark::None:
        break;
    }
    return {};
}

namespace {

std::vector<TexelNumber> colors(const TexelFormat& format, const render::LookRule& rule)
{
    std::vector<TexelNumber> numbers;
    for (std::uint16_t c = 0; c < (format.channels < 3 ? 1 : 3); ++c) {
        numbers.push_back({c, {}});
    }
    if (rule.opacity >= 0) {
        numbers.push_back({static_cast<std::uint16_t>(rule.opacity), {}});
    }
    return numbers;
}

} // namespace

std::vector<TexelNumber> numbersShown(const TexelFormat& format, const render::Look& look)
{
    const render::LookRule rule = render::LookRule::of(format, look);
    if (rule.kind == render::LookRule::Kind::Colors) {
        return colors(format, rule);
    }
    if (rule.number == render::LookRule::kLuminance) {
        return {{0, render::kLuminanceWeights}};
    }
    return {{static_cast<std::uint16_t>(rule.number), {}}};
}

std::vector<TexelNumber> numbersMarked(const TexelFormat& format, const render::Look& look)
{
    const render::LookRule rule = render::LookRule::of(format, look);
    const bool isLuminance =
        rule.kind != render::LookRule::Kind::Colors && rule.number == render::LookRule::kLuminance;
    return isLuminance ? colors(format, rule) : numbersShown(format, look);
}

QString numberName(const TexelFormat& format, const TexelNumber& number)
{
    return number.weights ? tr("Luminance") : channelName(format, number.channel);
}

} // namespace trixel::ui
