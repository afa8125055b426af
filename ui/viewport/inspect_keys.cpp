// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/inspect_keys.h"

#include <QKeyEvent>

namespace trixel::ui {

std::optional<Inspection::Step> inspectStepOf(int key)
{
    switch (key) {
    case Qt::Key_Right:
        return Inspection::Step::Right;
    case Qt::Key_Left:
        return Inspection::Step::Left;
    case Qt::Key_Up:
        return Inspection::Step::Ahead;
    case Qt::Key_Down:
        return Inspection::Step::Back;
    default:
        return std::nullopt;
    }
}

bool takeInspectKey(Inspection& inspection, const QKeyEvent& event)
{
    if ((event.modifiers() & ~Qt::KeypadModifier) != Qt::NoModifier || !inspection.texel()) {
        return false;
    }
    if (const auto step = inspectStepOf(event.key())) {
        inspection.step(*step);
        return true;
    }
    if (event.key() == Qt::Key_Escape && inspection.isHeld()) {
        inspection.letGo();
        return true;
    }
    return false;
}

} // namespace trixel::ui
