// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/readout_text.h"

#include <QStringList>

#include "core/texture/texel_address.h"

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

QString neighbourLinks(const std::optional<TexelsAcross>& neighbour)
{
    if (!neighbour) {
        return QStringLiteral("border");
    }
    const auto link = [&](const TexelCoord& texel, const QString& text) {
        const auto address = QString::fromStdString(toText(TexelPlace{neighbour->face, texel}));
        return QString("<a href='%1'>%2</a>").arg(address, text.isEmpty() ? address : text);
    };
    if (neighbour->count == 1) {
        return link(neighbour->first, {});
    }
    // All are lower ones of one face: what is the same need not be read twice.
    const QString last = QString("%1,%2").arg(neighbour->last.i).arg(neighbour->last.j);
    return QString("%1 … %2 ×%3")
        .arg(link(neighbour->first, {}), link(neighbour->last, last))
        .arg(neighbour->count);
}

} // namespace trixel::ui
