// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/layer_composer.h"

#include "core/layers/face_layers.h"
#include "ui/document/layer_paint.h"
#include "ui/document/released_elsewhere.h"

#include <algorithm>
#include <utility>

namespace trixel::ui {

/// One composition. Who drops it lets the other thread finish with it alone.
struct LayerComposer::Work
{
    LayerStack next;
    Layered before;
    Layered made;
    std::optional<Change> change;
};

namespace {

/// Faces that more than a few milliseconds of looking each up and naming it are spent on.
constexpr std::size_t kManyFaces = 20'000;
/// Texels of layers that a core puts together in some milliseconds.
constexpr std::size_t kManyTexels = 300'000;

/// Texels of layers that go into what a face looks like. \param shown  layers of the stack
std::size_t
texelsPutTogether(const TexelStore& base, std::span<const Layer* const> shown, FaceId face)
{
    bool isConstant = base.face(face).isConstant();
    std::size_t covering = 0;
    for (const Layer* layer : shown) {
        if (mayCover(*layer, face)) {
            isConstant = isConstant && layer->texels.face(face).isConstant();
            ++covering;
        }
    }
    return covering * (isConstant ? 1 : base.face(face).level().texelCount());
}

} // namespace

bool isQuicklyComposed(const LayerStack& layers)
{
    const TexelStore& base = layers.base();
    if (base.faceCount() * (layers.layers().size() + 1) > kManyFaces) {
        return false;
    }
    const std::vector<const Layer*> shown = shownLayers(layers);
    std::size_t texels = 0;
    for (std::uint32_t f = 0; f < base.faceCount() && texels < kManyTexels; ++f) {
        texels += texelsPutTogether(base, shown, faceId(f));
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

LayerComposer::~LayerComposer()
{
    drop();
}

void LayerComposer::start(LayerStack next, const Layered& now)
{
    m_wanted = std::move(next);
    m_isCurrent = false;
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
    m_job = &m_jobs->run(
        tr("Putting layers together…"),
        [work = m_work](Progress& progress) -> Status {
            return recomposed(std::move(work->next), work->before, Threads::all(), progress)
                .map([&](Layered&& made) {
                    work->change = changeBetween(work->before.shown, made.shown);
                    work->made = std::move(made);
                });
        },
        [self = QPointer(this), work = m_work](Status made) {
            if (self && self->m_work == work) {
                self->takeResult(std::move(made));
            }
        });
}

void LayerComposer::drop()
{
    if (m_work) {
        m_work.reset();
        if (m_job) {
            m_job->cancel();
        }
    }
    m_wanted.reset();
    m_now = {};
    m_isCurrent = true;
}

void LayerComposer::takeResult(Status made)
{
    const std::shared_ptr<Work> work = std::exchange(m_work, nullptr);
    if (m_job->isCancelled() && std::exchange(m_wanted, {})) {
        made = cancelled(); // that, too
    }
    if (made) {
        m_now = work->made;
    }
    if (m_wanted) {
        begin();
    } else {
        m_now = {};
        m_isCurrent = made.has_value();
    }
    if (made) {
        emit composed(work->made.shown, work->change);
    }
    if (!isRunning()) {
        if (made) {
            emit finished();
        } else {
            emit failed(made.error());
        }
    }
}

} // namespace trixel::ui
