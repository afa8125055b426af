// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/format_choice.h"

#include <QLocale>

namespace trixel::ui {

TypeChoice::TypeChoice(QWidget* parent)
    : QComboBox(parent)
{
    addItem(tr("uint8: colours, 256 steps"), static_cast<int>(TexelType::UInt8));
    addItem(tr("uint16: masks and fine gradients, 65,536 steps"),
            static_cast<int>(TexelType::UInt16));
    addItem(tr("half: light and displacement, 3 digits"), static_cast<int>(TexelType::Half));
    addItem(tr("float: measured data, 7 digits"), static_cast<int>(TexelType::Float));
    setAccessibleName(tr("Type of a channel"));
    setToolTip(tr("How each channel of a texel is stored"));
}

TexelType TypeChoice::type() const
{
    return static_cast<TexelType>(currentData().toInt());
}

void TypeChoice::setType(TexelType type)
{
    setCurrentIndex(findData(static_cast<int>(type)));
}

ChannelChoice::ChannelChoice(QWidget* parent)
    : QComboBox(parent)
{
    addItem(tr("1: grey"), 1);
    addItem(tr("3: red, green, blue"), 3);
    addItem(tr("4: red, green, blue, opacity"), 4);
    setAccessibleName(tr("Channels"));
    setToolTip(tr("How many numbers each texel holds"));
    setChannels(3);
}

void ChannelChoice::setChannels(int channels)
{
    setCurrentIndex(findData(channels));
}

QString sizeText(std::uint64_t bytes)
{
    return QLocale().formattedDataSize(
        static_cast<qint64>(bytes), bytes < 1000 ? 0 : 1, QLocale::DataSizeSIFormat);
}

QString countText(std::uint64_t count)
{
    return QLocale().toString(static_cast<qulonglong>(count));
}

} // namespace trixel::ui
