// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/texture/texel_format.h"

class QButtonGroup;
class QComboBox;
class QHBoxLayout;
class QToolButton;

namespace trixel::ui {

class Document;
class ViewSettings;

/// Chooses what the look shows of a texel: colour, one channel or the luminance. The channels are
/// those of the document; those beyond the first four are in a list.
class ChannelRow : public QWidget
{
    Q_OBJECT

public:
    ChannelRow(const Document& document, ViewSettings& settings, QWidget* parent = nullptr);

private:
    TexelFormat shownFormat() const;
    void takeDocument();
    void rebuild();
    void follow();
    QToolButton* addButton(int id, const QString& text, const QString& toolTip);
    void choose(int id);
    int chosen() const;

    const Document& m_document;
    ViewSettings& m_settings;
    QHBoxLayout* m_layout;
    QButtonGroup* m_group;
    TexelFormat m_listed;          ///< whose channels there are buttons for
    QComboBox* m_others = nullptr; ///< none where four channels are all
};

} // namespace trixel::ui
