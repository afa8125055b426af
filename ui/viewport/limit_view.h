// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFutureWatcher>
#include <QObject>

#include "core/base/progress.h"
#include "core/mesh/limit_mesh.h"
#include "core/mesh/surface.h"
#include "render/camera.h"

#include <atomic>
#include <memory>
#include <optional>

namespace trixel::ui {

class BackgroundJobs;

/// The limit surface of the cage in a view, tessellated for its camera in the background. While
/// the camera moves or creases change, the newest demand counts and what is there stays.
class LimitView : public QObject
{
    Q_OBJECT

public:
    explicit LimitView(QObject* parent = nullptr);
    ~LimitView() override;

    /// Tells of work that takes long, to be cancelled there. They must outlive the work.
    void useJobs(BackgroundJobs& jobs) { m_jobs = &jobs; }

    /// Another cage, or none: forgets everything and looks whether it can be subdivided.
    void setSurface(std::shared_ptr<const Surface> surface, CreaseAngle creases);
    /// Other creases of the same cage.
    void setCreases(CreaseAngle creases);
    /// Why there is no limit surface; empty where there is or may be one.
    const QString& refusal() const { return m_refusal; }

    /// Has it made, or brought up to date, for a camera.
    /// \param error  pixels, > 0
    void want(const render::Camera& camera, double error);
    /// Gives it up, but for what depends on the cage alone.
    void rest();
    /// Waits until what was wanted is there.
    void finish();

    /// To be drawn; null while there is none.
    const std::shared_ptr<const LimitTessellation>& tessellation() const { return m_cut; }
    /// To be pointed at; null while there is none, and for moments of the tessellation before.
    const std::shared_ptr<const LimitMesh>& mesh() const { return m_mesh; }
    /// To be painted on: whatever the camera; there as soon as `mesh` is.
    const std::shared_ptr<const LimitMesh>& solid() const { return m_solid; }

signals:
    /// Another tessellation or none.
    void tessellated();
    /// Another mesh or none.
    void meshChanged();
    /// What `refusal` says is another.
    void refusalChanged();
    /// Its making was cancelled; there is none.
    void cancelled();

private:
    /// What a piece of work came to: whatever it made.
    struct Made
    {
        std::optional<std::string> refusal;
        bool isCancelled = false; ///< by whoever watches the job
        bool isPossible = false;
        std::shared_ptr<const LimitMesh> solid;
        std::shared_ptr<const LimitTessellation> cut;
        std::shared_ptr<const LimitMesh> mesh;
    };
    using Stop = std::shared_ptr<std::atomic<bool>>;

    void next();
    template <class Work>
    void start(Work work, const QString& jobTitle = {});
    void makeSolid();
    void makeMesh();
    void makeCut();
    void take();
    void keep(const Made& made);
    void stop();
    void refuse(const QString& why);

    BackgroundJobs* m_jobs = nullptr;
    std::shared_ptr<const Surface> m_surface;
    CreaseAngle m_creases;
    QString m_refusal;
    bool m_isPossible = false;
    std::optional<LimitDemand> m_demand; ///< not begun yet
    LimitDemand m_wanted;                ///< the newest
    render::CameraPose m_pose;           ///< of the newest demand
    glm::ivec2 m_size{0};
    double m_error = 0;
    std::shared_ptr<const LimitMesh> m_solid;
    bool m_hasOldCreases = false; ///< the solid
    std::shared_ptr<const LimitTessellation> m_cut;
    std::shared_ptr<const LimitMesh> m_mesh;
    QFutureWatcher<Made> m_watcher;
    Stop m_stop;
    bool m_isBusy = false;
};

} // namespace trixel::ui
