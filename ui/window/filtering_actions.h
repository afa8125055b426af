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

/// The commands that choose how the graphics card makes colours out of texels, for the whole view
/// or for A, and for B.
class FilteringActions : public QObject
{
    Q_OBJECT

public:
    FilteringActions(ViewSettings& settings, QWidget& window);

    void fillMenu(QMenu& menu);
    QMenu* ownMenu() const { return m_ownMenu; }     ///< of the view, or of A
    QMenu* otherMenu() const { return m_otherMenu; } ///< of B

private:
    using Ways = std::vector<std::pair<QAction*, render::Filtering>>;

    Ways makeWays(QWidget& window,
                  QMenu& menu,
                  const QString& pattern,
                  void (FilteringActions::*choose)(render::Filtering));
    void chooseOwn(render::Filtering filtering);
    void chooseOther(render::Filtering filtering);
    void toggle();
    void follow();

    ViewSettings& m_settings;
    QMenu* m_ownMenu;
    QMenu* m_otherMenu;
    QAction* m_toggle = nullptr;
    Ways m_own;
    Ways m_other;
};

} // namespace trixel::ui
