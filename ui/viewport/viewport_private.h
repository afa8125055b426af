// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFutureWatcher>
#include <QLabel>

#include "render/renderer.h"
#include "ui/document/document.h"
#include "ui/document/face_selection.h"
#include "ui/document/inspection.h"
#include "ui/viewport/canvas.h"
#include "ui/viewport/card_painting.h"
#include "ui/viewport/card_streaming.h"
#include "ui/viewport/crease_bar.h"
#include "ui/viewport/footprint_legend.h"
#include "ui/viewport/frame_hud.h"
#include "ui/viewport/go_to_bar.h"
#include "ui/viewport/limit_view.h"
#include "ui/viewport/navigation.h"
#include "ui/viewport/seen_surface.h"
#include "ui/viewport/selection_lines.h"
#include "ui/viewport/split_bar.h"
#include "ui/viewport/stroke_input.h"
#include "ui/viewport/surface_lines.h"
#include "ui/viewport/texel_reading.h"
#include "ui/viewport/view_settings.h"
#include "ui/viewport/viewport.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace trixel::ui {

/// What the pointer holds down.
enum class Interaction { None, Stroke, Pick, Select, Inspect, Camera, BrushDrag };

/// A press, move or release of mouse or pen.
struct PointerEvent
{
    PointerSample sample;
    Qt::MouseButton button = Qt::NoButton;
    Qt::KeyboardModifiers modifiers;
    bool eraserEnd = false;
};

/// A computed picture over the view.
struct PictureOver
{
    std::vector<std::uint32_t> pixels;
    glm::ivec2 size{0};
    bool isNew = true;
    int firstTouched = 0; ///< rows to send: from here …
    int endTouched = 0;   ///< … to before here
};

/// The viewport's state; its functions are grouped by file.
class Viewport::Private
{
public:
    Private(Viewport& viewport, Document& document, ViewSettings& settings);

    // viewport_scene.cpp: what is shown
    void takeSurface();
    void takeChange(const Change& change);
    void releaseHeldTexels();
    void touchTexels(const Change& change, render::Side side);
    void takeView();
    void takeLook();
    /// The texels that are shown.
    const TexelStore& texels() const { return otherTexels ? *otherTexels : document.texels(); }
    /// Those that the card holds: without a stroke that it shows over them.
    const TexelStore& sentTexels() const
    {
        return !otherTexels && painting.sent() != nullptr ? *painting.sent() : texels();
    }
    void setOtherTexels(std::optional<TexelStore> others);
    void makeCanvas();
    void makeRenderer();
    void draw();
    void redraw();
    void fitCamera();
    void sendMesh();
    void sendTexels(double milliseconds);
    void finishTexels();
    void prepareTexels();
    void cornersReady();
    void waitForCorners();
    render::Scene scene() const;
    void paintHint();
    void explainNoOpenGl(const QString& reason);
    void showOverlays();

    // viewport_picture.cpp: what is laid over it
    void sendPicture(render::Side side);
    void sendFaceColors();
    std::optional<render::Polyline> edgeMark() const;

    // viewport_hover.cpp: what is under the pointer, and what is drawn of it
    glm::dvec2 devicePosition(QPointF position) const;
    std::optional<SurfacePoint> hit(glm::dvec2 position) const;
    void hoverAt(glm::dvec2 position);
    void refreshHover();
    void leave();
    std::vector<render::Polyline> overlays() const;
    void cameraMoved();

    // viewport_inspect.cpp: the texel looked at
    void watchInspection();
    std::optional<HoveredTexel> describedTexel();
    void showInspected();
    void bringIntoSight();
    void beginInspecting(const PointerEvent& event);
    void holdAt(glm::dvec2 position);
    bool inspectKey(const QKeyEvent& event);
    std::vector<render::Polyline> heldMark() const;

    // viewport_limit.cpp: the limit surface
    void watchLimit();
    bool showsLimit() const;
    SeenSurface seen() const;
    void takeLimit();
    void sendLimit();
    void sendLimit(std::size_t bytes);
    void settleLimit();

    // viewport_split.cpp: two sides
    void takeComparison();
    const TexelStore& otherSideTexels() const;
    void prepareOtherSide();
    std::optional<render::Split> split() const;
    /// Whether B has texels of its own.
    bool hasOtherTexels() const;

    // viewport_filtering.cpp: what ways of filtering need
    std::vector<render::Filtering> filteringsShown() const;
    void forgetFilterMesh();
    void takeFilteredLimit();
    void makeFilterMesh();
    void filterMeshReady();
    void prepareFilters();
    void waitForFilterMesh();
    void sendAtlas(double milliseconds);
    bool sendAtlas(const TexelStore& store, render::Side side, double milliseconds);
    void finishAtlas();

