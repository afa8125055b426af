// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QPolygonF>
#include <QWidget>

#include <optional>
#include <vector>

namespace trixel::ui {

/// An image between four corners, drawn over the view: its outline, the lines of its bilinear map
/// and, faintly, the image itself. Lets the pointer through.
class QuadOverlay : public QWidget
{
    Q_OBJECT

public:
    /// Cells along each side.
    static constexpr int kCells = 8;

    explicit QuadOverlay(QWidget* view);

    /// \param points    (kCells + 1)² of them in the view's own pixels, rows from the image's lower
    ///                  edge; nothing behind the eye
    /// \param isUsable  whether the corners go round an area
    void setPlaces(std::vector<std::optional<QPointF>> points, bool isUsable);
    void setImage(const QImage& image);
    /// \param opacity  [0,1]
    void setImageOpacity(double opacity);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    const std::optional<QPointF>& at(int column, int row) const;
    QPolygonF along(bool isRow, int number) const;
    void paintImage(QPainter& painter) const;

    std::vector<std::optional<QPointF>> m_points;
    bool m_isUsable = true;
    QImage m_image;
    double m_opacity = 0.25;
};

} // namespace trixel::ui
