// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/card_streaming.h"

#include <QElapsedTimer>
#include <QMetaObject>

#include "render/renderer.h"

#include <algorithm>
#include <limits>
#include <new>
#include <utility>

namespace trixel::ui {

namespace {

/// Bytes of one batch: taking it over is a small part of a frame.
constexpr std::size_t kBatchBytes = 256U << 10U;
/// Batches under way at once: enough that threads don't wait for frames.
constexpr std::size_t kBatches = 16;
/// Texels read in a frame for what was touched.
constexpr std::size_t kMostRead = 1U << 20U;

/// Means of what is painted wait until nothing changed for so long: while a snapshot is being read
/// painting has to copy what it shares with it.
constexpr int kPauseMs = 150;

constexpr int kSoon = 1; // before blocks
constexpr int kUsual = 0;

bool sameView(const render::Camera& a, const render::Camera& b)
{
    return a.pose() == b.pose() && a.viewport() == b.viewport();
}

} // namespace

CardStreaming::CardStreaming(QObject* parent)
    : QObject(parent)
{
    const int cores = QThread::idealThreadCount();
    m_pool.setMaxThreadCount(std::clamp(cores - 1, 1, 4));
    m_pool.setThreadPriority(QThread::LowPriority);
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPauseMs);
    connect(&m_pause, &QTimer::timeout, this, &CardStreaming::ready);
}

CardStreaming::~CardStreaming()
{
    m_pool.clear();
    m_pool.waitForDone();
}

/// Works on a thread, then tells. What a task refers to must be its own. One that runs out of
/// memory has no result.
template <class T, class Work>
CardStreaming::TaskPtr<T> CardStreaming::start(int priority, Work work)
{
    auto task = std::make_shared<Task<T>>();
    m_pool.start(
        [this, task, work = std::move(work)] {
            try {
                task->result = work();
            } catch (const std::bad_alloc&) {
                // Told where the result is looked for.
            }
            task->isDone = true;
            QMetaObject::invokeMethod(this, &CardStreaming::ready, Qt::QueuedConnection);
        },
        priority);
    return task;
}

void CardStreaming::Lane::forgetSnapshot()
{
    snapshot = nullptr;
    maker = nullptr;
}

void CardStreaming::tellNoMemory()
{
    if (!std::exchange(m_hasToldNoMemory, true)) {
        emit outOfMemory();
    }
}

void CardStreaming::setSurface(std::shared_ptr<const Surface> surface)
{
    forget();
    m_surface = std::move(surface);
    m_hasToldNoMemory = false;
    m_extents = nullptr;
    m_filterMesh = nullptr;
    m_vertexExtents = nullptr;
    if (m_surface) {
        m_extents = start<render::FaceExtents>(kSoon, [shown = m_surface] {
            return render::FaceExtents::of(shown->mesh(), Threads::all());
        });
    }
}

void CardStreaming::setFilterMesh(std::shared_ptr<const render::FilterMesh> mesh)
{
    if (mesh == m_filterMesh) {
        return;
    }
    vertexLane(render::Side::A) = {};
    vertexLane(render::Side::B) = {};
    m_filterMesh = std::move(mesh);
    m_vertexExtents = nullptr;
    if (m_surface && m_filterMesh) {
        m_vertexExtents =
            start<render::FaceExtents>(kSoon, [shown = m_surface, filterMesh = m_filterMesh] {
                return render::vertexExtents(shown->mesh(), *filterMesh, Threads::all());
            });
    }
}

void CardStreaming::forget()
{
    m_lanes = {};
}

void CardStreaming::texelsChanged()
{
    for (Lane& lane : m_lanes) {
        if (lane.maker) {
            m_pool.start([maker = std::move(lane.maker)]() mutable { maker = nullptr; }, kUsual);
        }
        lane.forgetSnapshot();
    }
    m_pause.start();
}

