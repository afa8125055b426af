// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "render/filtering.h"

namespace trixel::ui {

/// What people call a way of filtering.
QString filteringTitle(render::Filtering filtering);

/// One sentence on what it shows.
QString filteringAbout(render::Filtering filtering);

} // namespace trixel::ui
