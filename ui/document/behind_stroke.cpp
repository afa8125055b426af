// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/behind_stroke.h"

#include <QtConcurrent>

#include "core/paint/dab_painter.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <utility>

namespace trixel::ui {

/// What jobs work on, one after the other.
struct BehindStroke::Work
{
    Layered all;
    LayerId layer = kBaseLayer;
    std::shared_ptr<const Surface> surface;
    std::optional<DabPainter> painter;
    std::vector<TouchedRect> touched; ///< by the latest job, of what is shown
    std::optional<LayerPatch> patch;  ///< once all is done
    std::atomic<bool> stop = false;

    TexelStore& painted() { return paintedTexels(all.layers, layer, all.shown); }
    void show(std::vector<TouchedRect> rects)
    {
        touched = showPaint(all.layers, std::move(rects), all.shown);
    }
    void finish(TexelPatch applied)
    {
        patch = LayerPatch{layer, std::move(applied)};
        showCollapsed(all.layers, *patch, all.shown);
    }
};

BehindStroke::BehindStroke(Layered before, LayerId layer, QThreadPool& thread)
    : m_thread(thread)
    , m_before(before)
    , m_told(before)
    , m_work(std::make_shared<Work>())
{
    m_work->all = std::move(before);
    m_work->layer = layer;
    connect(&m_watcher, &QFutureWatcher<void>::finished, this, &BehindStroke::takeResult);
}

BehindStroke::BehindStroke(std::shared_ptr<const Surface> surface,
                           Layered before,
                           LayerId layer,
                           const Brush& brush,
                           std::vector<std::byte> fill,
                           QThreadPool& thread)
    : BehindStroke(std::move(before), layer, thread)
{
    TexelBlend blend = strokeBlend(brush, m_work->painted().format(), groundOf(layer, fill));
    m_work->painter.emplace(std::move(blend), brush.hardness, brush.flow, Threads::all());
    m_work->surface = surface;
    m_dabs.emplace(std::move(surface), brush);
}

BehindStroke::BehindStroke(Layered before,
                           LayerId layer,
                           std::vector<FaceId> faces,
                           std::vector<std::byte> texel,
                           QThreadPool& thread)
    : BehindStroke(std::move(before), layer, thread)
{
    m_ended = true;
    m_isEmpty = faces.empty();
    start([faces = std::move(faces), texel = std::move(texel)](Work& work) {
        TexelPatch applied = fillFaces(work.painted(), faces, texel);
        work.show(wholeFaces(work.all.shown, applied.faces()));
        work.patch = LayerPatch{work.layer, std::move(applied)};
    });
}

BehindStroke::~BehindStroke()
{
    m_work->stop = true; // the job lets go of it when it hears
}

std::vector<PlacedDab> BehindStroke::add(const StrokeSample& sample)
{
    std::vector<PlacedDab> placed;
    m_dabs->add(sample, [&](const Dab& dab, std::span<const FaceId> faces) {
        placed.push_back({dab, {faces.begin(), faces.end()}});
    });
    if (!placed.empty()) {
        m_isEmpty = false;
        m_waiting.insert(m_waiting.end(), placed.begin(), placed.end());
        paintMore();
    }
    return placed;
}

void BehindStroke::lift()
{
    m_dabs->lift();
}

void BehindStroke::end()
{
    m_ended = true;
    paintMore();
}

std::vector<TouchedRect> BehindStroke::touched() const
{
    return wholeFaces(m_before.shown, m_touched);
}

void BehindStroke::start(Job job)
{
    m_running = true;
    m_watcher.setFuture(
        QtConcurrent::run(&m_thread, [work = m_work, todo = std::move(job)] { todo(*work); }));
}

/// Everything that has come by now, unless a job is at work: it is followed by the next.
void BehindStroke::paintMore()
{
    if (m_running) {
        return;
    }
    start([dabs = std::exchange(m_waiting, {}), isLast = m_ended](Work& work) {
        for (const PlacedDab& one : dabs) {
            if (work.stop) {
                return;
            }
            work.painter->paint(one.dab, work.surface->mesh(), one.faces, work.painted());
        }
        work.show(work.painter->takeTouched());
        if (isLast) {
            TexelPatch applied = work.painter->finish(work.painted());
            applied.collapseFaces(work.painted());
            work.finish(std::move(applied));
        }
    });
}

void BehindStroke::takeResult()
{
    m_running = false;
    const std::vector<TouchedRect> touched = std::exchange(m_work->touched, {});
    std::vector<FaceId> faces(touched.size());
    std::ranges::transform(touched, faces.begin(), &TouchedRect::face);
    std::vector<FaceId> all;
    std::ranges::sort(faces);
    std::ranges::set_union(m_touched, faces, std::back_inserter(all));
    m_touched = std::move(all);
    m_told = m_work->all;
    emit advanced(m_told, touched);
    if (m_work->patch) {
        emit finished(*m_work->patch);
    } else if (!m_waiting.empty() || m_ended) {
        paintMore();
    }
}

} // namespace trixel::ui
