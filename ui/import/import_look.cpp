// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/import_look.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QRadioButton>

#include "ui/import/distortion_view.h"
#include "ui/viewport/view_settings.h"
#include "ui/viewport/viewport.h"

#include <utility>

namespace trixel::ui {

ImportLook::ImportLook(Viewport& viewport, ViewSettings& settings, QWidget* parent)
    : QWidget(parent)
    , m_viewport(viewport)
    , m_settings(settings)
    , m_distortion(new DistortionView(viewport, this))
    , m_measure(new QComboBox)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    auto* row = new QHBoxLayout;
    row->setSpacing(10);
    column->addLayout(row);
    m_before = addChoice(*row,
                         tr("&Before"),
                         tr("Show the texels as they are"),
                         tr("The texels as they are, without the image"));
    m_after = addChoice(*row,
                        tr("Af&ter"),
                        tr("Show the texels with the image"),
                        tr("The texels as they would be; nothing is changed yet"));
    m_distorted = addChoice(*row,
                            tr("&Distortion"),
                            tr("Show the distortion of the image"),
                            tr("How the mapping stretches the image, as colours over the surface"));
    m_measure->addItem(tr("Density: texels a pixel of the image"),
                       static_cast<int>(DistortionMeasure::TexelsPerPixel));
    m_measure->addItem(tr("Stretch: length of pixels by width"),
                       static_cast<int>(DistortionMeasure::Stretch));
    m_measure->setAccessibleName(tr("Measure of the distortion"));
    m_measure->setToolTip(tr("Density: how many texels there are for a pixel of the image, along a "
                             "side. Stretch: how many times longer than wide pixels are drawn"));
    m_measure->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    row->addStretch(1);
    column->addWidget(m_measure);
    m_after->setChecked(true);
    m_measure->hide();
    for (QRadioButton* choice : {m_before, m_after, m_distorted}) {
        connect(choice, &QRadioButton::toggled, this, [this](bool chosen) {
            if (chosen) {
                show();
            }
        });
    }
    connect(m_measure, &QComboBox::currentIndexChanged, this, &ImportLook::show);
    connect(&settings, &ViewSettings::viewChanged, this, [this] {
        if (m_settings.view().map != ViewMapKind::None && m_distorted->isChecked()) {
            m_after->setChecked(true); // one map at a time
        }
    });
}

QRadioButton* ImportLook::addChoice(QBoxLayout& row,
                                    const QString& text,
                                    const QString& name,
                                    const QString& toolTip)
{
    auto* choice = new QRadioButton(text);
    choice->setAccessibleName(name);
    choice->setToolTip(toolTip);
    row.addWidget(choice);
    return choice;
}

void ImportLook::setPicture(std::shared_ptr<const PreviewPicture> picture)
{
    m_picture = std::move(picture);
    show();
}

void ImportLook::setInput(std::optional<ImportInput> input)
{
    m_input = std::move(input);
    if (m_distorted->isChecked()) {
        showDistortion();
    }
}

void ImportLook::setOn(bool on)
{
    m_isOn = on;
    show();
}

DistortionMeasure ImportLook::measure() const
{
    return static_cast<DistortionMeasure>(m_measure->currentData().toInt());
}

/// What another panel shows in the texels' place is left alone.
void ImportLook::show()
{
    m_measure->setVisible(m_distorted->isChecked());
    if (m_isOn && m_picture && m_after->isChecked()) {
        m_viewport.showOtherTexels(m_picture->texels);
        m_isShown = true;
    } else if (std::exchange(m_isShown, false)) {
        m_viewport.showOtherTexels(std::nullopt);
    }
    showDistortion();
}

void ImportLook::showDistortion()
{
    if (!m_isOn || !m_input || !m_distorted->isChecked()) {
        m_distortion->drop();
        return;
    }
    ViewOptions view = m_settings.view();
    view.map = ViewMapKind::None;
    m_settings.setView(view);
    m_distortion->ask(*m_input, measure());
}

} // namespace trixel::ui
