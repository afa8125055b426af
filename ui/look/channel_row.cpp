// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/channel_row.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QToolButton>

#include "ui/document/document.h"
#include "ui/look/look_words.h"
#include "ui/viewport/view_settings.h"

namespace trixel::ui {

namespace {

/// Choices that are no channel; channels have their number. A group of buttons takes -1 and less
/// for "any".
constexpr int kColor = TexelFormat::kMaxChannels;
constexpr int kLuminance = kColor + 1;
constexpr int kButtons = 4; // channels that have a button of their own

// Which one is chosen must show at a glance, in either theme.
constexpr auto kChecked = "QToolButton:checked { background: palette(highlight); "
                          "color: palette(highlighted-text); border-radius: 3px; }";

} // namespace

ChannelRow::ChannelRow(const Document& document, ViewSettings& settings, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_settings(settings)
    , m_layout(new QHBoxLayout(this))
    , m_group(new QButtonGroup(this))
{
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setSpacing(2);
    setAccessibleName(tr("Channels shown"));
    connect(&document, &Document::opened, this, &ChannelRow::takeDocument);
    connect(&settings, &ViewSettings::lookChanged, this, &ChannelRow::follow);
    connect(m_group, &QButtonGroup::idClicked, this, &ChannelRow::choose);
    setEnabled(m_document.isOpen());
    rebuild();
}

QToolButton* ChannelRow::addButton(int id, const QString& text, const QString& toolTip)
{
    auto* button = new QToolButton;
    button->setText(text);
    button->setCheckable(true);
    button->setStyleSheet(kChecked);
    button->setToolTip(toolTip);
    button->setAccessibleName(toolTip);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_group->addButton(button, id);
    m_layout->addWidget(button);
    button->show(); // not only when control returns to the event loop
    return button;
}

TexelFormat ChannelRow::shownFormat() const
{
    return m_document.isOpen() ? m_document.texels().format() : TexelFormat();
}

/// Most have the channels of the one before: making buttons takes milliseconds.
void ChannelRow::takeDocument()
{
    setEnabled(m_document.isOpen());
    const TexelFormat format = shownFormat();
    if (format.channels == m_listed.channels && format.alpha == m_listed.alpha) {
        follow();
    } else {
        rebuild();
    }
}

void ChannelRow::rebuild()
{
    m_listed = shownFormat();
    for (QAbstractButton* button : m_group->buttons()) {
        delete button;
    }
    delete std::exchange(m_others, nullptr);
    const TexelFormat& format = m_listed;
    const int channels = format.channels;
    if (channels >= 3) {
        addButton(kColor,
                  tr("RGB"),
                  format.alpha ? tr("Show colours with their opacity") : tr("Show colours"));
    } else {
        addButton(kColor, tr("Grey"), tr("Show the first channel as grey"));
    }
    const int first = channels < 3 ? 1 : 0;
    for (int c = first; c < std::min(channels, kButtons); ++c) {
        const auto channel = static_cast<std::uint16_t>(c);
        addButton(c,
                  channelLetter(format, channel),
                  tr("Show %1 alone").arg(channelName(format, channel)));
    }
    if (channels >= 3) {
        addButton(kLuminance, tr("Lum"), tr("Show the luminance of red, green and blue"));
    }
    if (channels > kButtons) {
        m_others = new QComboBox;
        m_others->setAccessibleName(tr("Further channels"));
        m_others->setToolTip(tr("Show a channel beyond the first four alone"));
        m_others->addItem(tr("More…"), kColor);
        for (int c = kButtons; c < channels; ++c) {
            m_others->addItem(channelName(format, static_cast<std::uint16_t>(c)), c);
        }
        m_layout->addWidget(m_others);
        m_others->show();
        connect(m_others, &QComboBox::activated, this, [this](int index) {
            choose(m_others->itemData(index).toInt());
        });
    }
    follow();
}

int ChannelRow::chosen() const
{
    const render::Look& look = m_settings.look();
    const int channels = m_document.isOpen() ? m_document.texels().format().channels : 3;
    if (look.channel && *look.channel < channels) {
        return channels < 3 && *look.channel == 0 ? kColor : *look.channel;
    }
    return look.luminance && channels >= 3 ? kLuminance : kColor;
}

void ChannelRow::follow()
{
    const int id = chosen();
    m_group->setExclusive(false); // none is checked while a channel of the list is shown
    for (QAbstractButton* button : m_group->buttons()) {
        button->setChecked(m_group->id(button) == id);
    }
    m_group->setExclusive(true);
    if (m_others != nullptr) {
        const QSignalBlocker quiet(m_others);
        m_others->setCurrentIndex(std::max(0, m_others->findData(id)));
    }
}

void ChannelRow::choose(int id)
{
    render::Look look = m_settings.look();
    look.channel = id < kColor ? std::optional(static_cast<std::uint16_t>(id)) : std::nullopt;
    look.luminance = id == kLuminance;
    m_settings.setLook(look);
    follow();
}

} // namespace trixel::ui
