// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/mesh/surface.h"
#include "ui/import/import_settings.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;

namespace trixel::ui {

class PointRow;

/// Where the sphere of an image lies.
class SpherePage : public QWidget
{
    Q_OBJECT

public:
    explicit SpherePage(QWidget* parent = nullptr);

    SphereSettings settings() const;
    /// Round the middle of a surface.
    void takeSurface(const Surface& surface);

signals:
    void changed();

private:
    PointRow* m_centre;
    QComboBox* m_axis;
    QDoubleSpinBox* m_turn;
};

/// Where the plane of an image lies.
class PlanePage : public QWidget
{
    Q_OBJECT

public:
    explicit PlanePage(QWidget* parent = nullptr);

    PlaneSettings settings() const;
    /// Covers a surface.
    void takeSurface(const Surface& surface);
    /// \param aspect  of the image, its width over its height
    void setAspect(double aspect);

signals:
    void changed();

private:
    void makeSize(QFormLayout& form);
    void cover();
    void keepAspect();

    PointRow* m_centre;
    QComboBox* m_side;
    QDoubleSpinBox* m_turn;
    QDoubleSpinBox* m_width;
    QDoubleSpinBox* m_height;
    QCheckBox* m_keepsAspect;
    glm::dvec3 m_low{0};
    glm::dvec3 m_high{1};
    double m_aspect = 1;
    bool m_isSetting = false;
};

/// A field of degrees.
QDoubleSpinBox* makeTurn(const QString& name, const QString& toolTip);

} // namespace trixel::ui
