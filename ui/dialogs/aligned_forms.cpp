// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/aligned_forms.h"

#include <QFormLayout>
#include <QWidget>

#include <algorithm>

namespace trixel::ui {

namespace {

QList<QWidget*> labelsOf(const QList<QFormLayout*>& forms)
{
    QList<QWidget*> labels;
    for (const QFormLayout* form : forms) {
        for (int row = 0; row < form->rowCount(); ++row) {
            const QLayoutItem* item = form->itemAt(row, QFormLayout::LabelRole);
            if (item != nullptr && item->widget() != nullptr) {
                labels += item->widget();
            }
        }
    }
    return labels;
}

} // namespace

void alignForms(const QList<QFormLayout*>& forms)
{
    const QList<QWidget*> labels = labelsOf(forms);
    int width = 0;
    for (const QWidget* label : labels) {
        width = std::max(width, label->sizeHint().width());
    }
    for (QWidget* label : labels) {
        label->setMinimumWidth(width);
    }
}

} // namespace trixel::ui
