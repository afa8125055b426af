// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QOpenGLWidget>

#include "core/footprint/footprint.h"
#include "core/lattice/texel.h"
#include "core/mesh/bvh.h"

#include <memory>
#include <optional>
#include <vector>

namespace trixel::ui {

class Document;
class ViewSettings;

/// The texel under the pointer, for the readout.
struct HoveredTexel
{
    SurfacePoint point;
    Level level; ///< of the face as shown (after the mip drop)
    TexelCoord texel;
    TexelIndex index{};
    PackedPixel pixel;
    std::vector<float> values; ///< one a channel, as stored
    Footprint footprint;
    FootprintEllipse ellipse;
};

/// The 3D view: shows the document's surface with its texels, navigates, and paints.
class Viewport : public QOpenGLWidget
{
    Q_OBJECT

public:
    Viewport(Document& document, ViewSettings& settings, QWidget* parent = nullptr);
    ~Viewport() override;

    /// Frames the whole surface.
    void frameAll();
    /// Frames the faces around the hovered point, or all when nothing is hovered.
    void frameHovered();

signals:
    /// Nothing when the pointer is off the surface.
    void hovered(const std::optional<trixel::ui::HoveredTexel>& texel);
    /// The pick tool met a texel.
    void colorPicked(const std::array<float, 4>& color);
    /// One sentence for the status bar (OpenGL not available, texels shown reduced, …).
    void notice(const QString& sentence);

private:
    class Private;
    std::unique_ptr<Private> d;
};

} // namespace trixel::ui
