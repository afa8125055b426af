// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/method_box.h"

#include "ui/viewport/view_settings.h"

namespace trixel::ui {

namespace {

QString fromView(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

} // namespace

QString methodTitle(const MethodChoice& method)
{
    const MethodEntry* entry = findMethod(method.name);
    if (entry == nullptr) {
        return QString::fromStdString(method.name);
    }
    const QString title = fromView(entry->title);
    return method.parameter && entry->parameter ? QString("%1 (%2 %3)")
                                                      .arg(title, fromView(entry->parameter->name))
                                                      .arg(*method.parameter)
                                                : title;
}

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