bool CardStreaming::isBusy() const
{
    return std::ranges::any_of(m_lanes, [](const Lane& lane) {
        return lane.opening || lane.plan || !lane.batches.empty();
    });
}

const std::shared_ptr<const TexelStore>& CardStreaming::snapshotOf(Lane& lane,
                                                                   const TexelStore& store)
{
    if (!lane.snapshot) {
        lane.snapshot = std::make_shared<const TexelStore>(store);
    }
    return lane.snapshot;
}

bool CardStreaming::send(render::Renderer& renderer,
                         const render::Camera& camera,
                         const TexelStore& store,
                         render::Side side,
                         double milliseconds)
{
    QElapsedTimer clock;
    clock.start();
    const auto limit = static_cast<qint64>(milliseconds * 1e6);
    const auto hasTime = [&] { return clock.nsecsElapsed() < limit; };
    render::DisplayVertices* vertices = renderer.vertices(store, side);
    bool hasMore = false;
    if (vertices != nullptr && m_vertexExtents) {
        const auto sendReady = [&] { renderer.sendReadyVertices(store, kMostRead, side); };
        hasMore =
            send({vertexLane(side), *vertices, m_vertexExtents, store, camera, sendReady, hasTime});
    } else {
        vertexLane(side) = {};
    }
    const auto sendReady = [&] { renderer.sendReady(store, kMostRead, side); };
    const bool isShown = m_showsTexels || vertices == nullptr || !vertices->isShown();
    return send({texelLane(side),
                 renderer.display(side),
                 m_extents,
                 store,
                 camera,
                 sendReady,
                 hasTime,
                 isShown}) ||
           hasMore;
}

bool CardStreaming::send(const Frame& frame)
{
    Lane& lane = frame.lane;
    open(frame);
    plan(frame);
    frame.sendReady();
    while (frame.display.isOpening() && frame.hasTime()) {
        frame.sendReady();
    }
    while (!frame.display.isOpening() && !lane.batches.empty() &&
           lane.batches.front().made->isDone && frame.hasTime()) {
        const Batch batch = std::move(lane.batches.front());
        lane.batches.pop_front();
        if (!batch.made->result) { // what is shown stays as coarse as it is
            frame.display.giveUp(batch.jobs);
            tellNoMemory();
            continue;
        }
        frame.display.accept(*batch.made->result, batch.jobs, frame.store);
        frame.sendReady();
    }
    plan(frame); // blocks may have found no room
    giveOut(frame);
    const bool isNextReady = !lane.batches.empty() && lane.batches.front().made->isDone;
    return isNextReady || frame.display.isOpening() ||
           (frame.display.hasReady() && !frame.display.needsOpening());
}

/// What there is to show at the least comes before all else.
void CardStreaming::open(const Frame& frame)
{
    Lane& lane = frame.lane;
    render::DisplayBlocks& display = frame.display;
    if (display.isOpening()) {
        return; // one after the other
    }
    if (lane.opening && lane.opening->isDone && !lane.opening->result) {
        lane.opening = nullptr; // and is not tried again before it is needed anew
        lane.failedOpening = lane.openingNumber;
        tellNoMemory();
    }
    if (lane.opening && lane.opening->isDone) {
        render::PreparedOpening& made = *lane.opening->result;
        if (display.canOpen(made) && made.opening.form == display.form() &&
            made.opening.faces.size() == frame.store.faceCount()) {
            display.open(std::move(made));
            if (lane.openingNumber != display.openingNumber()) {
                display.touchAll(); // of what is by now: better shown late than never
            }
        }
        lane.opening = nullptr;
    }
    if (display.needsOpening() && !lane.opening && lane.failedOpening != display.openingNumber()) {
        lane.forgetSnapshot(); // it may be of another store
        lane.openingNumber = display.openingNumber();
        lane.opening = start<render::PreparedOpening>(
            kSoon, [snapshot = snapshotOf(lane, frame.store), opener = display.opener()] {
                return opener(*snapshot);
            });
    }
}

