// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <QString>

#include "core/texture/texel_format.h"

namespace trixel::ui {

/// Which type a channel is stored as, with what each is good for.
class TypeChoice : public QComboBox
{
    Q_OBJECT

public:
    explicit TypeChoice(QWidget* parent = nullptr);
    TexelType type() const;
    void setType(TexelType type);
};

/// 1, 3 or 4 channels.
class ChannelChoice : public QComboBox
{
    Q_OBJECT

public:
    explicit ChannelChoice(QWidget* parent = nullptr);
    int channels() const { return currentData().toInt(); }
    void setChannels(int channels);
};

/// "12.3 MB", decimal.
QString sizeText(std::uint64_t bytes);
/// "1,234,567"
QString countText(std::uint64_t count);

} // namespace trixel::ui
