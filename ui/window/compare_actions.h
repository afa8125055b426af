// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "ui/viewport/view_settings.h"

#include <utility>
#include <vector>

class QAction;
class QMenu;
class QWidget;

namespace trixel::ui {

class FilteringActions;
class MapActions;
class Viewport;

/// The commands that split the view to compare two filters, two levels, or the texels before and
/// after.
class CompareActions : public QObject
{
    Q_OBJECT

public:
    /// \param maps  has the menu of A's filter
    CompareActions(ViewSettings& settings,
                   MapActions& maps,
                   FilteringActions& filterings,
                   Viewport& viewport,
                   QWidget& window);

    void fillMenu(QMenu& menu);

signals:
    /// The present texels are those before from now on.
    void remembered();

private:
    void makeWays(QWidget& window);
    void makeMethods(QWidget& window);
    void makeLevels(QWidget& window);
    void compare(ComparedBy by);
    void swapMethods();
    void dropLevels(int more);
    void follow();

    ViewSettings& m_settings;
    MapActions& m_maps;
    FilteringActions& m_filterings;
    Viewport& m_viewport;
    std::vector<std::pair<QAction*, ComparedBy>> m_ways;
    std::vector<std::pair<QAction*, std::string>> m_methods;
    QMenu* m_methodMenu;
    QMenu* m_levelMenu;
    QMenu* m_beforeMenu;
    QAction* m_swap = nullptr;
    QAction* m_coarser = nullptr;
    QAction* m_finer = nullptr;
    QAction* m_remember = nullptr;
};

} // namespace trixel::ui
