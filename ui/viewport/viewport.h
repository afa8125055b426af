// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QWidget>

#include "core/footprint/footprint.h"
#include "core/lattice/texel.h"
#include "core/mesh/bvh.h"
#include "core/texture/texel_store.h"
#include "render/camera.h"
#include "render/frame_figures.h"
#include "render/overlay_pass.h"
#include "render/split.h"
#include "ui/viewport/hovered_texel.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace trixel {
class LimitMesh;
struct ViewCamera;
} // namespace trixel

namespace trixel::ui {

class BackgroundJobs;
class Document;
class FaceSelection;
class Inspection;
class SplitBar;
class ViewSettings;

/// An edge of a face.
struct SurfaceEdge
{
    FaceId face{};
    LocalEdge edge{};

    bool operator==(const SurfaceEdge&) const = default;
};

/// The 3D view: shows the document's surface with its texels, navigates, and paints.
///
/// | what | how |
/// |---|---|
/// | paint, erase, fill, pick | left button, by the tool; a pen's eraser end erases |
/// | select faces, with that tool | left button; Shift adds, Ctrl removes |
/// | hold a texel, with the tool Inspect | left button; on the held one it lets go |
/// | go on to the next texel, with that tool or while one is held | arrow keys |
/// | straight line from the last stroke | Shift + left |
/// | pick whatever the tool but Select | Ctrl + left |
/// | orbit | Alt + left, or middle |
/// | pan | Alt + middle, or Shift + middle |
/// | zoom | Alt + right, or wheel towards the pointer |
/// | brush size, hardness | Ctrl + right, sideways, up and down |
/// | take the stroke back | Esc while painting |
/// | let the held texel go | Esc |
class Viewport : public QWidget
{
    Q_OBJECT

public:
    Viewport(Document& document, ViewSettings& settings, QWidget* parent = nullptr);
    ~Viewport() override;

    /// Frames the whole surface.
    void frameAll();
    /// Frames the faces around the point under the pointer or, when it is off the surface, around
    /// the texel looked at, or all.
    void frameHovered();
    /// Frames a face and its neighbours, looked at from its front. A face that does not exist is
    /// ignored.
    void frameFace(FaceId face);
    /// Frames an edge with the faces on both sides, looked at from the front. A face that does not
    /// exist is ignored.
    void frameEdge(SurfaceEdge edge);
    /// Draws a line along an edge until another is marked, or nothing.
    void markEdge(std::optional<SurfaceEdge> edge);

    /// Shows the selection and lets the Select tool change it. It must outlive the view.
    void useSelection(FaceSelection& selection);
    /// Looks at texels together with others: says what the pointer meets and shows what is looked
    /// at, wherever that was pointed at. Before, the view looks on its own. It must outlive the
    /// view.
    void useInspection(Inspection& inspection);
    /// The texel looked at as it is shown here, also after the pointer has left. Without values
    /// while its face is being read (`inspectedRead`).
    std::optional<HoveredTexel> inspectedTexel() const;
    /// Asks in a line over the view which texel to go to.
    void askForTexel();

    const render::Camera& camera() const;
    void setCamera(const render::CameraPose& pose);
    /// What is seen now, as a view without a name: its picture in device pixels.
    ViewCamera view() const;
    /// Goes to a view at once; orbiting then turns about its target. In a picture of the view's
    /// size exactly that view is seen, in others all of it. A view that is not valid is ignored.
    void lookThrough(const ViewCamera& view);
    /// Frames the whole surface as seen from a direction.
    /// \param yaw, pitch  degrees; 0, 0 looks along -z, a positive pitch from above
    /// \param closeness   1 frames all; 2 is twice as near
    void lookFrom(double yaw, double pitch, double closeness = 1.0);

    /// Where a point of the surface is seen, in the widget's own pixels; nothing when it is outside
    /// the picture or behind other faces.
    std::optional<QPointF> widgetPosition(const SurfacePoint& point) const;
    /// The point of the surface seen at a position of the widget.
    std::optional<SurfacePoint> surfacePointAt(QPointF position) const;

    /// Lays rows of a picture over the surface and under the lines: R G B A for each device pixel
    /// of a view of that size, from the top. A picture of another size begins clear.
    /// \param side  that the picture is seen on
    void setPictureRows(std::span<const std::uint32_t> pixels,
                        QSize size,
                        int firstRow,
                        render::Side side = render::Side::A);
    void clearPicture(render::Side side = render::Side::A);
    bool hasPicture() const;

    /// From now on the present texels are those that a view split in before and after shows as
    /// before; at first those that were opened are.
    void rememberBefore();
    SplitBar& splitBar();

    /// Shows each face in one colour, unlit and without texels, or its texels again.
    /// \param colors  R G B A a face of the document's surface, or three a face, one at each corner
    ///                and blended between them (checked); empty: none
    void setFaceColors(std::vector<std::uint32_t> colors);
    bool hasFaceColors() const;

    /// Shows other texels of the document's surface in place of its own, or its own again. Ends by
    /// itself when the document's texels change.
    void showOtherTexels(std::optional<TexelStore> texels);
    bool showsOtherTexels() const;

    /// Draws footprints in the place of the hovered pixel's own, which nothing gives back.
    /// \param magnification  how many times larger than it is the footprint is drawn
    void showFootprints(std::optional<std::vector<render::Polyline>> lines,
                        double magnification = 1.0,
                        bool withFrozen = false);

    /// Tells of work for the picture that takes long, to be cancelled there. They must outlive the
    /// view.
    void useJobs(BackgroundJobs& jobs);
    /// Shows the limit surface and asks in a line over the view which edges are its creases.
    void askForCreases();
    /// Why the surface shown has no limit surface: a sentence; empty where it may have one.
    QString limitSurfaceRefusal() const;

    /// The limit surface as it is seen; null where the cage is.
    std::shared_ptr<const LimitMesh> seenLimit() const;

    /// Finishes everything that a picture needs and that is otherwise spread over frames, so that
    /// `grabFramebuffer` is complete.
    void settle();
    /// Of the latest frame; empty where the view cannot draw.
    render::FrameFigures figures() const;
    /// Whether the view can draw: OpenGL is there and the widget has been shown.
    bool canDraw() const;
    /// The picture as shown, in device pixels; null where the view cannot draw.
    QImage grabFramebuffer();
    /// The same, complete and drawn for another density where no picture is laid over the surface.
    /// \param density  device pixels to a pixel of the widget, > 0
    QImage picture(double density);

signals:
    /// The texel looked at: held, or under a pointer here or in a panel; nothing when there is
    /// none.
    void hovered(const std::optional<trixel::ui::HoveredTexel>& texel);
    /// Values of the texel looked at that had to be read first may be there now.
    void inspectedRead();
    /// Where the pointer is over the view, also when the view moves under it; nothing when it left.
    void pointerMoved(const std::optional<QPointF>& position);
    /// The camera moved or the picture has another size.
    void cameraChanged();
    /// Other texels are shown than before, the document's or not.
    void otherTexelsShown(bool others);
    void limitSurfaceRefusalChanged();
    /// The limit surface is seen in the cage's place, or the cage again, or another tessellation.
    void seenSurfaceChanged();
    /// The pick tool met a texel.
    void colorPicked(const std::array<float, 4>& color);
    /// One sentence for the status bar (OpenGL not available, texels shown reduced, …).
    void notice(const QString& sentence);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void tabletEvent(QTabletEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    class Private;
    std::unique_ptr<Private> d;
};

} // namespace trixel::ui
