// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include "core/mesh/surface.h"
#include "render/camera.h"
#include "render/display_vertices.h"
#include "render/split.h"

#include <array>
#include <atomic>
#include <deque>
#include <functional>
#include <memory>
#include <optional>

namespace trixel::render {
class Renderer;
}

namespace trixel::ui {

/// Brings the texels that a view needs to the graphics card while the view goes on, or the vertices
/// made of them where ways of filtering show these: what is to be there at which level, and the
/// texels or vertices themselves, are worked out on threads of its own, from snapshots of the
/// store; the thread of the window only hands over what is ready, for so long a frame. All
/// functions are for that thread, with the renderer's context current where one is given.
class CardStreaming : public QObject
{
    Q_OBJECT

public:
    explicit CardStreaming(QObject* parent = nullptr);
    ~CardStreaming() override; ///< waits for what is being worked on

    /// What is shown from now on; all before is forgotten.
    void setSurface(std::shared_ptr<const Surface> surface);
    /// What vertices are made with, of the surface; none until `setFilterMesh`. What is on its way
    /// with another is for nothing.
    void setFilterMesh(std::shared_ptr<const render::FilterMesh> mesh);
    /// Whether views show texels, or else vertices alone: then texels stay as they are on the card,
    /// but for those that are touched.
    void showTexels(bool shown) { m_showsTexels = shown; }
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
    /// Something could not be made for want of memory, for the first time with this surface.
    void outOfMemory();

private:
    template <class T>
    struct Task
    {
        std::optional<T> result; ///< none where memory ran out, once it is done
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
        std::shared_ptr<const TexelStore> snapshot;
        render::DisplayBlocks::Maker maker; ///< of blocks of the snapshot
        TaskPtr<render::PreparedOpening> opening;
        std::uint32_t openingNumber = 0;
        std::optional<std::uint32_t> failedOpening; ///< for which there was no memory
        bool hasPlanFailed = false;                 ///< likewise, for the view planned for
        TaskPtr<render::ResidencyPlan> plan;
        std::optional<render::Camera> planned; ///< the view of the latest plan
        std::uint32_t plannedOpening = 0;
        std::deque<Batch> batches; ///< taken over in the order given out

        void forgetSnapshot();
    };
    using Extents = TaskPtr<render::FaceExtents>;
    /// One frame's share of texels or of vertices.
    struct Frame
    {
        Lane& lane;
        render::DisplayBlocks& display;
        const Extents& extents;
        const TexelStore& store;
        const render::Camera& camera;
        std::function<void()> sendReady;
        std::function<bool()> hasTime;
        bool isShown = true;
    };

    template <class T, class Work>
    TaskPtr<T> start(int priority, Work work);
    void tellNoMemory();
    bool send(const Frame& frame);
    void open(const Frame& frame);
    void plan(const Frame& frame);
    void giveOut(const Frame& frame);
    const std::shared_ptr<const TexelStore>& snapshotOf(Lane& lane, const TexelStore& store);
    Lane& texelLane(render::Side side) { return m_lanes[static_cast<std::size_t>(side)]; }
    Lane& vertexLane(render::Side side) { return m_lanes[2 + static_cast<std::size_t>(side)]; }

    std::array<Lane, 4> m_lanes; ///< texels of both sides, then their vertices
    bool m_showsTexels = true;
    bool m_hasToldNoMemory = false;
    QTimer m_pause; ///< runs while texels change
    std::shared_ptr<const Surface> m_surface;
    Extents m_extents;
    std::shared_ptr<const render::FilterMesh> m_filterMesh;
    Extents m_vertexExtents;
    QThreadPool m_pool; ///< the last: waits for its threads before anything else goes
};

} // namespace trixel::ui
