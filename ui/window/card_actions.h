// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "ui/viewport/view_settings.h"

#include <array>
#include <utility>
#include <vector>

class QAction;
class QMenu;
class QWidget;

namespace trixel::ui {

/// The View menu's part of the graphics card: how much of its memory texels may take, and which
/// strokes it shows before the texels have them.
class CardActions : public QObject
{
    Q_OBJECT

public:
    CardActions(ViewSettings& settings, QWidget& window);

    void fillMenu(QMenu& menu);

private:
    void makeBudgets(QWidget& window);
    void makePainting(QWidget& window);
    void follow();

    ViewSettings& m_settings;
    std::vector<std::pair<QAction*, int>> m_budgets; ///< MiB
    std::array<QAction*, 3> m_painting{};            ///< by choice
};

} // namespace trixel::ui
