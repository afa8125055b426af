// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stops at what is measured: speed against accuracy, and stability.
#include <QAbstractButton>
#include <QDockWidget>

#include "app/tour/stops.h"
#include "ui/charts/write_chart.h"
#include "ui/docks/chart_panel.h"
#include "ui/docks/chart_view.h"
#include "ui/docks/stability_panel.h"
#include "ui/viewport/view_settings.h"
#include "ui/window/message_bar.h"

#include <algorithm>

namespace trixel::app {

namespace {

/// A study may take minutes on a busy machine: then its first points have to do.
constexpr int kStudyMs = 60'000;
constexpr int kPatienceMs = 120'000;

Status expect(bool holds, const std::string& sentence)
{
    return holds ? Status() : contentsError("tour: " + sentence);
}

/// A point of the front that is neither its start nor its end.
std::optional<std::size_t> pointInTheMiddle(const ui::ChartView& view)
{
    const std::vector<ui::PlotMark> front = frontOf(view.plot());
    return front.size() < 3 ? std::nullopt
                            : std::optional(pointOf(view.plot(), front[front.size() / 2]).source);
}

} // namespace

Status Stops::press(QWidget& panel, const QString& name)
{
    for (QAbstractButton* button : panel.findChildren<QAbstractButton*>()) {
        if (button->accessibleName() == name && button->isVisible() && button->isEnabled()) {
            m_input.click(*button, button->rect().center());
            return {};
        }
    }
    return contentsError("tour: there is no button '" + name.toStdString() + "' to press");
}

Status Stops::measuredChart()
{
    m_window.messages().dismiss();
    m_input.keys(Qt::Key_F8);
    auto* panel = m_window.findChild<ui::ChartPanel*>();
    if (Status shown = expect(panel != nullptr && panel->isVisible(), "F8 shows the chart");
        !shown) {
        return shown;
    }
    if (Status pressed = press(*panel, "Run the study"); !pressed) {
        return pressed;
    }
    if (!m_input.waitFor([&] { return !panel->run().isRunning(); }, kStudyMs)) {
        if (Status cancelled = press(*panel, "Cancel the study"); !cancelled) {
            return cancelled;
        }
    }
    const bool measured = m_input.waitFor([&] { return !panel->run().isRunning(); }, kPatienceMs);
    const auto point = pointInTheMiddle(panel->view());
    if (Status done = expect(measured && point.has_value(), "the study ends with a front"); !done) {
        return done;
    }
    const QPoint at = panel->view().positionOf(*point).value_or(QPointF()).toPoint();
    m_input.click(panel->view(), at);
    const bool chosen = m_window.settings().method() == panel->run().study().points[*point].method;
    if (Status clicked = expect(chosen, "a click on a point chooses its method"); !clicked) {
        return clicked;
    }
    m_input.hover(panel->view(), at);
    if (Status taken = picture("speed-and-accuracy"); !taken) {
        return taken;
    }
    return ui::writeChart(panel->run().study(), m_folder / "speed-accuracy.svg");
}

Status Stops::sweptHazards()
{
    m_input.keys(Qt::Key_F9);
    auto* panel = m_window.findChild<ui::StabilityPanel*>();
    if (Status shown = expect(panel != nullptr, "F9 shows the stability report"); !shown) {
        return shown;
    }
    if (auto* dock = qobject_cast<QDockWidget*>(panel->parentWidget())) {
        dock->raise();
    }
    m_input.settle();
    if (Status pressed = press(*panel, "Run the sweeps"); !pressed) {
        return pressed;
    }
    const bool swept = m_input.waitFor([&] { return !panel->run().isRunning(); }, kPatienceMs);
    if (Status done =
            expect(swept && !panel->run().report().sweeps.empty(), "the sweeps end with a report");
        !done) {
        return done;
    }
    return picture("stability");
}

} // namespace trixel::app
