// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/import_look.h"

#include <QHBoxLayout>
#include <QRadioButton>

#include "ui/viewport/viewport.h"

#include <utility>

namespace trixel::ui {

ImportLook::ImportLook(Viewport& viewport, QWidget* parent)
    : QWidget(parent)
    , m_viewport(viewport)
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(10);
    m_before = addChoice(tr("&Before"),
                         tr("Show the texels as they are"),
                         tr("The texels as they are, without the image"));
    m_after = addChoice(tr("Af&ter"),
                        tr("Show the texels with the image"),
                        tr("The texels as they would be; nothing is changed yet"));
    row->addStretch(1);
    m_after->setChecked(true);
    connect(m_after, &QRadioButton::toggled, this, &ImportLook::show);
}

QRadioButton*
ImportLook::addChoice(const QString& text, const QString& name, const QString& toolTip)
{
    auto* choice = new QRadioButton(text);
    choice->setAccessibleName(name);
    choice->setToolTip(toolTip);
    layout()->addWidget(choice);
    return choice;
}

void ImportLook::setPicture(std::shared_ptr<const PreviewPicture> picture)
{
    m_picture = std::move(picture);
    show();
}

void ImportLook::setOn(bool on)
{
    m_isOn = on;
    show();
}

/// What another panel shows in the texels' place is left alone.
void ImportLook::show()
{
    if (m_isOn && m_picture && m_after->isChecked()) {
        m_viewport.showOtherTexels(m_picture->texels);
        m_isShown = true;
    } else if (std::exchange(m_isShown, false)) {
        m_viewport.showOtherTexels(std::nullopt);
    }
}

} // namespace trixel::ui
