// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/quantity.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace trixel::ui {

namespace {

struct Step
{
    double from; ///< values from here on take this unit
    const char* unit;
};

constexpr Step kTimes[] = {{1e9, "s"}, {1e6, "ms"}, {1e3, "µs"}, {1, "ns"}};
constexpr Step kSizes[] = {{1e9, "GB"}, {1e6, "MB"}, {1e3, "kB"}, {1, "B"}};

constexpr QChar kHardSpace(0x00A0);

/// Between these a number is written out, beyond them with a power of ten.
constexpr double kLeastPlain = 1e-4;
constexpr double kMostPlain = 1e6;

QString raised(int exponent)
{
    static const QString kDigits = QString::fromUtf8("⁰¹²³⁴⁵⁶⁷⁸⁹");
    QString text = exponent < 0 ? QString(QChar(0x207B)) : QString();
    for (const QChar digit : QString::number(std::abs(exponent))) {
        text += kDigits[digit.digitValue()];
    }
    return text;
}

QString withoutTrailingZeros(QString text)
{
    if (text.contains('.')) {
        while (text.endsWith('0')) {
            text.chop(1);
        }
        if (text.endsWith('.')) {
            text.chop(1);
        }
    }
    return text;
}

/// The nearest number of so many significant digits.
double rounded(double value, int digits)
{
    return QString::number(value, 'g', digits).toDouble();
}

QString numberText(double value, int digits)
{
    const double shown = rounded(value, digits);
    if (shown == 0) {
        return "0";
    }
    const int exponent = static_cast<int>(std::floor(std::log10(std::abs(shown)) + 1e-9));
    if (std::abs(shown) >= kLeastPlain && std::abs(shown) < kMostPlain) {
        return withoutTrailingZeros(
            QString::number(shown, 'f', std::max(0, digits - 1 - exponent)));
    }
    const QString power = "10" + raised(exponent);
    const QString mantissa =
        withoutTrailingZeros(QString::number(shown / std::pow(10, exponent), 'f', digits - 1));
    return mantissa == "1" ? power : mantissa + QChar(0x00B7) + power;
}

QString stepText(double value, int digits, std::span<const Step> steps)
{
    // Rounded first, so that 999.9 ns is 1 µs and not 1000 ns.
    const double shown = rounded(value, digits);
    const auto found =
        std::ranges::find_if(steps, [&](const Step& step) { return std::abs(shown) >= step.from; });
    const Step& step = found != steps.end() ? *found : steps.back();
    return numberText(shown / step.from, digits) + kHardSpace + QString::fromUtf8(step.unit);
}

} // namespace

Quantity quantityOf(std::string_view unit)
{
    if (unit == "ns") {
        return Quantity::Nanoseconds;
    }
    return unit == "bytes" || unit == "B" ? Quantity::Bytes : Quantity::Number;
}

QString quantityText(double value, Quantity quantity, int digits)
{
    if (!std::isfinite(value)) {
        return QString(QChar(0x2013));
    }
    switch (quantity) {
    case Quantity::Nanoseconds:
        return stepText(value, digits, kTimes);
    case Quantity::Bytes:
        return stepText(value, digits, kSizes);
    case Quantity::Fraction:
        return numberText(value * 100, digits) + kHardSpace + '%';
    case Quantity::Number:
        break;
    }
    return numberText(value, digits);
}

} // namespace trixel::ui
