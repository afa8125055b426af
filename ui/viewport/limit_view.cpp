// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/limit_view.h"

#include <QPromise>
#include <QtConcurrent>

#include "core/base/parallel.h"
#include "core/mesh/limit_bends.h"
#include "core/paint/paint_surface.h"
#include "ui/document/background_job.h"

#include <new>
#include <utility>

namespace trixel::ui {

namespace {

class UntilStopped final : public Progress
{
public:
    UntilStopped(const std::atomic<bool>& stop, Progress& watched)
        : m_stop(stop)
        , m_watched(watched)
    {
    }
    bool report(double fraction) override { return m_watched.report(fraction) && !m_stop; }

private:
    const std::atomic<bool>& m_stop;
    Progress& m_watched;
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

void LimitView::setSurface(std::shared_ptr<const Surface> surface, CreaseAngle creases)
{
    stop();
    m_surface = std::move(surface);
    m_creases = creases;
    m_hasOldCreases = false;
    m_isPossible = false;
    m_solid.reset();
    rest();
    refuse({});
    next();
}

/// What is there stays to be seen and painted on until the other one is.
void LimitView::setCreases(CreaseAngle creases)
{
    m_creases = creases;
    m_hasOldCreases = true;
    if (m_isBusy) {
        *m_stop = true; // taken when it has ended: there is never more than one at work
    }
    if (m_error > 0) {
        m_demand = m_wanted;
    }
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
    m_wanted = LimitDemand{scaleOf(camera), error};
    m_demand = m_wanted;
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

/// \param jobTitle  of work that may take long; none: nobody watches it
template <class Work>
void LimitView::start(Work work, const QString& jobTitle)
{
    m_isBusy = true;
    m_stop = std::make_shared<std::atomic<bool>>(false);
    auto run = [work = std::move(work), stop = m_stop](Progress& watched) -> Made {
        UntilStopped progress(*stop, watched);
        try {
            return work(progress);
        } catch (const std::bad_alloc&) {
            Made none;
            none.refusal = "There is not enough memory for the limit surface.";
            return none;
        }
    };
    if (m_jobs == nullptr || jobTitle.isEmpty()) {
        m_watcher.setFuture(QtConcurrent::run([run = std::move(run)]() -> Made {
            NoProgress nobody;
            return run(nobody);
        }));
        return;
    }
    // Ends without a result when the job is cancelled before it has begun.
    auto promise = std::make_shared<QPromise<Made>>();
    promise->start();
    m_watcher.setFuture(promise->future());
    m_jobs->run(
        jobTitle,
        [run = std::move(run), promise = std::move(promise)](Progress& progress) -> Status {
            promise->addResult(run(progress));
            promise->finish();
            return {};
        },
        [](const Status&) {});
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
    } else if (m_demand && (!m_solid || m_hasOldCreases)) {
        makeSolid();
    } else if (m_cut && (!m_mesh || m_mesh->sharedTessellation() != m_cut)) {
        makeMesh();
    } else if (m_demand) {
        makeCut();
    }
}

void LimitView::makeSolid()
{
    m_hasOldCreases = false;
    start(
        [surface = m_surface, creases = m_creases](Progress& progress) {
            Made made;
            if (auto solid = limitToPaintOn(*surface, creases, Threads::all(), progress)) {
                made.solid = std::move(*solid);
            } else if (solid.error().kind == ErrorKind::Cancelled) {
                made.isCancelled = true;
            } else {
                made.refusal = solid.error().message;
            }
            return made;
        },
        tr("Making the limit surface"));
}

void LimitView::makeMesh()
{
    start([cut = m_cut](Progress& /*progress*/) {
        Made made;
        made.mesh = LimitMesh::build(cut);
        return made;
    });
}

void LimitView::makeCut()
{
    const auto& bends = m_solid->tessellation().sharedBends();
    const bool isFirst = m_cut == nullptr;
    const auto before = m_cut && m_cut->sharedBends() == bends ? m_cut : nullptr;
    start(
        [demand = *std::exchange(m_demand, std::nullopt), before, bends](Progress& progress) {
            Made made;
            if (before && before->isAsDemanded(demand)) {
                return made;
            }
            if (auto cut =
                    LimitTessellation::make(bends, demand, before, Threads::all(), progress)) {
                made.cut = std::move(*cut);
            } else {
                made.isCancelled = true;
            }
            return made;
        },
        isFirst ? tr("Cutting the limit surface into triangles") : QString());
}

void LimitView::take()
{
    if (!m_isBusy || !m_watcher.isFinished()) {
        return; // taken already, by `finish`
    }
    m_isBusy = false;
    const bool isOurs = *m_stop; // stopped for another to begin
    Made made;
    made.isCancelled = true;
    if (m_watcher.future().resultCount() > 0) {
        made = m_watcher.result();
    }
    if (made.refusal) {
        rest();
        refuse(QString::fromStdString(*made.refusal));
        return;
    }
    if (made.isCancelled && !isOurs) {
        rest();
        emit cancelled();
        return;
    }
    keep(made);
    next();
}

void LimitView::keep(const Made& made)
{
    m_isPossible = m_isPossible || made.isPossible;
    const bool isWanted = m_error > 0; // else it was given up meanwhile
    if (made.solid) {                  // of creases before, it is followed by another
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
}

void LimitView::finish()
{
    while (m_isBusy) {
        m_watcher.waitForFinished();
        take();
    }
}

} // namespace trixel::ui
