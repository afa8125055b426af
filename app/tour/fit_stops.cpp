// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stop at levels fitted to a view.
#include <QDockWidget>
#include <QInputDialog>
#include <QSpinBox>

#include "app/tour/looks.h"
#include "app/tour/stops.h"
#include "ui/docks/fit_panel.h"
#include "ui/viewport/map_legend.h"
#include "ui/viewport/view_map.h"
#include "ui/viewport/viewport.h"
#include "ui/window/message_bar.h"

namespace trixel::app {

namespace {

/// A plan takes a slow machine minutes.
constexpr int kPatienceMs = 240'000;

} // namespace

/// A plan goes through every texel, and the tour has other stops: all faces get a low level first.
Status Stops::lowLevels()
{
    if (Status run = command("levels set"); !run) {
        return run;
    }
    auto* dialog = m_window.findChild<QInputDialog*>();
    if (Status asked = expect(dialog != nullptr, "Edit > Levels > Set Level asks for it"); !asked) {
        return asked;
    }
    auto* field = dialog->findChild<QSpinBox*>();
    m_input.type(*field, "2");
    m_input.press(*field, Qt::Key_Return);
    const bool offered =
        m_input.waitFor([&] { return m_window.messages().sentence().startsWith("Set level 2"); });
    if (Status told = expect(offered, "Set Level tells what it would cost"); !told) {
        return told;
    }
    if (Status pressed = press(m_window, "Apply"); !pressed) {
        return pressed;
    }
    const TexelStore& texels = m_window.document().texels();
    const bool set = m_input.waitFor(
        [&] { return texels.texelCount() == std::uint64_t{texels.faceCount()} * 16; });
    return expect(set, "Apply sets the level of all faces");
}

Status Stops::fittedLevels()
{
    const ui::Document& document = m_window.document();
    const ui::StateId before = document.state();
    if (Status low = lowLevels(); !low) {
        return low;
    }
    m_window.viewport().lookFrom(48, 12, 0.3);
    m_input.keys(QKeySequence(Qt::CTRL | Qt::Key_L));
    auto* panel = m_window.findChild<ui::FitPanel*>();
    if (Status shown = expect(panel->isVisible(), "Ctrl+L shows the panel of fits"); !shown) {
        return shown;
    }
    for (const char* button : {"Add the present view", "Plan the fit"}) {
        if (Status pressed = press(*panel, button); !pressed) {
            return pressed;
        }
    }
    const bool planned = m_input.waitFor([&] { return !panel->run().isRunning(); }, kPatienceMs);
    m_window.viewport().lookFrom(48, 12, 1.25);
    const ui::ViewMap& map = m_window.viewMap();
    const bool mapped = m_input.waitFor([&] { return map.isComplete(); }, kPatienceMs);
    m_input.hover(m_view, inView(0.45, 0.4));
    const bool told = !map.legend().valueText().isEmpty();
    if (Status done = expect(planned && panel->isCurrent() && mapped && told,
                             "a fit is planned and the errors it leaves are mapped");
        !done) {
        return done;
    }
    if (Status taken = picture("fit-to-scene"); !taken) {
        return taken;
    }
    if (Status pressed = press(*panel, "Apply the plan"); !pressed) {
        return pressed;
    }
    const LevelCost& cost = panel->run().outcome()->fit.plan.cost;
    const bool applied =
        cost.texelsAfter < cost.texelsBefore && document.texels().texelCount() == cost.texelsAfter;
    m_window.messages().dismiss();
    qobject_cast<QDockWidget*>(panel->parentWidget())->hide();
    m_view.setFocus();
    for (int k = 0; k < 3; ++k) { // the fit, the view, the levels
        m_input.keys(QKeySequence(Qt::CTRL | Qt::Key_Z));
    }
    return expect(applied && document.state() == before, "a fit is applied and taken back");
}

} // namespace trixel::app
