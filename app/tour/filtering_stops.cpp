// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stops at what the graphics card filters, and at the limit surface.
#include <QCheckBox>

#include "app/tour/looks.h"
#include "app/tour/stops.h"
#include "ui/viewport/crease_bar.h"
#include "ui/viewport/frame_hud.h"
#include "ui/viewport/split_bar.h"
#include "ui/viewport/viewport.h"

namespace trixel::app {

Status Stops::seamlessTexels()
{
    m_input.keys(Qt::Key_A);
    m_window.viewport().lookFrom(75, 25, 6);
    m_input.keys(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_8));
    m_window.viewport().settle();
    const ui::SplitBar& bar = m_window.viewport().splitBar();
    const bool isSplit = bar.isVisible() && bar.rightText().contains("Seamless");
    if (Status split = expect(isSplit, "Ctrl+Shift+8 shows seamless texels beside crisp ones");
        !split) {
        return split;
    }
    const Status taken = picture("seamless-texels");
    m_input.keys(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_8));
    return taken ? expect(!bar.isVisible(), "Ctrl+Shift+8 again ends the comparison") : taken;
}

Status Stops::limitSurface()
{
    m_input.keys(Qt::Key_A);
    m_window.viewport().lookFrom(48, 12, 4);
    m_input.keys(Qt::Key_W);
    m_input.keys(Qt::Key_L);
    m_input.keys(QKeySequence(Qt::CTRL | Qt::Key_U));
    m_window.viewport().settle();
    const auto* hud = m_view.findChild<ui::FrameHud*>();
    const bool told = m_input.waitFor([&] {
        for (const auto& [name, figure] : hud->lines()) {
            if (name == "Off by" && hud->isVisible()) {
                return true;
            }
        }
        return false;
    });
    if (Status shown = expect(told, "L shows the limit surface, and Ctrl+U how far it is off");
        !shown) {
        return shown;
    }
    Status taken = picture("limit-surface");
    if (taken) {
        taken = chosenCreases();
    }
    m_input.keys(QKeySequence(Qt::CTRL | Qt::Key_U));
    m_input.keys(Qt::Key_L);
    m_input.keys(Qt::Key_W);
    return taken ? expect(!m_window.settings().view().limitSurface, "L again shows the cage")
                 : taken;
}

/// Edges folded by more than an angle stay sharp on the limit surface.
Status Stops::chosenCreases()
{
    m_input.keys(QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_L));
    auto* bar = m_view.findChild<ui::CreaseBar*>();
    if (Status asked = expect(bar != nullptr && bar->isVisible(), "Ctrl+Alt+L asks for the angle");
        !asked) {
        return asked;
    }
    auto* isOn = bar->findChild<QCheckBox*>();
    m_input.press(*isOn, Qt::Key_Space);
    m_window.viewport().settle();
    if (Status kept = expect(m_window.document().creaseAngle().has_value(), "Space keeps edges");
        !kept) {
        return kept;
    }
    const Status taken = picture("creases");
    m_input.press(*isOn, Qt::Key_Space);
    m_input.press(*bar, Qt::Key_Escape);
    return taken;
}

} // namespace trixel::app
