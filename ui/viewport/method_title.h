// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/filter/filter_method.h"

#include <string_view>

namespace trixel::ui {

/// A text of the table of filter methods.
QString fromView(std::string_view text);

/// A filter method as people read it, with its parameter where it has one that was chosen.
QString methodTitle(const MethodChoice& method);

} // namespace trixel::ui
