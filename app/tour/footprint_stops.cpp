// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stop at the footprint of a pixel.
#include <QDockWidget>
#include <QMainWindow>
#include <QToolButton>

#include "app/tour/looks.h"
#include "app/tour/stops.h"
#include "ui/inspector/footprint_net_view.h"
#include "ui/inspector/footprint_panel.h"
#include "ui/viewport/viewport.h"

namespace trixel::app {

namespace {

constexpr int kPatienceMs = 120'000;

} // namespace

Status Stops::footprint()
{
    m_input.keys(QKeySequence(Qt::SHIFT | Qt::Key_F5));
    auto* dock = m_window.findChild<QDockWidget*>("footprintPanel");
    auto* panel = m_window.findChild<ui::FootprintPanel*>();
    if (Status shown = expect(dock != nullptr && panel != nullptr && panel->isVisible(),
                              "Shift+F5 opens the footprint");
        !shown) {
        return shown;
    }
    // Brush and look leave the whole height to it.
    m_input.keys(Qt::Key_F2);
    m_input.keys(QKeySequence(Qt::SHIFT | Qt::Key_F2));
    const int width = dock->width();
    m_window.resizeDocks({dock}, {660}, Qt::Horizontal);
    m_input.keys(Qt::Key_A);
    m_window.viewport().lookFrom(48, 12, 1.25);
    m_input.wheel(m_view, inView(0.4, 0.4), 9);
    m_input.hover(m_view, inView(0.45, 0.45));
    m_window.inspection().hold();
    panel->setFrozen(true);
    // The same texel from a grazing view, the first footprint beside it.
    const render::CameraPose before = m_window.viewport().camera().pose();
    render::CameraPose pose = before;
    pose.yaw += 0.9;
    m_window.viewport().setCamera(pose);
    panel->setWeightsOnSurface(true);
    const auto isWeighed = [panel] {
        const auto& picture = panel->netView().picture();
        return picture && picture->weights && picture->frozen;
    };
    bool done = m_input.waitFor(isWeighed, kPatienceMs);
    ui::FootprintNetView& net = panel->netView();
    const QPoint handle = done ? net.handleAt(ui::NetHandle::W2)->toPoint() : QPoint();
    const QPoint path[] = {handle, handle + QPoint(12, -8), handle + QPoint(26, -14)};
    m_input.drag(net, path);
    done = done && panel->probe().source() == ui::FootprintSource::ByHand;
    if (Status dragged = expect(done, "W2 can be dragged"); !dragged) {
        return dragged;
    }
    (void)m_input.waitFor(isWeighed, kPatienceMs);
    m_input.settle();
    const Status taken = picture("footprint");
    panel->setFrozen(false);
    panel->setWeightsOnSurface(false);
    panel->probe().setSource(ui::FootprintSource::Screen);
    m_window.inspection().letGo();
    m_window.viewport().setCamera(before);
    m_window.resizeDocks({dock}, {width}, Qt::Horizontal);
    m_input.keys(QKeySequence(Qt::SHIFT | Qt::Key_F5));
    m_input.keys(QKeySequence(Qt::SHIFT | Qt::Key_F2));
    m_input.keys(Qt::Key_F2);
    return taken;
}

} // namespace trixel::app
