// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stops at the maps over the view and at the seam meter.
#include <QDockWidget>
#include <QTableView>

#include "app/tour/looks.h"
#include "app/tour/stops.h"
#include "ui/docks/seam_model.h"
#include "ui/docks/seam_panel.h"
#include "ui/viewport/map_legend.h"
#include "ui/viewport/view_map.h"
#include "ui/viewport/viewport.h"

namespace trixel::app {

namespace {

/// A map of a large window takes seconds, on a busy machine minutes.
constexpr int kPatienceMs = 240'000;

} // namespace

Status Stops::conditionMap()
{
    m_input.keys(Qt::Key_A);
    m_window.viewport().lookFrom(48, 12, 1.25);
    m_input.keys(QKeySequence(Qt::CTRL | Qt::Key_3));
    ui::ViewMap& map = m_window.viewMap();
    const bool complete = m_input.waitFor([&] { return map.isComplete(); }, kPatienceMs);
    m_input.hover(m_view, inView(0.55, 0.45));
    const bool told = !map.legend().valueText().isEmpty();
    if (Status shown = expect(complete && told, "Ctrl+3 maps the footprints' condition"); !shown) {
        return shown;
    }
    return picture("condition-map");
}

Status Stops::errorMap()
{
    m_window.settings().setMethod({"probes-1", 8});
    m_input.keys(QKeySequence(Qt::CTRL | Qt::Key_4));
    ui::ViewMap& map = m_window.viewMap();
    // Every second pixel a side is a picture; the rest would cost a slow machine minutes.
    const bool enough =
        m_input.waitFor([&] { return map.completeStep() == 2 || map.isComplete(); }, kPatienceMs);
    m_input.hover(m_view, inView(0.57, 0.45));
    if (Status shown = expect(enough && m_window.viewport().hasPicture(), "Ctrl+4 maps the error");
        !shown) {
        return shown;
    }
    const Status taken = picture("error-map");
    m_input.keys(QKeySequence(Qt::CTRL | Qt::Key_1));
    const bool gone = !m_window.viewport().hasPicture();
    return taken ? expect(gone, "Ctrl+1 shows the surface again") : taken;
}

Status Stops::seamMeter()
{
    auto* dock = m_window.findChild<QDockWidget*>("seamPanel");
    dock->raise();
    m_input.settle();
    ui::SeamPanel& panel = m_window.seams();
    if (Status pressed = press(panel, "Measure the seams"); !pressed) {
        return pressed;
    }
    const auto isMeasured = [&] { return panel.report() != nullptr && !panel.isMeasuring(); };
    bool measured = m_input.waitFor(isMeasured, kPatienceMs);
    // The panel follows the method of the view.
    m_window.settings().setMethod({"trilinear", std::nullopt});
    measured = measured && m_input.waitFor(isMeasured, kPatienceMs);
    if (Status done = expect(measured, "the seam meter measures two methods"); !done) {
        return done;
    }
    auto* table = panel.findChild<QTableView*>();
    const render::CameraPose before = m_window.viewport().camera().pose();
    m_input.click(*table->viewport(), table->visualRect(panel.model().index(0, 0)).center());
    const bool moved = !(m_window.viewport().camera().pose() == before);
    if (Status went = expect(moved, "a click on an edge goes there"); !went) {
        return went;
    }
    const Status taken = picture("seam-meter");
    m_window.findChild<QDockWidget*>("readoutPanel")->raise();
    m_window.viewport().markEdge(std::nullopt);
    m_window.settings().setMethod({});
    return taken;
}

} // namespace trixel::app
