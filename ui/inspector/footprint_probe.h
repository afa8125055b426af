// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "core/filter/footprint_net.h"
#include "core/footprint/screen_derivatives.h"
#include "render/camera.h"
#include "ui/viewport/seen_surface.h"

#include <memory>
#include <optional>

namespace trixel::ui {

class Document;
class Inspection;

/// Where a footprint comes from.
enum class FootprintSource {
    Screen,         ///< the pixel that sees the point
    TextureAligned, ///< W1 along u, W2 along v
    ByHand,         ///< dragged or typed
    Tilted          ///< a pixel of a view that leans over the point
};

struct ProbedFootprint
{
    PlacedFootprint placed;
    FootprintSource source{};
    /// How the pixel moves with (u,v), where a screen is the source.
    std::optional<ScreenDerivatives> derivatives;
    double degrees = 0; ///< between view and normal, where a tilted view is the source
};

/// The footprint that is looked into: it stands at the inspected texel and comes from the source
/// chosen; a second one may be frozen to be compared with. Does nothing while nobody looks.
class FootprintProbe : public QObject
{
    Q_OBJECT

public:
    FootprintProbe(Document& document, Inspection& inspection, QObject* parent = nullptr);

    /// Whether someone looks.
    void setActive(bool active);
    bool isActive() const { return m_isActive; }
    /// The view, for footprints that come from it.
    void setCamera(const render::Camera& camera);
    /// The limit surface that the view shows in the cage's place; null where it shows the cage.
    void setLimit(std::shared_ptr<const LimitMesh> limit);

    /// Nothing before a texel was looked at, and where the view does not see the point.
    const std::optional<ProbedFootprint>& live() const { return m_live; }

    FootprintSource source() const { return m_source; }
    /// By hand goes on from the footprint there is.
    void setSource(FootprintSource source);
    /// In (u,v). What is not along the axes makes the source one by hand; so does any other but
    /// that of a texture's axes.
    void setVectors(glm::dvec2 w1, glm::dvec2 w2);
    /// Of the tilted view, [0, 89].
    double degrees() const { return m_degrees; }
    void setDegrees(double degrees);
    /// The same place seen by the tilted view at another angle.
    std::optional<ProbedFootprint> tilted(double degrees) const;

    const std::optional<ProbedFootprint>& frozen() const { return m_frozen; }
    /// Keeps the footprint as it is now.
    void freeze();
    void thaw();

signals:
    /// The live footprint.
    void changed();
    void frozenChanged();
    void sourceChanged();

private:
    void update();
    std::optional<ProbedFootprint> made() const;
    std::optional<ProbedFootprint> fromScreen(FaceId face, glm::dvec2 uv) const;
    SeenSurface seen() const;

    Document& m_document;
    Inspection& m_inspection;
    render::Camera m_camera;
    std::shared_ptr<const LimitMesh> m_limit;
    FootprintSource m_source = FootprintSource::Screen;
    /// Of TextureAligned and ByHand, in texels' edges of the face stood on: so that they keep their
    /// sense from face to face.
    glm::dvec2 m_first{4, 0};
    glm::dvec2 m_second{0, 4};
    double m_degrees = 0;
    bool m_isActive = false;
    std::optional<ProbedFootprint> m_live;
    std::optional<ProbedFootprint> m_frozen;
};

} // namespace trixel::ui
