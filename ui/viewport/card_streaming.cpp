// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/card_streaming.h"

#include <QElapsedTimer>
#include <QMetaObject>

#include "render/renderer.h"

#include <algorithm>
#include <limits>
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

/// Works on a thread, then tells. What a task refers to must be its own.
template <class T, class Work>
CardStreaming::TaskPtr<T> CardStreaming::start(int priority, Work work)
{
    auto task = std::make_shared<Task<T>>();
    m_pool.start(
        [this, task, work = std::move(work)] {
            task->result = work();
            task->isDone = true;
            QMetaObject::invokeMethod(this, &CardStreaming::ready, Qt::QueuedConnection);
        },
        priority);
    return task;
}

void CardStreaming::setSurface(std::shared_ptr<const Surface> surface)
{
    forget();
    m_surface = std::move(surface);
    m_extents = nullptr;
    if (m_surface) {
        m_extents = start<render::FaceExtents>(kSoon, [shown = m_surface] {
            return render::FaceExtents::of(shown->mesh(), Threads::all());
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
        lane.snapshot = nullptr;
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
    Lane& lane = m_lanes[static_cast<std::size_t>(side)];
    render::DisplayTexels& display = renderer.display(side);
    open(lane, display, store);
    plan(lane, display, camera);
    renderer.sendReady(store, kMostRead, side);
    while (!lane.batches.empty() && lane.batches.front().made->isDone &&
           clock.nsecsElapsed() < limit) {
        const Batch batch = std::move(lane.batches.front());
        lane.batches.pop_front();
        display.accept(*batch.made->result, batch.jobs, store);
        renderer.sendReady(store, kMostRead, side);
    }
    plan(lane, display, camera); // blocks may have found no room
    giveOut(lane, display, store, !m_pause.isActive());
    const bool isNextReady = !lane.batches.empty() && lane.batches.front().made->isDone;
    return isNextReady || (display.hasReady() && !display.needsOpening());
}

/// What there is to show at the least comes before all else.
void CardStreaming::open(Lane& lane, render::DisplayTexels& display, const TexelStore& store)
{
    if (lane.opening && lane.opening->isDone) {
        const render::CardOpening& made = *lane.opening->result;
        if (display.needsOpening() && made.form == display.form() &&
            made.faces.size() == store.faceCount()) {
            display.open(made);
            if (lane.openingNumber != display.openingNumber()) {
                display.touchAll(); // of what is by now: better shown late than never
            }
        }
        lane.opening = nullptr;
    }
    if (display.needsOpening() && !lane.opening) {
        lane.snapshot = nullptr; // it may be of another store
        lane.openingNumber = display.openingNumber();
        lane.opening = start<render::CardOpening>(
            kSoon, [snapshot = snapshotOf(lane, store), form = display.form()] {
                return render::openCard(*snapshot, form, false, Threads::all());
            });
    }
}

/// One plan at a time: views that came and went meanwhile are passed over.
void CardStreaming::plan(Lane& lane, render::DisplayTexels& display, const render::Camera& camera)
{
    if (lane.plan && lane.plan->isDone) {
        if (lane.plan->result->wanted.size() == display.records().size()) {
            display.follow(std::move(*lane.plan->result));
        }
        lane.plan = nullptr;
    }
    const bool isOpen = !display.needsOpening() && !display.records().empty();
    const bool isNew = display.needsPlan() || !lane.planned || !sameView(*lane.planned, camera);
    if (!isOpen || lane.plan || !isNew || !m_extents || !m_extents->isDone) {
        return;
    }
    lane.planned = camera;
    lane.plan = start<render::ResidencyPlan>(
        kSoon,
        [extents = m_extents, camera, faces = display.facesOnCard(), room = display.mostRoom()]()
            -> render::ResidencyPlan {
            std::vector<render::Wish> wishes(faces.size());
            render::wishesOf(*extents->result, camera, Threads::all(), wishes);
            return render::planResidency(wishes, faces, room);
        });
}

void CardStreaming::giveOut(Lane& lane,
                            render::DisplayTexels& display,
                            const TexelStore& store,
                            bool means)
{
    while (lane.batches.size() < kBatches && display.hasJobs(means)) {
        render::JobBatch jobs = display.nextJobs(kBatchBytes, means);
        if (jobs.jobs.empty()) {
            break;
        }
        auto made = start<render::MadeBlocks>(
            kUsual, [snapshot = snapshotOf(lane, store), form = display.form(), of = jobs.jobs] {
                return render::makeBlocks(*snapshot, form, of);
            });
        lane.batches.push_back({std::move(jobs), std::move(made)});
    }
    if (lane.batches.empty() && !lane.opening) {
        lane.snapshot = nullptr; // painting would copy what it shares
    }
}

void CardStreaming::finish(render::Renderer& renderer,
                           const render::Camera& camera,
                           const TexelStore& store,
                           render::Side side)
{
    const Lane& lane = m_lanes[static_cast<std::size_t>(side)];
    const render::DisplayTexels& display = renderer.display(side);
    m_pause.stop();
    bool hasMore = true;
    while (hasMore) {
        m_pool.waitForDone();
        hasMore = send(renderer, camera, store, side, std::numeric_limits<int>::max());
        hasMore =
            hasMore || lane.opening || lane.plan || !lane.batches.empty() || display.needsOpening();
    }
}

} // namespace trixel::ui
