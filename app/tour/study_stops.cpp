// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stops at what is measured: speed against accuracy, and stability.
#include <QAbstractButton>
#include <QComboBox>
#include <QDockWidget>

#include "app/tour/looks.h"
#include "app/tour/stops.h"
#include "ui/charts/write_chart.h"
#include "ui/docks/chart_panel.h"
#include "ui/docks/chart_view.h"
#include "ui/docks/stability_panel.h"
#include "ui/viewport/view_settings.h"
#include "ui/window/message_bar.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace trixel::app {

namespace {

/// A study may take minutes on a busy machine: then its first points have to do.
constexpr int kStudyMs = 60'000;
constexpr int kPatienceMs = 120'000;

/// Pixels from a point to the nearest other one.
double roomAbout(const ui::ChartView& view, std::size_t source)
{
    const QPointF at = view.positionOf(source).value_or(QPointF());
    double room = std::numeric_limits<double>::infinity();
    for (const ui::PlotSeries& series : view.plot().series) {
        for (const ui::PlotPoint& other : series.points) {
            if (other.source != source) {
                const QPointF apart = view.positionOf(other.source).value_or(QPointF()) - at;
                room = std::min(room, std::hypot(apart.x(), apart.y()));
            }
        }
    }
    return room;
}

/// The middle one of the front's points that a click can choose: peers cannot be chosen, nor a
/// point that another one covers. Which these are differs from run to run: they were measured just
/// now.
std::optional<std::size_t> pointInTheMiddle(const ui::ChartView& view)
{
    constexpr double kRoom = 8;
    std::vector<std::size_t> points;
    for (const ui::PlotMark& mark : frontOf(view.plot())) {
        const std::size_t source = pointOf(view.plot(), mark).source;
        if (!view.plot().series[mark.series].isPeer && roomAbout(view, source) >= kRoom) {
            points.push_back(source);
        }
    }
    return points.empty() ? std::nullopt : std::optional(points[points.size() / 2]);
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

Status Stops::runStudy(ui::ChartPanel& panel)
{
    if (Status pressed = press(panel, "Run the study"); !pressed) {
        return pressed;
    }
    const auto isDone = [&] { return !panel.run().isRunning(); };
    if (!m_input.waitFor(isDone, kStudyMs)) {
        if (Status cancelled = press(panel, "Cancel the study"); !cancelled) {
            return cancelled;
        }
    }
    return expect(m_input.waitFor(isDone, kPatienceMs), "the study ends");
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
    if (Status measured = runStudy(*panel); !measured) {
        return measured;
    }
    const auto point = pointInTheMiddle(panel->view());
    if (Status done = expect(point.has_value(), "the study ends with a front"); !done) {
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

/// After the chart of filters, which has shown the panel.
Status Stops::viewOnTheChart()
{
    auto* panel = m_window.findChild<ui::ChartPanel*>();
    auto* studies = panel == nullptr ? nullptr : panel->findChild<QComboBox*>();
    const int view = studies == nullptr ? -1 : studies->findText("View");
    if (Status found = expect(view >= 0, "the view's ways of drawing can be studied"); !found) {
        return found;
    }
    m_input.press(*studies, Qt::Key_Home);
    for (int k = 0; k < view; ++k) {
        m_input.press(*studies, Qt::Key_Down);
    }
    if (Status chosen = expect(studies->currentIndex() == view, "arrows choose a study"); !chosen) {
        return chosen;
    }
    if (Status measured = runStudy(*panel); !measured) {
        return measured;
    }
    if (Status taken = picture("view-on-the-chart"); !taken) {
        return taken;
    }
    return ui::writeChart(panel->run().study(), m_folder / "view-filtering.svg");
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
