// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QRectF>

#include "ui/document/face_selection.h"
#include "ui/document/inspection.h"
#include "ui/inspector/layout_ink.h"
#include "ui/inspector/layout_scene.h"
#include "ui/inspector/shown_faces.h"
#include "ui/viewport/face_map.h"

class QPainter;

namespace trixel::ui {

/// What is drawn on texels. A value: kept in settings.
struct LayoutMarks
{
    bool grid = true;    ///< lines between texels
    bool tint = false;   ///< lower and upper texels in two hues
    bool centres = true; ///< where texels are sampled; in the packed square their triangles too
    bool values = true;
    bool indices = false;

    bool operator==(const LayoutMarks&) const = default;
};

/// Draws one view of the layout: texels, marks on them, and the frame that names edges, vertices
/// and faces. Made for one picture; refers to what it is given.
class LayoutPainter
{
public:
    /// \param toView  from the scene's plane to the painter's units
    /// \param area    in the painter's units; nothing is drawn beside it
    LayoutPainter(ShownFaces& faces,
                  const TexelFormat& format,
                  const LayoutScene& scene,
                  const PlaneMap& toView,
                  const QRectF& area,
                  const LayoutInk& ink,
                  const LayoutMarks& marks);

    /// Draws faces in the colours of numbers in place of their texels'. It outlives the painter.
    void setNumbers(const FaceNumbers* numbers) { m_numbers = numbers; }

    /// The texels and the grid into a picture whose pixels are the painter's units times `ratio`.
    void drawTexels(QImage& picture, double ratio) const;
    /// The same as shapes, for files that keep vectors. False, and nothing drawn, where there are
    /// too many.
    bool drawTexelShapes(QPainter& painter) const;
    /// The grid again, where something was laid over it.
    void drawGrid(QPainter& painter) const;
    /// Centres and numbers.
    void drawMarks(QPainter& painter, std::optional<std::uint16_t> channel) const;
    /// Outlines of faces, names of edges, vertices and neighbours.
    void drawFrame(QPainter& painter, const FaceSelection& selection) const;
    /// The texel looked at, wherever it is shown.
    void drawInspected(QPainter& painter, const InspectedTexel& texel, bool held) const;

private:
    FaceLayout placed(const SceneFace& face) const { return face.layout.moved(m_toView); }
    double gridStrength(const SceneFace& face) const;
    /// Opaque; nothing where texels are shown.
    std::optional<QRgb> numberColor(FaceId face) const;
    bool drawNumbersOn(QPainter& painter,
                       const SceneFace& face,
                       std::optional<std::uint16_t> channel) const;
    void drawCentresOn(QPainter& painter, const SceneFace& face, bool printed) const;
    void drawEdges(QPainter& painter) const;
    void drawVertices(QPainter& painter) const;
    void drawNeighbourNames(QPainter& painter) const;
    QLineF edgeLine(const FaceLayout& layout, LocalEdge edge) const;

    ShownFaces& m_faces;
    const TexelFormat& m_format;
    const LayoutScene& m_scene;
    PlaneMap m_toView;
    QRectF m_area;
    const LayoutInk& m_ink;
    const LayoutMarks& m_marks;
    const FaceNumbers* m_numbers = nullptr;
};

} // namespace trixel::ui
