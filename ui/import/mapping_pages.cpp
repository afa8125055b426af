// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/mapping_pages.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>

#include "ui/import/import_mapping.h"
#include "ui/import/point_row.h"
#include "ui/look/value_spin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace trixel::ui {

namespace {

constexpr double kStepPart = 0.01; // of the surface's size

const std::array<glm::dvec3, 3>& axes()
{
    static const std::array<glm::dvec3, 3> kAxes = {
        glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0)};
    return kAxes;
}

QFormLayout* makeForm(QWidget& page)
{
    auto* form = new QFormLayout(&page);
    form->setContentsMargins(0, 0, 0, 0);
    form->setVerticalSpacing(6);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    return form;
}

} // namespace

QDoubleSpinBox* makeTurn(const QString& name, const QString& toolTip)
{
    auto* turn = new QDoubleSpinBox;
    turn->setRange(-180, 180);
    turn->setWrapping(true);
    turn->setDecimals(1);
    turn->setSingleStep(5);
    turn->setSuffix("°");
    turn->setAccessibleName(name);
    turn->setToolTip(toolTip);
    return turn;
}

SpherePage::SpherePage(QWidget* parent)
    : QWidget(parent)
    , m_centre(new PointRow(tr("Centre of the sphere"), tr("Where the image is thrown from")))
    , m_axis(new QComboBox)
    , m_turn(makeTurn(tr("Turn of the sphere"), tr("How far the image is turned about its axis")))
{
    m_axis->addItems({tr("Y, upright"), tr("Z"), tr("X")});
    m_axis->setAccessibleName(tr("Axis of the sphere"));
    m_axis->setToolTip(tr("From the image's lower edge, the lower pole, to the upper"));
    QFormLayout* form = makeForm(*this);
    form->addRow(tr("&Centre"), m_centre);
    form->addRow(tr("A&xis"), m_axis);
    form->addRow(tr("T&urn"), m_turn);
    connect(m_centre, &PointRow::edited, this, &SpherePage::changed);
    connect(m_axis, &QComboBox::currentIndexChanged, this, &SpherePage::changed);
    connect(m_turn, &QDoubleSpinBox::valueChanged, this, &SpherePage::changed);
}

SphereSettings SpherePage::settings() const
{
    const auto axis = static_cast<std::size_t>(std::max(0, m_axis->currentIndex()));
    return {m_centre->value(), axes()[axis], m_turn->value()};
}

void SpherePage::takeSurface(const Surface& surface)
{
    m_centre->setValue(0.5 * (glm::dvec3(surface.low()) + glm::dvec3(surface.high())));
    m_centre->setStep(kStepPart * double{surface.size()});
}

PlanePage::PlanePage(QWidget* parent)
    : QWidget(parent)
    , m_centre(new PointRow(tr("Centre of the plane"), tr("Where the image's middle lies")))
    , m_side(new QComboBox)
    , m_turn(makeTurn(tr("Turn of the plane"),
                      tr("How far the image is turned, counter-clockwise as it is looked at")))
    , m_width(new ValueSpin)
    , m_height(new ValueSpin)
    , m_keepsAspect(new QCheckBox(tr("Keep the image’s &proportions")))
{
    m_side->addItems({tr("Front (from +Z)"),
                      tr("Back (from −Z)"),
                      tr("Right (from +X)"),
                      tr("Left (from −X)"),
                      tr("Top (from +Y)"),
                      tr("Bottom (from −Y)")});
    m_side->setAccessibleName(tr("Side of the plane"));
    m_side->setToolTip(tr("Which way the image is looked at"));
    QFormLayout* form = makeForm(*this);
    form->addRow(tr("&Side"), m_side);
    form->addRow(tr("&Centre"), m_centre);
    form->addRow(tr("T&urn"), m_turn);
    makeSize(*form);
    connect(m_centre, &PointRow::edited, this, &PlanePage::changed);
    connect(m_turn, &QDoubleSpinBox::valueChanged, this, &PlanePage::changed);
    connect(m_side, &QComboBox::currentIndexChanged, this, [this] {
        cover();
        emit changed();
    });
}

