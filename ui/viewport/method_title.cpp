// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/method_title.h"

namespace trixel::ui {

QString fromView(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

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

} // namespace trixel::ui
