// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "ui/viewport/view_settings.h"

#include <string>
#include <utility>
#include <vector>

class QAction;
class QMenu;
class QWidget;

namespace trixel::ui {

/// The commands that choose what is computed over the view, and the filter it is computed with.
class MapActions : public QObject
{
    Q_OBJECT

public:
    MapActions(ViewSettings& settings, QWidget& window);

    void fillMenu(QMenu& menu);
    /// Between the texels as they are and the filtered picture; on while that is shown.
    QAction* filteredAction() const { return m_toggle; }
    /// Of all filter methods; there once the menu is filled.
    QMenu* methodMenu() const { return m_methodMenu; }

private:
    void makeMaps(QWidget& window);
    void makeToggle(QWidget& window);
    void makeMethods(QWidget& window);
    void follow();

    ViewSettings& m_settings;
    QAction* m_toggle = nullptr;
    QMenu* m_methodMenu = nullptr;
    std::vector<std::pair<QAction*, ViewMapKind>> m_maps;
    std::vector<std::pair<QAction*, std::string>> m_methods;
};

} // namespace trixel::ui
