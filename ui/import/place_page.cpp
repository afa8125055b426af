// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/place_page.h"

#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "ui/docks/value_row.h"
#include "ui/import/quad_placement.h"

namespace trixel::ui {

namespace {

constexpr double kOver = 25; // percent

} // namespace

PlacePage::PlacePage(QuadPlacement& placement, QWidget* parent)
    : QWidget(parent)
    , m_placement(placement)
    , m_about(new QLabel)
    , m_here(new QPushButton)
    , m_return(new QPushButton(tr("Look from Ther&e")))
    , m_corners(new QPushButton(tr("Mo&ve Corners")))
    , m_over(new ValueRow(Scale::Linear,
                          0,
                          100,
                          {tr("Image over the view"),
                           tr("How strongly the image is drawn between its corners, to line it up; "
                              "the texels don't depend on it"),
                           tr(" %")}))
{
    m_about->setWordWrap(true);
    m_about->setAccessibleName(tr("About the corners"));
    m_about->setToolTip(tr("Where the image's corners are, and how they are moved"));
    m_here->setAccessibleName(tr("Place the image in the view"));
    m_return->setAccessibleName(tr("Look from where the image comes from"));
    m_return->setToolTip(tr("Bring the view back to where the image is thrown from"));
    m_corners->setAccessibleName(tr("Move the corners by keyboard"));
    m_corners->setToolTip(tr("Give the keyboard to the image's lower left corner in the view: the "
                             "arrow keys move it, with Shift farther, and Tab goes to the next"));
    m_over->setValue(kOver);
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    form->setVerticalSpacing(6);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->addRow(m_about);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(6);
    for (QPushButton* button : {m_here, m_return, m_corners}) {
        buttons->addWidget(button);
    }
    buttons->addStretch(1);
    form->addRow(buttons);
    auto* over = new QLabel(tr("Over the vie&w"));
    over->setBuddy(m_over->buddy());
    form->addRow(over, m_over);
    connect(m_here, &QPushButton::clicked, &m_placement, &QuadPlacement::placeInView);
    connect(m_return, &QPushButton::clicked, &m_placement, &QuadPlacement::lookFromThere);
    connect(m_corners, &QPushButton::clicked, &m_placement, &QuadPlacement::focusCorner);
    connect(m_over, &ValueRow::edited, &m_placement, [this](double percent) {
        m_placement.setImageOpacity(percent / 100);
    });
    connect(&m_placement, &QuadPlacement::viewMoved, this, &PlacePage::follow);
    connect(&m_placement, &QuadPlacement::changed, this, &PlacePage::follow);
    m_placement.setImageOpacity(kOver / 100);
    follow();
}

void PlacePage::follow()
{
    const bool isCamera = m_placement.kind() == MapKind::Camera;
    const bool isSeen = m_placement.isSeen();
    m_about->setText(
        !isCamera ? tr("Drag the image's four corners in the view. It is thrown straight onto the "
                       "surface, along the direction that sees most of it.")
        : isSeen  ? tr("Drag the image's four corners in the view. It is thrown from here, also "
                       "when the view turns away.")
                  : tr("The view has moved on; the image is still thrown from where it was."));
    m_here->setText(isCamera ? tr("&Use This View") : tr("Place in &View"));
    m_here->setToolTip(isCamera ? tr("Throw the image from where the view is now")
                                : tr("Lay the image upright into the middle of the view"));
    m_here->setVisible(!isCamera || !isSeen);
    m_return->setVisible(isCamera && !isSeen);
    m_corners->setVisible(isSeen);
    m_over->setEnabled(isSeen);
}

} // namespace trixel::ui
