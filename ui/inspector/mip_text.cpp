// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/mip_text.h"

#include <QCoreApplication>
#include <QStringList>

#include "ui/charts/quantity.h"
#include "ui/dialogs/format_choice.h"
#include "ui/inspector/mip_focus.h"

#include <algorithm>
#include <cmath>

namespace trixel::ui {

namespace {

QString tr(const char* text)
{
    return QCoreApplication::translate("MipPanel", text);
}

QString withSign(const QString& number, double value)
{
    return value > 0 ? "+" + number : number;
}

constexpr std::size_t kValuesShown = 8;

} // namespace

QString levelText(Level level)
{
    return tr("Level %1").arg(level.log2());
}

QString resolutionText(Level level)
{
    return tr("%1 × %1").arg(level.resolution());
}

QString texelCountText(Level level)
{
    return countText(level.texelCount());
}

QString texelText(TexelCoord texel)
{
    const QString half = texel.half == TexelHalf::Lower ? tr("lower") : tr("upper");
    return QString("(%1, %2) %3").arg(texel.i).arg(texel.j).arg(half);
}

QString keepingText(PtxKeeping keeping)
{
    switch (keeping) {
    case PtxKeeping::Block:
        return tr("stored");
    case PtxKeeping::Constant:
        return tr("constant");
    case PtxKeeping::Average:
        return tr("average");
    case PtxKeeping::Computed:
        break;
    }
    return tr("computed");
}

QString keepingTip(PtxKeeping keeping)
{
    switch (keeping) {
    case PtxKeeping::Block:
        return tr("A .ptx stores the level's texels as a packed block of its own.");
    case PtxKeeping::Constant:
        return tr("All texels of the face are alike: a .ptx stores one value for all levels.");
    case PtxKeeping::Average:
        return tr("A .ptx stores the face's one average in a table, which stands for this level.");
    case PtxKeeping::Computed:
        break;
    }
    return tr("A .ptx stores no reduction below 4 × 4 texels: readers compute it when asked.");
}

PtxKeeping keepingOf(const MipFocus& focus, Level level)
{
    const bool constant = focus.levels() != nullptr ? focus.levels()->isConstant(focus.base())
                                                    : focus.texels().isConstant();
    return ptxKeeping(focus.base(), constant, level);
}

std::uint64_t memoryBytes(const MipFocus& focus, Level level)
{
    return level == focus.base() ? focus.texels().byteCount() : 0;
}

QString bytesText(double bytes)
{
    return quantityText(bytes, Quantity::Bytes);
}

QString fileBytesText(const MipFocus& focus, Level level)
{
    if (keepingOf(focus, level) != PtxKeeping::Block) {
        return bytesText(0);
    }
    const std::optional<quint64> bytes = focus.fileBytes(level);
    return bytes                ? bytesText(static_cast<double>(*bytes))
           : focus.isMeasured() ? QString("–")
                                : QString("…");
}

QString differenceText(TexelType type, std::span<const float> right, std::span<const float> box)
{
    const bool whole = type == TexelType::UInt8 || type == TexelType::UInt16;
    const double top = type == TexelType::UInt8 ? 255.0 : 65535.0;
    QStringList words;
    for (std::size_t c = 0; c < std::min(right.size(), kValuesShown); ++c) {
        const double apart = static_cast<double>(box[c]) - static_cast<double>(right[c]);
        words += whole
                     ? withSign(QString::number(std::lround(apart * top)), std::round(apart * top))
                     : withSign(QString::number(apart, 'g', 4), apart);
    }
    if (right.size() > kValuesShown) {
        words += "…";
    }
    return words.join("  ");
}

QString partsText(double difference)
{
    const double parts = 255 * difference;
    return withSign(QString::number(parts, 'f', std::abs(parts) < 10 ? 2 : 1), parts);
}

} // namespace trixel::ui