    // viewport_selection.cpp: the chosen faces
    void takeSelection();
    void outlineReady();
    void beginSelecting(const PointerEvent& event);
    void selectTo(glm::dvec2 position);

    // viewport_painting.cpp: strokes that the card shows first
    void watchPainting();
    StrokePace paceAt(const Brush& brush, glm::dvec2 position);
    void placeFill(const std::vector<FaceId>& faces, const std::array<float, 4>& color);
    void drawPreview();
    void previewDrawn();

    // viewport_tools.cpp: what the pointer does
    void press(const PointerEvent& event);
    void move(const PointerEvent& event);
    void release(const PointerEvent& event);
    bool cancel();

    Viewport& q;
    Document& document;
    ViewSettings& settings;

    Canvas* canvas = nullptr; ///< none where there is no OpenGL; a child of the viewport
    render::Camera camera;
    std::unique_ptr<render::Renderer> renderer;
    bool meshDirty = true;
    bool texelsDirty = true;
    CardStreaming streaming;
    std::shared_ptr<const Surface> shownSurface;
    ViewOptions shownView;
    using Corners = std::shared_ptr<const render::SharedCorners>;
    QFutureWatcher<Corners> cornersWatcher;
    Corners sharedCorners; ///< none until they are made
    QFutureWatcher<std::shared_ptr<const render::FilterMesh>> filterWatcher;
    std::shared_ptr<const render::FilterMesh>
        filterMesh;                                 ///< none until a way of filtering needs it
    bool filterMeshDirty = true;                    ///< the renderer has another
    int filterMeshNumber = 0;                       ///< of the surface and levels shown
    int filterMeshMade = -1;                        ///< the number when its making began
    bool isMakingFilterMesh = false;                ///< and not taken over yet
    std::shared_ptr<const LimitMesh> filteredLimit; ///< whose sizes it has; none: the cage's
    QLabel* message = nullptr;                      ///< in the view's place when it cannot draw
    FootprintLegend* legend = nullptr;              ///< none where there is no OpenGL
    FrameHud* hud = nullptr;                        ///< likewise
    GoToBar* goTo = nullptr;                        ///< none before it was asked for
    CreaseBar* creases = nullptr;                   ///< likewise

    std::array<PictureOver, 2> pictures; ///< by side
    SplitBar* splitBar = nullptr;
    Comparison comparison;       ///< as shown
    TexelStore texelsBefore;     ///< shares with the document's texels what has not changed since
    bool otherSideDirty = false; ///< B shows other texels than were sent
    std::vector<std::uint32_t> faceColors; ///< shown in place of texels; empty when they are not
    bool faceColorsDirty = false;
    std::optional<TexelStore> otherTexels; ///< shown in place of the document's
    std::optional<SurfaceEdge> markedEdge;
    /// In the place of those of the hovered pixel.
    std::optional<std::vector<render::Polyline>> givenFootprints;

    LimitView limitView;
    bool limitDirty = false; ///< another tessellation is to be sent

    FaceSelection* selection = nullptr;
    std::vector<render::Polyline> selectionLines;
    QFutureWatcher<std::vector<render::Polyline>> outlineWatcher;
    bool outlineIsStale = false; ///< the selection changed while an outline was being made
    bool selectRemoves = false;
    std::shared_ptr<const std::vector<FaceId>> selectionBefore; ///< when the drag began
    glm::dvec2 selectedTo{0};                                   ///< device pixels

    std::optional<glm::dvec2> pointer;         ///< last position over the view
    std::optional<SurfacePoint> pointed;       ///< what is there
    std::unique_ptr<Inspection> ownInspection; ///< until another is used
    Inspection* inspection = nullptr;
    bool pointsItself = false;                ///< what changes is described once, at the end
    std::optional<HoveredTexel> hoveredTexel; ///< the texel looked at
    TexelReading reading;

    Interaction interaction = Interaction::None;
    Qt::MouseButton heldButton = Qt::NoButton;
    CameraDrag cameraDrag = CameraDrag::Orbit;
    glm::dvec2 pressPosition{0};
    glm::dvec2 lastPosition{0};
    std::optional<SurfacePoint> brushDragPoint; ///< where the ring stays meanwhile
    StrokeInput stroke;
    CardPainting painting;
    bool penStroke = false; ///< the pen is down: mouse events are its echo

private:
    void beginStroke(const PointerEvent& event);
    void straightLine(const PointerEvent& event);
    void addToStroke(const PointerSample& sample);
    void fillAt(glm::dvec2 position);
    void pickAt(glm::dvec2 position);
    void dragBrush(glm::dvec2 pixels);
};

} // namespace trixel::ui
