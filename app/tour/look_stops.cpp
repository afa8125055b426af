// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stop at the looking tools.
#include <QDockWidget>

#include "app/tour/looks.h"
#include "app/tour/stops.h"
#include "ui/look/histogram_view.h"
#include "ui/look/look_legend.h"
#include "ui/look/look_panel.h"
#include "ui/viewport/viewport.h"

namespace trixel::app {

Status Stops::falseColours()
{
    m_input.keys(Qt::Key_A);
    m_window.viewport().lookFrom(48, 12, 1.25);
    auto* dock = m_window.findChild<QDockWidget*>("lookPanel");
    auto* panel = m_window.findChild<ui::LookPanel*>();
    dock->show();
    dock->raise();
    m_input.settle();
    const bool counted = m_input.waitFor([&] { return panel->survey().isCurrent(); });
    if (Status done = expect(counted, "the values of the texels are counted"); !done) {
        return done;
    }
    m_input.keys(Qt::Key_J); // false colour, of the luminance
    m_input.keys(QKeySequence(Qt::SHIFT | Qt::Key_R));
    m_input.keys(Qt::Key_N);
    m_input.hover(m_view, inView(0.55, 0.45));
    const auto* legend = m_view.findChild<ui::LookLegend*>();
    const bool told = legend->isVisible() && !legend->valueText().isEmpty();
    if (Status shown = expect(told, "the legend says the number under the pointer"); !shown) {
        return shown;
    }
    const Status taken = picture("false-colour");
    m_input.keys(QKeySequence(Qt::CTRL | Qt::Key_Home));
    const bool reset = m_window.settings().look() == render::Look();
    m_window.findChild<QDockWidget*>("brushPanel")->raise();
    return taken ? expect(reset, "Ctrl+Home shows values as they are") : taken;
}

} // namespace trixel::app
