// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/footprint_vectors.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>

namespace trixel::ui {

namespace {

constexpr double kMost = 1024.0;

} // namespace

FootprintVectors::FootprintVectors(QWidget* parent)
    : QWidget(parent)
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(3);
    const QString names[] = {
        tr("W1 along u"), tr("W1 along v"), tr("W2 along u"), tr("W2 along v")};
    for (int k = 0; k < 4; ++k) {
        auto* box = new QDoubleSpinBox;
        box->setRange(-kMost, kMost);
        box->setDecimals(6);
        box->setAccessibleName(names[k]);
        box->setToolTip(tr("%1, in edges of the face; one step is half a texel. Typing makes the "
                           "footprint one by hand")
                            .arg(names[k]));
        box->setKeyboardTracking(false);
        box->setMinimumWidth(60);
        box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        connect(box, &QDoubleSpinBox::valueChanged, this, [this, k](double value) {
            // The other numbers keep the digits that their boxes do not show.
            glm::dvec2& vector = k < 2 ? m_shown.w1 : m_shown.w2;
            (k % 2 == 0 ? vector.x : vector.y) = value;
            emit edited(m_shown.w1, m_shown.w2);
        });
        m_boxes[static_cast<std::size_t>(k)] = box;
        grid->addWidget(box, k / 2, 1 + k % 2);
    }
    for (int row = 0; row < 2; ++row) {
        auto* label = new QLabel(row == 0 ? tr("W&1") : tr("W&2"));
        label->setBuddy(m_boxes[static_cast<std::size_t>(2 * row)]);
        label->setToolTip(tr("The vector in (u, v) of the face"));
        grid->addWidget(label, row, 0);
    }
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(2, 1);
}

void FootprintVectors::show(const Footprint& footprint, double texel)
{
    m_shown = footprint;
    const double values[] = {footprint.w1.x, footprint.w1.y, footprint.w2.x, footprint.w2.y};
    for (std::size_t k = 0; k < m_boxes.size(); ++k) {
        const QSignalBlocker quiet(m_boxes[k]);
        m_boxes[k]->setSingleStep(texel / 2);
        if (!m_boxes[k]->hasFocus() || qAbs(m_boxes[k]->value() - values[k]) > 5e-7) {
            m_boxes[k]->setValue(values[k]);
        }
    }
}

} // namespace trixel::ui