/// One plan at a time: views that came and went meanwhile are passed over.
void CardStreaming::plan(const Frame& frame)
{
    Lane& lane = frame.lane;
    render::DisplayBlocks& display = frame.display;
    if (lane.plan && lane.plan->isDone && !lane.plan->result) {
        lane.plan = nullptr; // views to come may be planned for
        lane.hasPlanFailed = true;
        tellNoMemory();
    }
    if (lane.plan && lane.plan->isDone) {
        if (lane.plannedOpening == display.openingNumber()) {
            display.follow(std::move(*lane.plan->result));
        } else {
            lane.planned.reset(); // what was there when it was made is no more
        }
        lane.plan = nullptr;
    }
    const bool isOpen =
        !display.needsOpening() && !display.isOpening() && !display.records().empty();
    const bool isNew = (display.needsPlan() && !lane.hasPlanFailed) || !lane.planned ||
                       !sameView(*lane.planned, frame.camera);
    const bool hasExtents = frame.extents && frame.extents->isDone && frame.extents->result;
    if (!frame.isShown || !isOpen || lane.plan || !isNew || !hasExtents) {
        return;
    }
    lane.hasPlanFailed = false;
    lane.planned = frame.camera;
    lane.plannedOpening = display.openingNumber();
    lane.plan = start<render::ResidencyPlan>(
        kSoon,
        [extents = frame.extents,
         camera = frame.camera,
         faces = display.facesOnCard(),
         room = display.mostRoom()]() -> render::ResidencyPlan {
            std::vector<render::Wish> wishes(faces.size());
            render::wishesOf(*extents->result, camera, Threads::all(), wishes);
            return render::planResidency(wishes, faces, room);
        });
}

void CardStreaming::giveOut(const Frame& frame)
{
    Lane& lane = frame.lane;
    render::DisplayBlocks& display = frame.display;
    const bool means = !m_pause.isActive();
    bool isFirst = lane.batches.empty();
    while ((std::exchange(isFirst, false) || frame.hasTime()) && lane.batches.size() < kBatches &&
           frame.isShown && display.hasJobs(means)) {
        render::JobBatch jobs = display.nextJobs(kBatchBytes, means);
        if (jobs.jobs.empty()) {
            break;
        }
        const auto& snapshot = snapshotOf(lane, frame.store);
        if (!lane.maker) {
            lane.maker = display.maker();
        }
        auto made = start<render::MadeBlocks>(
            kUsual, [snapshot, make = lane.maker, of = jobs.jobs] { return make(*snapshot, of); });
        lane.batches.push_back({std::move(jobs), std::move(made)});
    }
    if (lane.batches.empty() && !lane.opening) {
        // Painting would copy what a snapshot shares. What was kept to make blocks takes long to
        // let go of.
        if (lane.maker) {
            m_pool.start([maker = std::move(lane.maker)]() mutable { maker = nullptr; }, kUsual);
        }
        lane.forgetSnapshot();
    }
}

void CardStreaming::finish(render::Renderer& renderer,
                           const render::Camera& camera,
                           const TexelStore& store,
                           render::Side side)
{
    const auto isWaiting = [&](const Lane& lane) {
        return lane.opening || lane.plan || !lane.batches.empty();
    };
    m_pause.stop();
    bool hasMore = true;
    while (hasMore) {
        m_pool.waitForDone();
        hasMore = send(renderer, camera, store, side, std::numeric_limits<int>::max());
        const render::DisplayVertices* vertices = renderer.vertices(store, side);
        hasMore = hasMore || isWaiting(texelLane(side)) || isWaiting(vertexLane(side)) ||
                  renderer.display(side).needsOpening() ||
                  (vertices != nullptr && m_vertexExtents && vertices->needsOpening());
    }
}

} // namespace trixel::ui
