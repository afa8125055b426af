// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/point_row.h"

#include <QHBoxLayout>
#include <QScopedValueRollback>

#include "ui/look/value_spin.h"

namespace trixel::ui {

PointRow::PointRow(const QString& name, const QString& toolTip, QWidget* parent)
    : QWidget(parent)
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    constexpr std::array<char, 3> kAxes = {'X', 'Y', 'Z'};
    for (std::size_t k = 0; k < 3; ++k) {
        m_fields[k] = new ValueSpin;
        // Three in a narrow panel: the arrow keys step all the same.
        m_fields[k]->setButtonSymbols(QAbstractSpinBox::NoButtons);
        m_fields[k]->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
        m_fields[k]->setAccessibleName(QString("%1, %2").arg(name, QChar(kAxes[k])));
        m_fields[k]->setToolTip(QString("%1: %2").arg(toolTip, QChar(kAxes[k])));
        row->addWidget(m_fields[k], 1);
        connect(m_fields[k], &QDoubleSpinBox::valueChanged, this, [this] {
            if (!m_isSetting) {
                emit edited();
            }
        });
    }
    setFocusProxy(m_fields[0]);
}

glm::dvec3 PointRow::value() const
{
    return {m_fields[0]->value(), m_fields[1]->value(), m_fields[2]->value()};
}

void PointRow::setValue(const glm::dvec3& value)
{
    const QScopedValueRollback setting(m_isSetting, true);
    for (int k = 0; k < 3; ++k) {
        m_fields[static_cast<std::size_t>(k)]->setValue(value[k]);
    }
}

void PointRow::setStep(double step)
{
    for (ValueSpin* field : m_fields) {
        field->setSingleStep(step);
    }
}

} // namespace trixel::ui
