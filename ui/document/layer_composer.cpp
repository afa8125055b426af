// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/layer_composer.h"

#include <QtConcurrent>

#include "ui/document/layer_paint.h"
#include "ui/document/released_elsewhere.h"

#include <algorithm>
#include <atomic>
#include <new>
#include <utility>

namespace trixel::ui {

/// One composition. Who drops it lets the other thread finish with it alone.
struct LayerComposer::Work
{
    LayerStack next;
    Layered before;
    Result<Layered> made = contentsError("There is not enough memory for this.");
    std::optional<Change> change;
    std::atomic<bool> stop = false;
};

namespace {

class StopProgress final : public Progress
{
public:
    explicit StopProgress(const std::atomic<bool>& stop)
        : m_stop(stop)
    {
    }
    bool report(double /*fraction*/) override { return !m_stop; }

private:
    const std::atomic<bool>& m_stop;
};

/// Faces that more than a few milliseconds of looking each up and naming it are spent on.
constexpr std::size_t kManyFaces = 20'000;
/// Texels of layers that a core puts together in some milliseconds.
constexpr std::size_t kManyTexels = 300'000;

std::size_t texelsInMemory(const TexelStore& texels)
{
    std::size_t count = 0;
    for (std::uint32_t f = 0; f < texels.faceCount() && count < kManyTexels; ++f) {
        const FaceTexels& face = texels.face(faceId(f));
        count += face.isConstant() ? 1 : face.level().texelCount();
    }
    return count;
}

} // namespace

bool isQuicklyComposed(const LayerStack& layers)
{
    if (layers.base().faceCount() * (layers.layers().size() + 1) > kManyFaces) {
        return false;
    }
    std::size_t texels = 0;
    for (const Layer& layer : layers.layers()) {
        texels += texelsInMemory(layer.texels);
    }
    return texels < kManyTexels;
}

std::optional<Change> changeBetween(const TexelStore& before, const TexelStore& after)
{
    // Most of a mesh is told as all of it.
    const auto faces = facesApart(before, after, after.faceCount() / 2);
    if (!faces) {
        return Change();
    }
    if (faces->empty()) {
        return std::nullopt;
    }
    return Change{wholeFaces(after, *faces)};
}

LayerComposer::LayerComposer(QThreadPool& thread)
    : m_thread(thread)
{
}

LayerComposer::~LayerComposer()
{
    drop();
}

void LayerComposer::start(LayerStack next, const Layered& now)
{
    m_wanted = std::move(next);
    if (!isRunning()) {
        m_now = now;
        begin();
    }
}

void LayerComposer::begin()
{
    m_work = releasedElsewhere(std::make_unique<Work>());
    m_work->next = *std::exchange(m_wanted, {});
    m_work->before = m_now;
    m_watcher = std::make_unique<QFutureWatcher<void>>();
    connect(m_watcher.get(), &QFutureWatcher<void>::finished, this, &LayerComposer::takeResult);
    m_watcher->setFuture(QtConcurrent::run(&m_thread, [work = m_work] {
        StopProgress progress(work->stop);
        try {
            work->made = recomposed(std::move(work->next), work->before, Threads::all(), progress);
            if (work->made) {
                work->change = changeBetween(work->before.shown, work->made->shown);
            }
        } catch (const std::bad_alloc&) {
            // Told as what `made` began with.
        }
    }));
}

void LayerComposer::drop()
{
    if (m_work) {
        m_work->stop = true;
        m_watcher->disconnect(this);
        m_watcher.release()->deleteLater(); // it may be telling this
        m_work.reset();
    }
    m_wanted.reset();
    m_now = {};
}

void LayerComposer::takeResult()
{
    const std::shared_ptr<Work> work = std::exchange(m_work, nullptr);
    m_watcher.release()->deleteLater(); // it is telling this
    if (work->made) {
        m_now = *work->made;
    }
    if (m_wanted) {
        begin();
    } else {
        m_now = {};
    }
    if (work->made) {
        emit composed(work->made->shown, work->change);
    }
    if (!isRunning()) {
        if (work->made) {
            emit finished();
        } else {
            emit failed(QString::fromStdString(work->made.error().message));
        }
    }
}

} // namespace trixel::ui
