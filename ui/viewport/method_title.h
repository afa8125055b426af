// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/filter/filter_method.h"

namespace trixel::ui {

/// The name of a filter method as people read it; empty for one that does not exist.
inline QString titleOf(const MethodChoice& method)
{
    const MethodEntry* entry = findMethod(method.name);
    return entry == nullptr ? QString()
                            : QString::fromUtf8(entry->title.data(),
                                                static_cast<qsizetype>(entry->title.size()));
}

} // namespace trixel::ui
