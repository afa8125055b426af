// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/inspector/mip_painter.h"

#include <optional>
#include <vector>

namespace trixel::ui {

class MipFocus;
class ViewSettings;

/// All levels of a face side by side, the finest first, with the texel looked at, its parents and
/// its children lit in each.
class MipView : public QWidget
{
    Q_OBJECT

public:
    MipView(MipFocus& focus, const ViewSettings& settings, QWidget* parent = nullptr);

    const MipOptions& options() const { return m_options; }
    void setOptions(const MipOptions& options);

    /// As laid out now; empty without a face.
    std::vector<MipCell> cells() const;
    /// Whether every level is drawn.
    bool isComplete() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

    /// Draws all levels into a rectangle as large as `size` from (0,0), with pictures made for it.
    /// \param scale  pixels of the paper to one of the screen
    void paintOnto(QPainter& painter, QSizeF size, const MipInk& ink, double scale) const;

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Hit
    {
        Level level;
        TexelCoord texel;
        glm::vec2 uv;
    };

    std::optional<Hit> hitAt(QPointF position) const;
    /// Makes pictures that are missing, the coarsest first, for some milliseconds.
    void makePictures(const std::vector<MipCell>& cells);
    std::vector<MipCell> cellsIn(QSizeF size, const QFont& font) const;
    MipInk ink() const;
    QString tipAt(QPointF position) const;
    void chooseBeside(int steps);

    MipFocus& m_focus;
    const ViewSettings& m_settings;
    MipOptions m_options;
    MipPictures m_pictures;
};

} // namespace trixel::ui