void PlanePage::makeSize(QFormLayout& form)
{
    auto* sizes = new QWidget;
    auto* row = new QHBoxLayout(sizes);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(m_width, 1);
    row->addWidget(new QLabel("×"));
    row->addWidget(m_height, 1);
    m_width->setAccessibleName(tr("Width of the plane"));
    m_width->setToolTip(tr("How wide the image is, in units of the mesh"));
    m_height->setAccessibleName(tr("Height of the plane"));
    m_height->setToolTip(tr("How high the image is, in units of the mesh"));
    sizes->setFocusProxy(m_width);
    for (QDoubleSpinBox* field : {m_width, m_height}) {
        field->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    }
    m_keepsAspect->setChecked(true);
    m_keepsAspect->setAccessibleName(tr("Keep the image’s proportions"));
    m_keepsAspect->setToolTip(tr("The height follows the width, so that pixels stay square"));
    auto* cover = new QPushButton(tr("Cover the &Mesh"));
    cover->setAccessibleName(tr("Cover the mesh"));
    cover->setToolTip(tr("Centre the image and make it just large enough for the whole mesh"));
    form.addRow(tr("Si&ze"), sizes);
    form.addRow(m_keepsAspect);
    form.addRow(cover);
    connect(m_width, &QDoubleSpinBox::valueChanged, this, [this] {
        keepAspect();
        if (!m_isSetting) {
            emit changed();
        }
    });
    connect(m_height, &QDoubleSpinBox::valueChanged, this, [this] {
        if (!m_isSetting) {
            emit changed();
        }
    });
    connect(m_keepsAspect, &QCheckBox::toggled, this, [this] {
        m_height->setEnabled(!m_keepsAspect->isChecked());
        keepAspect();
        emit changed();
    });
    m_height->setEnabled(false);
    connect(cover, &QPushButton::clicked, this, [this] {
        this->cover();
        emit changed();
    });
}

PlaneSettings PlanePage::settings() const
{
    PlaneSettings plane;
    plane.centre = m_centre->value();
    plane.side = static_cast<PlaneSide>(std::max(0, m_side->currentIndex()));
    plane.turn = m_turn->value();
    plane.size = {m_width->value(), m_height->value()};
    return plane;
}

void PlanePage::takeSurface(const Surface& surface)
{
    m_low = glm::dvec3(surface.low());
    m_high = glm::dvec3(surface.high());
    for (QDoubleSpinBox* field : {m_width, m_height}) {
        field->setSingleStep(kStepPart * double{surface.size()});
    }
    m_centre->setStep(kStepPart * double{surface.size()});
    cover();
}

void PlanePage::setAspect(double aspect)
{
    m_aspect = aspect;
    if (m_keepsAspect->isChecked()) {
        cover();
    }
}

/// Centred, and with the image's proportions, whether or not they are kept.
void PlanePage::cover()
{
    const QScopedValueRollback setting(m_isSetting, true);
    const PlaneAxes axes = axesOf(settings());
    const glm::dvec3 size = glm::max(m_high - m_low, glm::dvec3(0));
    double width = glm::dot(glm::abs(axes.right), size);
    double height = glm::dot(glm::abs(axes.up), size);
    if (!(width > 0) && !(height > 0)) {
        width = height = 1;
    }
    width = std::max(width, height * m_aspect);
    m_centre->setValue(0.5 * (m_low + m_high));
    m_width->setValue(width);
    m_height->setValue(width / m_aspect);
}

void PlanePage::keepAspect()
{
    if (m_keepsAspect->isChecked()) {
        const QScopedValueRollback setting(m_isSetting, true);
        m_height->setValue(m_width->value() / m_aspect);
    }
}

} // namespace trixel::ui
