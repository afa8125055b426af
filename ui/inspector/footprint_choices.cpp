// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/footprint_choices.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>

#include "ui/docks/method_box.h"

namespace trixel::ui {

FootprintChoices::FootprintChoices(ViewSettings& settings, QWidget* parent)
    : QWidget(parent)
    , m_source(new QComboBox)
    , m_colouring(new QComboBox)
    , m_freeze(new QToolButton)
{
    m_source->addItem(tr("Screen"), static_cast<int>(FootprintSource::Screen));
    m_source->addItem(tr("Texture-aligned"), static_cast<int>(FootprintSource::TextureAligned));
    m_source->addItem(tr("By hand"), static_cast<int>(FootprintSource::ByHand));
    m_source->addItem(tr("Tilted view"), static_cast<int>(FootprintSource::Tilted));
    m_source->setAccessibleName(tr("Source of the footprint"));
    m_source->setToolTip(
        tr("Where W1 and W2 come from: the pixel that sees this point, a box along "
           "u and v, your hand, or a view tilted over the point"));
    m_freeze->setCheckable(true);
    m_freeze->setAccessibleName(tr("Freeze the footprint"));
    m_freeze->setToolTip(tr("Keep this footprint, then orbit or point elsewhere and compare"));
    auto* method = new MethodBox(settings);
    m_colouring->addItem(tr("Weights of the method"));
    m_colouring->addItem(tr("Weights of exact"));
    m_colouring->addItem(tr("Texel values"));
    m_colouring->setAccessibleName(tr("Colour of the texels"));
    m_colouring->setToolTip(tr("Colour texels by how much they count in the answer, or by what "
                               "they hold"));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(3);
    addRow(*grid, tr("&From"), *m_source, m_freeze);
    addRow(*grid, tr("Me&thod"), *method);
    addRow(*grid, tr("&Colour"), *m_colouring);
    grid->setColumnStretch(1, 1);
    setFrozen(false, false);
    connect(m_source, &QComboBox::currentIndexChanged, this, [this] {
        emit sourceChosen(static_cast<FootprintSource>(m_source->currentData().toInt()));
    });
    connect(m_freeze, &QToolButton::toggled, this, &FootprintChoices::freezeToggled);
    connect(m_colouring, &QComboBox::currentIndexChanged, this, &FootprintChoices::colouringChosen);
}

void FootprintChoices::addRow(QGridLayout& grid,
                              const QString& text,
                              QComboBox& box,
                              QWidget* beside)
{
    box.setMinimumWidth(60);
    box.setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    auto* label = new QLabel(text);
    label->setBuddy(&box);
    const int row = grid.rowCount();
    grid.addWidget(label, row, 0);
    grid.addWidget(&box, row, 1, 1, beside == nullptr ? 2 : 1);
    if (beside != nullptr) {
        grid.addWidget(beside, row, 2);
    }
}

void FootprintChoices::setSource(FootprintSource source)
{
    const QSignalBlocker quiet(m_source);
    m_source->setCurrentIndex(m_source->findData(static_cast<int>(source)));
}

void FootprintChoices::setFrozen(bool frozen, bool possible)
{
    const QSignalBlocker quiet(m_freeze);
    m_freeze->setChecked(frozen);
    m_freeze->setText(frozen ? tr("Let go") : tr("Freeze"));
    m_freeze->setEnabled(possible);
}

FootprintChoices::Colouring FootprintChoices::colouring() const
{
    return static_cast<Colouring>(m_colouring->currentIndex());
}

} // namespace trixel::ui
