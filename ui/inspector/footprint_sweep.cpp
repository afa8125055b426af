// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/footprint_sweep.h"

#include "ui/document/run_within_memory.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trixel::ui {

namespace {

SweepPoint pointAt(const FilterScene& scene,
                   const FilterMethod& method,
                   const FilterMethod& exact,
                   double range,
                   const FootprintSweep::Angle& angle)
{
    QueryArrays query;
    query.add(angle.placed.face,
              glm::vec2(angle.placed.uv),
              glm::vec2(angle.placed.footprint.w1),
              glm::vec2(angle.placed.footprint.w2));
    ResultArrays own(1, scene.channels());
    ResultArrays judge(1, scene.channels());
    method.filter(scene, query.queries(), own.results());
    exact.filter(scene, query.queries(), judge.results());
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    SweepPoint point{angle.degrees, angle.anisotropy, double{own.levels.front()}, 0, 0};
    const bool refused = own.taps.front() == kRefusedTaps;
    point.taps = refused ? kNone : own.taps.front();
    if (refused || judge.taps.front() == kRefusedTaps) {
        point.error = kNone;
        return point;
    }
    for (std::size_t c = 0; c < own.values.size(); ++c) {
        point.error =
            std::max(point.error, std::abs(double{own.values[c]} - double{judge.values[c]}));
    }
    point.error = range > 0 ? point.error / range : 0;
    return point;
}

} // namespace

FootprintSweep::FootprintSweep(QObject* parent)
    : QObject(parent)
{
    connect(&m_watcher, &QFutureWatcherBase::resultReadyAt, this, [this](int index) {
        m_points.push_back(m_watcher.resultAt(index));
        emit changed();
    });
}

FootprintSweep::~FootprintSweep()
{
    m_watcher.disconnect(this);
    m_watcher.cancel();
    m_watcher.waitForFinished();
}

void FootprintSweep::start(const std::shared_ptr<const FilterScene>& scene,
                           const MethodChoice& method,
                           double range,
                           std::vector<Angle> angles)
{
    m_watcher.cancel();
    m_points.clear();
    // What was under way tells a future that nobody watches any more, and ends at its next angle.
    m_watcher.setFuture(runWithinMemory<SweepPoint>(
        [scene, method, range, angles = std::move(angles)](QPromise<SweepPoint>& promise) {
            const auto own = makeMethod(method);
            const auto exact = makeMethod({"exact", std::nullopt});
            for (const Angle& angle : angles) {
                if (promise.isCanceled()) {
                    return;
                }
                promise.addResult(pointAt(*scene, *own, *exact, range, angle));
            }
        }));
    emit changed();
}

void FootprintSweep::clear()
{
    m_watcher.cancel();
    m_watcher.setFuture({});
    m_points.clear();
    emit changed();
}

} // namespace trixel::ui
