// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/distortion_view.h"

#include <QtConcurrent>

#include "ui/import/distortion_scale.h"
#include "ui/viewport/map_legend.h"
#include "ui/viewport/viewport.h"

#include <new>
#include <utility>

namespace trixel::ui {

DistortionView::DistortionView(Viewport& viewport, QObject* parent)
    : QObject(parent)
    , m_viewport(viewport)
    , m_legend(new MapLegend(&viewport))
{
    m_legend->setObjectName("distortionLegend");
    m_thread.setMaxThreadCount(1);
    connect(&m_watcher, &QFutureWatcherBase::finished, this, &DistortionView::takeAnswer);
    connect(&viewport, &Viewport::cameraChanged, m_legend, &MapLegend::place);
    connect(&viewport, &Viewport::hovered, this, &DistortionView::hover);
}

DistortionView::~DistortionView()
{
    m_watcher.disconnect(this);
    m_watcher.waitForFinished();
}

void DistortionView::ask(ImportInput input, DistortionMeasure measure)
{
    m_isAsked = true;
    m_waiting = Wanted{std::move(input), measure};
    if (!m_isRunning) {
        begin();
    }
}

void DistortionView::drop()
{
    m_isAsked = false;
    m_waiting.reset();
    if (std::exchange(m_shown, nullptr)) {
        m_viewport.setFaceColors({});
        m_legend->setMap(ViewMapKind::None, {});
        emit changed();
    }
}

void DistortionView::begin()
{
    m_isRunning = true;
    m_watcher.setFuture(
        QtConcurrent::run(&m_thread, [wanted = *std::exchange(m_waiting, {})]() -> Answer {
            try {
                auto made = distortionColors(wanted.input, wanted.measure);
                return made ? std::make_shared<const DistortionColors>(std::move(*made)) : nullptr;
            } catch (const std::bad_alloc&) {
                return nullptr; // the surface is shown as it is
            }
        }));
}

/// Also what is no longer the latest is shown: a map that follows a dragged corner late follows it.
void DistortionView::takeAnswer()
{
    m_isRunning = false;
    const Answer made = m_watcher.result();
    if (m_waiting) {
        begin();
    }
    if (!m_isAsked) {
        return;
    }
    m_shown = made;
    m_viewport.setFaceColors(made ? made->colors : std::vector<std::uint32_t>());
    if (made) {
        m_legend->setMap(
            ViewMapKind::Density, distortionTitle(made->measure), distortionScale(made->measure));
    } else {
        m_legend->setMap(ViewMapKind::None, {});
    }
    hover(m_viewport.inspectedTexel());
    emit changed();
}

/// In the legend's last line.
void DistortionView::hover(const std::optional<HoveredTexel>& texel)
{
    if (!m_shown) {
        return;
    }
    if (!texel) {
        m_legend->setState({});
        return;
    }
    const double number = distortionAt(*m_shown, texel->point.face, glm::dvec2(texel->point.uv));
    m_legend->setState(tr("Under the pointer: %1").arg(distortionText(m_shown->measure, number)));
}

} // namespace trixel::ui
