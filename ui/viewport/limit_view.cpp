// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/limit_view.h"

#include <QtConcurrent>

#include "core/base/parallel.h"
#include "core/mesh/limit_bends.h"
#include "core/paint/paint_surface.h"

#include <utility>

namespace trixel::ui {

namespace {

class UntilStopped final : public Progress
{
public:
    explicit UntilStopped(const std::atomic<bool>& stop)
        : m_stop(stop)
    {
    }
    bool report(double /*fraction*/) override { return !m_stop; }

private:
    const std::atomic<bool>& m_stop;
};

/// The camera's picture, for errors in its pixels.
ErrorScale scaleOf(const render::Camera& camera)
{
    const glm::dmat4 projection(camera.projection());
    PictureView view;
    view.toCamera = glm::dmat4(camera.view());
    view.halfSize = glm::dvec2(camera.viewport()) / 2.0;
    view.focalLength = projection[1][1] * view.halfSize.y;
    view.nearestDepth = projection[3][2] / (projection[2][2] - 1);
    return ErrorScale::ofPicture(view);
}

} // namespace

LimitView::LimitView(QObject* parent)
    : QObject(parent)
{
    connect(&m_watcher, &QFutureWatcherBase::finished, this, &LimitView::take);
}

LimitView::~LimitView()
{
    m_watcher.disconnect(this);
    stop();
}

void LimitView::stop()
{
    if (std::exchange(m_isBusy, false)) {
        *m_stop = true; // it ends a little later, and owns what it reads
        m_watcher.setFuture({});
    }
}

void LimitView::setSurface(std::shared_ptr<const Surface> surface)
{
    stop();
    m_surface = std::move(surface);
    m_isPossible = false;
    m_solid.reset();
    rest();
    refuse({});
    next();
}

void LimitView::refuse(const QString& why)
{
    if (m_refusal != why) {
        m_refusal = why;
        emit refusalChanged();
    }
}

void LimitView::want(const render::Camera& camera, double error)
{
    const bool isAsked = m_error == error && m_pose == camera.pose() && m_size == camera.viewport();
    if (isAsked || !m_refusal.isEmpty()) {
        return;
    }
    m_error = error;
    m_pose = camera.pose();
    m_size = camera.viewport();
    m_demand = LimitDemand{scaleOf(camera), error};
    next();
}

void LimitView::rest()
{
    m_demand.reset();
    m_error = 0; // whatever is wanted next is new
    const bool hadMesh = std::exchange(m_mesh, nullptr) != nullptr;
    if (std::exchange(m_cut, nullptr)) {
        emit tessellated();
    }
    if (hadMesh) {
        emit meshChanged();
    }
}

template <class Work>
void LimitView::start(Work work)
{
    m_isBusy = true;
    m_stop = std::make_shared<std::atomic<bool>>(false);
    m_watcher.setFuture(QtConcurrent::run([work = std::move(work), stop = m_stop]() -> Made {
        UntilStopped progress(*stop);
        return work(progress);
    }));
}

/// Begins what is missing first.
void LimitView::next()
{
    if (m_isBusy || !m_surface || !m_refusal.isEmpty()) {
        return;
    }
    if (!m_isPossible) {
        start([surface = m_surface](Progress& /*progress*/) {
            Made made;
            const Status status = LimitSurface::check(surface->mesh());
            made.isPossible = status.has_value();
            if (!status) {
                made.refusal = status.error().message;
            }
            return made;
        });
    } else if (m_demand && !m_solid) {
        start([surface = m_surface](Progress& progress) {
            Made made;
            if (auto solid = limitToPaintOn(*surface, {}, Threads::all(), progress)) {
                made.solid = std::move(*solid);
            } else {
                made.refusal = solid.error().message;
            }
            return made;
        });
    } else if (m_cut && (!m_mesh || m_mesh->sharedTessellation() != m_cut)) {
        start([cut = m_cut](Progress& /*progress*/) {
            Made made;
            made.mesh = LimitMesh::build(cut);
            return made;
        });
    } else if (m_demand) {
        start([demand = *std::exchange(m_demand, std::nullopt),
               before = m_cut,
               bends = m_solid->tessellation().sharedBends()](Progress& progress) {
            Made made;
            if (before && before->isAsDemanded(demand)) {
                return made;
            }
            if (auto cut =
                    LimitTessellation::make(bends, demand, before, Threads::all(), progress)) {
                made.cut = std::move(*cut);
            }
            return made;
        });
    }
}

void LimitView::take()
{
    if (!m_isBusy || !m_watcher.isFinished()) {
        return; // taken already, by `finish`
    }
    m_isBusy = false;
    const Made made = m_watcher.result();
    if (made.refusal) {
        rest();
        refuse(QString::fromStdString(*made.refusal));
        return;
    }
    m_isPossible = m_isPossible || made.isPossible;
    const bool isWanted = m_error > 0; // else it was given up meanwhile
    if (made.solid) {
        m_solid = made.solid;
    }
    if (made.cut && isWanted) {
        m_cut = made.cut;
        emit tessellated();
    }
    if (made.mesh && isWanted && made.mesh->sharedTessellation() == m_cut) {
        m_mesh = made.mesh;
        emit meshChanged();
    }
    next();
}

void LimitView::finish()
{
    while (m_isBusy) {
        m_watcher.waitForFinished();
        take();
    }
}

} // namespace trixel::ui
