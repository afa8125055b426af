// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/document/inspection.h"

#include <optional>

class QKeyEvent;

namespace trixel::ui {

/// The step that an arrow key takes; nothing for other keys.
std::optional<Inspection::Step> inspectStepOf(int key);

/// What the keyboard does to the texel looked at, in the view and in every panel that shows texels:
/// right and left leave by the next edge on that side, up goes straight on, down goes back, Esc
/// lets go. Keys with a modifier are not meant.
/// \return  whether the key was used; arrows are, also where a border is in the way
bool takeInspectKey(Inspection& inspection, const QKeyEvent& event);

} // namespace trixel::ui
