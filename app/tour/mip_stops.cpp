// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stop at the levels of one face.
#include <QDockWidget>

#include "app/tour/looks.h"
#include "app/tour/stops.h"
#include "ui/inspector/mip_panel.h"
#include "ui/viewport/viewport.h"

namespace trixel::app {

namespace {

QPoint placeOf(const ui::MipView& view, Level level, TexelCoord texel)
{
    for (const ui::MipCell& cell : view.cells()) {
        if (cell.level == level) {
            const glm::dvec2 at = cell.layout.centre(level, texel);
            return QPointF(at.x, at.y).toPoint();
        }
    }
    return {};
}

} // namespace

Status Stops::faceMips()
{
    auto* panel = m_window.findChild<ui::MipPanel*>();
    m_input.keys(QKeySequence(Qt::SHIFT | Qt::Key_F4));
    if (Status shown = expect(panel->isVisible(), "Shift+F4 shows the panel of mips"); !shown) {
        return shown;
    }
    m_input.hover(m_view, inView(0.5, 0.5));
    const auto isDrawn = [&] { return panel->focus().isMeasured() && panel->view().isComplete(); };
    const bool drawn = m_input.waitFor(isDrawn);
    if (Status looked = expect(drawn && panel->focus().face().has_value(),
                               "the panel of mips shows the face under the pointer");
        !looked) {
        return looked;
    }
    const Level base = panel->focus().base();
    const Level middle = base.coarser((base.log2() + 1) / 2);
    m_input.hover(panel->view(), placeOf(panel->view(), middle, panel->focus().texel(middle)));
    if (Status lit = expect(panel->focus().level() == middle, "a level under the pointer counts");
        !lit) {
        return lit;
    }
    const Status taken = picture("face-mips");
    if (Status run = command("mips difference"); !taken || !run) {
        return taken ? run : taken;
    }
    const bool differs = panel->options().content == ui::MipContent::Difference;
    if (Status chosen = expect(differs && m_input.waitFor(isDrawn),
                               "the palette shows what the 2 × 2 box gets wrong");
        !chosen) {
        return chosen;
    }
    const Status second = picture("face-mips-difference");
    panel->setOptions({});
    m_input.keys(QKeySequence(Qt::SHIFT | Qt::Key_F4));
    return second;
}

} // namespace trixel::app
