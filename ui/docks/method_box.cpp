// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/method_box.h"

#include "ui/viewport/method_title.h"
#include "ui/viewport/view_settings.h"

namespace trixel::ui {

MethodBox::MethodBox(ViewSettings& settings, QWidget* parent)
    : QComboBox(parent)
    , m_settings(settings)
{
    setAccessibleName(tr("Filter method"));
    setFocusPolicy(Qt::StrongFocus);
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    for (const MethodEntry& entry : filterMethods()) {
        addItem(fromView(entry.title), fromView(entry.name));
        setItemData(count() - 1, fromView(entry.about), Qt::ToolTipRole);
    }
    connect(this, &QComboBox::activated, this, [this](int index) {
        m_settings.setMethod({itemData(index).toString().toStdString(), std::nullopt});
    });
    connect(&settings, &ViewSettings::methodChanged, this, &MethodBox::follow);
    follow();
}

void MethodBox::follow()
{
    const MethodChoice& method = m_settings.method();
    const int index = findData(QString::fromStdString(method.name));
    setCurrentIndex(index);
    const QString about = itemData(index, Qt::ToolTipRole).toString();
    setToolTip(tr("The filter that maps, seams and read-outs are made with: %1")
                   .arg(about.isEmpty() ? methodTitle(method) : about));
}

} // namespace trixel::ui
