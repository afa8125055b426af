// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/place_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "core/mesh/surface.h"
#include "ui/viewport/viewport.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace trixel::ui {

namespace {

/// Of the view, that the image takes at first.
constexpr double kShare = 0.7;

} // namespace

PlacePage::PlacePage(Viewport& viewport, QWidget* parent)
    : QWidget(parent)
    , m_viewport(viewport)
    , m_about(new QLabel)
    , m_here(new QPushButton)
    , m_return(new QPushButton(tr("&Look from There")))
{
    m_about->setWordWrap(true);
    m_about->setAccessibleName(tr("About the corners"));
    m_about->setToolTip(tr("Where the image's corners are, and how they are moved"));
    m_here->setAccessibleName(tr("Place the image in the view"));
    m_return->setAccessibleName(tr("Look from where the image comes from"));
    m_return->setToolTip(tr("Bring the view back to where the image is thrown from"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    column->addWidget(m_about);
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    row->addWidget(m_here);
    row->addWidget(m_return);
    row->addStretch(1);
    column->addLayout(row);
    connect(m_here, &QPushButton::clicked, this, [this] {
        placeInView();
        emit changed();
    });
    connect(
        m_return, &QPushButton::clicked, this, [this] { m_viewport.lookThrough(m_camera.camera); });
    showWords();
}

void PlacePage::setKind(MapKind kind)
{
    m_kind = kind;
    showWords();
}

void PlacePage::takeSurface(const Surface& surface)
{
    m_middle = 0.5 * (glm::dvec3(surface.low()) + glm::dvec3(surface.high()));
    m_size = surface.size();
    placeQuad();
    placeCamera();
}

void PlacePage::setAspect(double aspect)
{
    m_aspect = aspect;
    placeInView();
}

void PlacePage::placeInView()
{
    if (m_kind == MapKind::Camera) {
        placeCamera();
    } else {
        placeQuad();
    }
}

void PlacePage::placeCamera()
{
    m_camera.camera = m_viewport.view();
    const double view = static_cast<double>(m_camera.camera.width) / m_camera.camera.height;
    const double x = kShare * std::min(1.0, m_aspect / view);
    const double y = kShare * std::min(1.0, view / m_aspect);
    m_camera.corners = {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

/// Upright and facing the view, at the depth of what is in its middle.
void PlacePage::placeQuad()
{
    const ViewCamera camera = m_viewport.view();
    const glm::dvec3 forward = camera.forward();
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::dvec3 up = glm::cross(right, forward);
    const double depth = std::max(glm::dot(m_middle - camera.position, forward), 0.01 * m_size);
    const glm::dvec3 centre = camera.position + depth * forward;
    const double pixel = camera.unitsPerPixel(centre);
    const double view = static_cast<double>(camera.width) / camera.height;
    const double height = kShare * pixel * camera.height * std::min(1.0, view / m_aspect);
    const glm::dvec3 across = 0.5 * height * m_aspect * right;
    const glm::dvec3 upward = 0.5 * height * up;
    m_quad = {centre - across - upward,
              centre + across - upward,
              centre + across + upward,
              centre - across + upward};
}

void PlacePage::showWords()
{
    const bool isCamera = m_kind == MapKind::Camera;
    m_about->setText(isCamera
                         ? tr("The image is thrown from where the view was when it was placed; "
                              "turn the view freely to look at it from elsewhere.")
                         : tr("The image lies in space between four corners and is thrown "
                              "straight onto the surface."));
    m_here->setText(isCamera ? tr("&Use This View") : tr("Place in &View"));
    m_here->setToolTip(isCamera ? tr("Throw the image from where the view is now")
                                : tr("Lay the image upright into the middle of the view"));
    m_return->setVisible(isCamera);
}

} // namespace trixel::ui
