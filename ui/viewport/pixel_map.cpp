// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/pixel_map.h"

#include <QRect>

#include "ui/document/run_within_memory.h"

#include <algorithm>
#include <cmath>

namespace trixel::ui {

PixelMap::PixelMap(Viewport& viewport, render::Side side, QObject* parent)
    : QObject(parent)
    , m_viewport(viewport)
    , m_side(side)
{
    connect(&m_watcher, &QFutureWatcherBase::resultsReadyAt, this, [this](int first, int last) {
        for (int k = first; k < last; ++k) {
            take(m_watcher.resultAt(k));
        }
    });
}

PixelMap::~PixelMap()
{
    m_watcher.disconnect(this);
    m_watcher.cancel();
    m_watcher.waitForFinished();
}

void PixelMap::begin(MapWork work)
{
    m_size = {work.camera.width, work.camera.height};
    if (work.map != ViewMapKind::Filtered) {
        m_values.assign(static_cast<std::size_t>(m_size.width()) *
                            static_cast<std::size_t>(m_size.height()),
                        std::nanf(""));
    }
    m_step = kMapSteps[0];
    m_watcher.setFuture(runWithinMemory<MapBand>(
        [work = std::move(work)](QPromise<MapBand>& promise) { computeMap(promise, work); }));
}

void PixelMap::drop()
{
    m_watcher.cancel();
    m_completeStep = 0;
    m_step = 0;
    m_rows = 0;
    m_values.clear();
    m_viewport.clearPicture(m_side);
}

double PixelMap::partOfStep() const
{
    return static_cast<double>(m_rows) / std::max(1, m_size.height());
}

std::optional<float> PixelMap::valueAt(QPoint pixel) const
{
    if (m_values.empty() || !QRect(QPoint(), m_size).contains(pixel)) {
        return std::nullopt;
    }
    const float value =
        m_values[static_cast<std::size_t>(pixel.x()) +
                 static_cast<std::size_t>(pixel.y()) * static_cast<std::size_t>(m_size.width())];
    return std::isnan(value) ? std::nullopt : std::optional(value);
}

void PixelMap::take(const MapBand& band)
{
    if (m_watcher.isCanceled()) {
        return; // of a view that is gone
    }
    const auto begin =
        static_cast<std::ptrdiff_t>(band.firstRow) * static_cast<std::ptrdiff_t>(m_size.width());
    std::ranges::copy(band.values, m_values.begin() + (band.values.empty() ? 0 : begin));
    m_viewport.setPictureRows(band.pixels, m_size, band.firstRow, m_side);
    m_step = band.step;
    m_rows = band.firstRow + static_cast<int>(band.pixels.size()) / std::max(1, m_size.width());
    if (band.endsPass) {
        m_completeStep = band.step;
    }
    emit progressed();
}

} // namespace trixel::ui
