// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QWidget>

#include "render/split.h"
#include "ui/document/inspection.h"
#include "ui/inspector/layout_painter.h"

#include <memory>
#include <optional>
#include <vector>

namespace trixel::ui {

class Document;
class FaceSelection;
class NetFilter;
class ViewSettings;

/// What views of layouts draw from; all of it outlives them.
struct LayoutSources
{
    const Document& document;
    const ViewSettings& settings;
    const Inspection& inspection;
    const FaceSelection& selection;
    ShownFaces& faces;
    ShownFaces& others; ///< as B shows them
};

/// Whether the net shows what is compared, on either side of the split line.
bool splitsNet(const ViewSettings& settings);

/// One of the three views of the layout panel, with a pan and zoom of its own. Says what pointer
/// and keys mean; what is looked at is decided outside.
///
/// Drag with the left or the middle button to move, turn the wheel or drag with Alt and the right
/// button to zoom, click to hold a texel, double-click to frame its face.
class LayoutView : public QWidget
{
    Q_OBJECT

public:
    LayoutView(LayoutKind kind, const LayoutSources& sources, QWidget* parent = nullptr);

    LayoutKind kind() const { return m_kind; }

    /// Nothing to show.
    void clear();
    enum class Follow {
        Stay,  ///< pan and zoom stay as they are
        GoHome ///< the new scene is shown as large as the one before
    };
    void setScene(const LayoutScene& scene, Follow follow);
    const std::optional<LayoutScene>& scene() const { return m_scene; }
    /// The scene as B shows it, where its levels are others.
    void setOther(const std::optional<LayoutScene>& scene);
    /// Faces in the colours of numbers, or their texels again.
    void setNumbers(const std::shared_ptr<const FaceNumbers>& numbers);
    /// Draws what the filter makes of the texels while that is wanted. It outlives the view.
    void setFilter(NetFilter& filter);
    void setMarks(const LayoutMarks& marks);
    /// Draws anew: texels, levels or the selection differ.
    void refresh();
    /// The texel looked at differs. \param follow  whether to bring it into sight
    void refreshInspected(bool follow);

    /// One or two sentences below the title: what is special about what is shown, or what the
    /// view is.
    QString caption() const;

    const PlaneSight& sight() const { return m_sight; }
    void frame();
    /// A texel as large as a pixel of the screen.
    void showPixelForTexel();
    /// About the texel looked at if it is in sight, else about the middle.
    void zoomBy(double factor);
    /// Where a texel is shown, in the widget; nothing where it is not part of the scene.
    std::optional<QPointF> positionOf(const TexelPlace& place) const;

    /// Draws heading, view and coordinates into a rectangle, complete and not cached, with pan and
    /// zoom as they are on the screen. \param asShapes  texels as shapes where there are not too
    /// many, else as a picture
    void paintInto(QPainter& painter, const QRectF& area, const LayoutInk& ink, bool asShapes);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void pointedAt(const trixel::TexelPlace& place);
    void pointedAway();
    void chosen(const trixel::TexelPlace& place);
    void framed(const trixel::TexelPlace& place);
    void stepped(trixel::ui::Inspection::Step step);
    /// Space holds the texel looked at, or lets it go; Escape lets it go.
    void holdToggled();
    void letGo();
    /// By the user, so many times as large; other views may do the same.
    void zoomed(double factor);
    void framedAll();

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    enum class Drag { None, Press, Pan, Zoom };
    struct Rooms
    {
        QRectF heading, plane, footer;
    };

    /// Of the view that shows one side of the split line, or all.
    struct Part
    {
        QRectF area;
        ShownFaces* faces = nullptr;
        const LayoutScene* scene = nullptr;
        render::Side side = render::Side::A;
    };

    Rooms roomsIn(const QRectF& area, const LayoutInk& ink) const;
    /// \param whole  of which the split line stands at a part of the width
    std::vector<Part> partsOf(const QRectF& plane, const QRectF& whole) const;
    void askFilter(const QRectF& plane);
    bool drawFiltered(QPainter& painter, const Part& part, const PlaneMap& toView) const;
    void paintPart(QPainter& painter,
                   const Part& part,
                   const PlaneMap& toView,
                   const LayoutInk& ink,
                   bool asShapes) const;
    void drawSplit(QPainter& painter, const std::vector<Part>& parts, const LayoutInk& ink) const;
    void fitSight();
    void renderBase();
    void drawScene(const LayoutInk& ink, const QRectF& plane);
    LayoutPainter painterFor(const Part& part, const PlaneMap& toView, const LayoutInk& ink) const;
    void drawHeading(QPainter& painter, const QRectF& area, const LayoutInk& ink) const;
    void drawFooter(QPainter& painter, const QRectF& area, const LayoutInk& ink) const;
    QString coordinates() const;
    std::optional<LayoutScene::Hit> hitAt(QPointF position) const;
    void hoverAt(QPointF position);
    void zoomAt(double factor, QPointF position);

    LayoutKind m_kind;
    LayoutSources m_sources;
    std::optional<LayoutScene> m_scene;
    std::optional<LayoutScene> m_other;
    std::shared_ptr<const FaceNumbers> m_numbers;
    NetFilter* m_filter = nullptr;
    PlaneSight m_sight;
    LayoutMarks m_marks;
    Rooms m_rooms; ///< of the widget
    QImage m_base; ///< all but what changes with the texel looked at
    bool m_isStale = true;
    Drag m_drag = Drag::None;
    QPointF m_pressed;
    QPointF m_last;
};

/// "Net"
QString titleOf(LayoutKind kind);
/// One sentence for whoever sees it for the first time.
QString captionOf(LayoutKind kind);

} // namespace trixel::ui
