// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/import/import_settings.h"

#include <array>
#include <glm/vec3.hpp>

class QLabel;
class QPushButton;

namespace trixel {
class Surface;
}

namespace trixel::ui {

class Viewport;

/// Where an image lies that is thrown through four corners: of the world, or of the picture of a
/// camera that stays where it is.
class PlacePage : public QWidget
{
    Q_OBJECT

public:
    /// \param viewport  outlives this
    explicit PlacePage(Viewport& viewport, QWidget* parent = nullptr);

    const std::array<glm::dvec3, 4>& quad() const { return m_quad; }
    const CameraSettings& camera() const { return m_camera; }

    /// \param kind  Quad or Camera; others hide what is drawn in the view
    void setKind(MapKind kind);
    void takeSurface(const Surface& surface);
    /// \param aspect  of the image, its width over its height
    void setAspect(double aspect);
    /// Lays the image upright into the middle of what is seen now.
    void placeInView();

signals:
    void changed();

private:
    void placeQuad();
    void placeCamera();
    void showWords();

    Viewport& m_viewport;
    MapKind m_kind = MapKind::Camera;
    std::array<glm::dvec3, 4> m_quad{};
    CameraSettings m_camera;
    double m_aspect = 1;
    double m_size = 1;
    glm::dvec3 m_middle{0};
    QLabel* m_about;
    QPushButton* m_here;
    QPushButton* m_return;
};

} // namespace trixel::ui
