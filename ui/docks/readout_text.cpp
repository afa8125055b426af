// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/readout_text.h"

#include <QStringList>

#include <algorithm>
#include <cmath>

namespace trixel::ui {

namespace {

constexpr std::size_t kValuesShown = 8;

QString number(double value, int digits)
{
    return QString::number(value, 'g', digits);
}

} // namespace

QString texelText(const TexelCoord& texel)
{
    return QString("(%1, %2) %3")
        .arg(texel.i)
        .arg(texel.j)
        .arg(texel.half == TexelHalf::Lower ? "lower" : "upper");
}

QString storageText(const HoveredTexel& texel)
{
    return QString("pixel %1, %2 · index %3")
        .arg(texel.pixel.x)
        .arg(texel.pixel.y)
        .arg(indexOf(texel.index));
}

QString barycentricText(glm::vec2 uv)
{
    const auto fixed = [](float value) {
        return QString::number(static_cast<double>(value), 'f', 5);
    };
    return QString("%1  %2  %3").arg(fixed(uv.x), fixed(uv.y), fixed(1.0F - uv.x - uv.y));
}

QString positionText(glm::vec3 position, float size)
{
    constexpr int kDigits = 5;
    constexpr int kMostDecimals = 6;
    const bool usual = size >= 0.01F && size < 1e6F;
    const int decimals =
        usual
            ? std::clamp(kDigits - static_cast<int>(std::floor(std::log10(size))), 0, kMostDecimals)
            : 0;
    const double half = 0.5 * std::pow(10.0, -decimals);
    QStringList words;
    for (int k = 0; k < 3; ++k) {
        const auto value = static_cast<double>(position[k]);
        words += usual ? QString::number(std::abs(value) < half ? 0.0 : value, 'f', decimals)
                       : number(value, 3);
    }
    return words.join("  ");
}

QString vectorText(glm::dvec2 vector)
{
    return QString("%1, %2").arg(number(vector.x, 5), number(vector.y, 5));
}

QString ellipseText(const FootprintEllipse& ellipse)
{
    return QString("%1 × %2  (%3 : 1)")
        .arg(number(ellipse.majorLength, 3),
             number(ellipse.minorLength, 3),
             number(ellipse.anisotropy(), 3));
}

QString widthText(const EllipseReport& report)
{
    return QString("%1 texels · level %2")
        .arg(number(report.width, 3))
        .arg(report.level, 0, 'f', 2);
}

QString readAtText(const FilteredTexel& texel)
{
    return texel.taps == kRefusedTaps
               ? QString("–")
               : QString("level %1 · %2 taps").arg(texel.level, 0, 'f', 2).arg(texel.taps);
}

QString filteredText(TexelType type, std::span<const float> values)
{
    const bool whole = type == TexelType::UInt8 || type == TexelType::UInt16;
    const double top = type == TexelType::UInt8 ? 255.0 : 65535.0;
    QStringList words;
    for (const float value : values.first(std::min(values.size(), kValuesShown))) {
        const auto stored = static_cast<double>(value);
        words += whole ? QString::number(stored * top, 'f', 2) : number(stored, 6);
    }
    if (values.size() > kValuesShown) {
        words += QString("… (%1 channels)").arg(values.size());
    }
    return words.join("  ");
}

QString storedText(TexelType type, std::span<const float> values)
{
    const bool whole = type == TexelType::UInt8 || type == TexelType::UInt16;
    const double top = type == TexelType::UInt8 ? 255.0 : 65535.0;
    QStringList words;
    for (const float value : values.first(std::min(values.size(), kValuesShown))) {
        const auto stored = static_cast<double>(value);
        words += whole ? QString::number(std::lround(stored * top)) : number(stored, 7);
    }
    if (values.size() > kValuesShown) {
        words += QString("… (%1 channels)").arg(values.size());
    }
    return words.join("  ");
}

QColor shownColor(std::span<const float> values)
{
    if (values.empty()) {
        return {};
    }
    const auto channel = [values](std::size_t k) {
        const float value = values[std::min(k, values.size() - 1)];
        return value >= 0.0F ? std::min(value, 1.0F) : 0.0F; // NaN becomes 0
    };
    if (values.size() < 3) {
        return QColor::fromRgbF(channel(0), channel(0), channel(0));
    }
    return QColor::fromRgbF(channel(0), channel(1), channel(2), values.size() > 3 ? channel(3) : 1);
}

QString shownText(const QColor& color)
{
    return QString("%1 · %2 %3 %4")
        .arg(color.name())
        .arg(color.red())
        .arg(color.green())
        .arg(color.blue());
}

} // namespace trixel::ui
