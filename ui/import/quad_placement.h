// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>

#include "core/mesh/surface.h"
#include "ui/import/import_settings.h"

#include <array>
#include <glm/vec3.hpp>
#include <optional>

class QImage;

namespace trixel::ui {

class CornerHandle;
class QuadOverlay;
class Viewport;

/// The four corners that an image is thrown through, as they are seen and dragged in the view:
/// corners in the world, or in the picture of a camera that stays where it is when the view moves
/// on.
class QuadPlacement : public QObject
{
    Q_OBJECT

public:
    /// \param viewport  outlives this
    explicit QuadPlacement(Viewport& viewport, QObject* parent);

    const std::array<glm::dvec3, 4>& quad() const { return m_quad; }
    const CameraSettings& camera() const { return m_camera; }
    MapKind kind() const { return m_kind; }

    /// \param kind  Quad or Camera; nothing is drawn for others
    void setKind(MapKind kind);
    /// Whether corners are drawn at all.
    void setOn(bool on);
    void takeSurface(const Surface& surface);
    /// The image lies upright in the view until a corner is moved. \param aspect  of the image, its
    /// width over its height
    void setImage(const QImage& small, double aspect);
    void setImageOpacity(double opacity);

    /// Lays the image upright into the middle of what is seen now.
    void placeInView();
    /// Brings the view to where the image is thrown from; Camera alone.
    void lookFromThere();
    /// Whether the corners can be seen: those of a camera only from where it is.
    bool isSeen() const;
    /// Gives the keyboard to the first corner.
    void focusCorner();

signals:
    void changed();
    /// `isSeen` may be another.
    void viewMoved();

private:
    using Places = std::array<std::optional<QPointF>, 4>;

    void placeQuad();
    void placeCamera();
    void moveCorner(std::size_t corner, QPointF to);
    std::optional<glm::dvec3> quadCornerAt(glm::dvec3 corner, QPointF to) const;
    std::optional<glm::dvec2> cameraCornerAt(QPointF to) const;
    std::optional<QPointF> placeOf(glm::dvec2 st) const;
    std::optional<QPointF> seenAt(glm::dvec3 point) const;
    glm::dvec3 rayThrough(QPointF place) const;
    bool isUsable() const;
    void show();

    Viewport& m_viewport;
    QuadOverlay* m_overlay;                   ///< a child of the view, as are the handles
    std::array<CornerHandle*, 4> m_handles{}; ///< in the order of the corners
    MapKind m_kind = MapKind::Uvs;
    bool m_isOn = false;
    bool m_isByHand = false; ///< a corner was moved
    std::array<glm::dvec3, 4> m_quad{};
    CameraSettings m_camera;
    double m_aspect = 1;
    double m_size = 1; ///< of the surface
    glm::dvec3 m_middle{0};
};

} // namespace trixel::ui
