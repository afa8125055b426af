// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QWidget>

#include "core/texture/value_histogram.h"
#include "render/look.h"

#include <memory>
#include <optional>
#include <vector>

namespace trixel::ui {

/// How often values occur, and the range that is shown between black and white, with a handle for
/// each end. The strip below the axis has the colours that values are shown in.
///
/// | what | how |
/// |---|---|
/// | set black or white | drag its handle; Left and Right, with Shift the black one |
/// | look closer | wheel, about the pointer |
/// | move along | drag beside the handles |
/// | see all again | double click, Home |
class HistogramView : public QWidget
{
    Q_OBJECT

public:
    struct Curve
    {
        QString name;
        QColor color;
        std::shared_ptr<const ValueHistogram> histogram; ///< not null
    };

    explicit HistogramView(QWidget* parent = nullptr);

    /// \param isUnit  values are integers that stand for [0, 1]
    void setCurves(std::vector<Curve> curves, bool isUnit);
    /// The range whose ends have handles, and the colours between.
    void setLook(const render::Look& look);
    /// Heights by the logarithm of the count, so that rare values show; or by the count itself.
    void setLogarithmic(bool logarithmic);
    bool isLogarithmic() const { return m_isLogarithmic; }

    /// Ends of the axis.
    double axisLow() const { return m_low; }
    double axisHigh() const { return m_high; }
    /// Where a value is in the widget, and back.
    double placeOf(double value) const;
    double valueAt(double x) const;
    void showAll();

    QSize sizeHint() const override { return {280, 150}; }
    QSize minimumSizeHint() const override { return {160, 110}; }

signals:
    /// A handle was moved: the values to show black and white, never equal.
    void rangeEdited(float black, float white);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    enum class Grip { None, Black, White, Axis };

    QRect plot() const;
    Grip gripAt(QPointF position) const;
    void moveEnd(Grip end, double value);
    void setAxis(double low, double high);
    void redraw();
    QImage picture() const;
    void paintStrip(QPainter& painter) const;
    void paintAxis(QPainter& painter) const;
    void paintHandle(QPainter& painter, double value, bool isBlack) const;
    QString textAt(QPointF position) const;

    std::vector<Curve> m_curves;
    bool m_isUnit = true;
    render::Look m_look;
    bool m_isLogarithmic = true;
    double m_low = 0;
    double m_high = 1;
    bool m_isZoomed = false; ///< by hand: the axis does not follow the values
    Grip m_held = Grip::None;
    double m_heldFrom = 0; ///< the handle's value less the pointer's, or the value held on the axis
    QImage m_picture;      ///< of the curves; null when it is to be made anew
};

} // namespace trixel::ui
