// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>

class QAction;
class QMenu;
class QWidget;

namespace trixel::ui {

class BrushColors;
class BrushPanel;
class ViewSettings;

/// The Brush menu: what the keys change without a trip to the panel.
class BrushActions : public QObject
{
    Q_OBJECT

public:
    BrushActions(ViewSettings& settings, BrushColors& colors, BrushPanel& panel, QWidget& window);

    void fillMenu(QMenu& menu);

    /// Radii stay within these parts of the surface's size; see `setSurfaceSize`.
    void setSurfaceSize(float size) { m_surfaceSize = size; }

private:
    void makeSizes();
    void makeOpacities();
    void scaleRadius(float factor);
    void addHardness(float step);

    ViewSettings& m_settings;
    QWidget& m_window;
    float m_surfaceSize = 2.0F;
    QList<QAction*> m_colorActions;
    QList<QAction*> m_sizeActions;
    QList<QAction*> m_opacityActions;
};

} // namespace trixel::ui
