// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include "core/mesh/surface.h"
#include "render/camera.h"
#include "render/display_texels.h"
#include "render/split.h"

#include <array>
#include <atomic>
#include <deque>
#include <memory>
#include <optional>

namespace trixel::render {
class Renderer;
}

namespace trixel::ui {

/// Brings the texels that a view needs to the graphics card while the view goes on: what is to be
/// there at which level, and the texels themselves, are worked out on threads of its own, from
/// snapshots of the store; the thread of the window only hands over what is ready, for so long a
/// frame. All functions are for that thread, with the renderer's context current where one is
/// given.
class CardStreaming : public QObject
{
    Q_OBJECT

public:
    explicit CardStreaming(QObject* parent = nullptr);
    ~CardStreaming() override; ///< waits for what is being worked on

    /// What is shown from now on; all before is forgotten.
    void setSurface(std::shared_ptr<const Surface> surface);
    /// The renderer is another, or shows a mesh anew: what is on its way is for nothing.
    void forget();
    /// The texels are not those of the latest snapshot any more.
    void texelsChanged();

    /// One frame's share of a side: touched texels, then what is ready, for so long.
    /// \return  whether more is ready already; else `ready` tells when there is
    bool send(render::Renderer& renderer,
              const render::Camera& camera,
              const TexelStore& store,
              render::Side side,
              double milliseconds);
    /// Waits until all that the view needs is on the card.
    void finish(render::Renderer& renderer,
                const render::Camera& camera,
                const TexelStore& store,
                render::Side side);
    /// Whether anything is being worked on.
    bool isBusy() const;

signals:
    void ready(); ///< there is something to send

private:
    template <class T>
    struct Task
    {
        std::optional<T> result;
        std::atomic<bool> isDone = false;
    };
    template <class T>
    using TaskPtr = std::shared_ptr<Task<T>>;
    struct Batch
    {
        render::JobBatch jobs;
        TaskPtr<render::MadeBlocks> made;
    };
    /// What is under way for one side.
    struct Lane
    {
        TaskPtr<render::CardOpening> opening;
        std::uint32_t openingNumber = 0;
        TaskPtr<render::ResidencyPlan> plan;
        std::optional<render::Camera> planned; ///< the view of the latest plan
        std::deque<Batch> batches;             ///< taken over in the order given out
        std::shared_ptr<const TexelStore> snapshot;
    };

    template <class T, class Work>
    TaskPtr<T> start(int priority, Work work);
    void open(Lane& lane, render::DisplayTexels& display, const TexelStore& store);
    void plan(Lane& lane, render::DisplayTexels& display, const render::Camera& camera);
    void giveOut(Lane& lane, render::DisplayTexels& display, const TexelStore& store, bool means);
    const std::shared_ptr<const TexelStore>& snapshotOf(Lane& lane, const TexelStore& store);

    std::array<Lane, 2> m_lanes;
    QTimer m_pause; ///< runs while texels change
    std::shared_ptr<const Surface> m_surface;
    TaskPtr<render::FaceExtents> m_extents;
    QThreadPool m_pool; ///< the last: waits for its threads before anything else goes
};

} // namespace trixel::ui
