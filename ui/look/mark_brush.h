// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QBrush>

#include "render/look.h"

namespace trixel::ui {

/// Fills with a mark's colour and pattern, as the view does.
QBrush markBrush(render::Mark mark);

} // namespace trixel::ui
