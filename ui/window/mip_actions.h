// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>

#include "ui/inspector/mip_view.h"

class QAction;
class QDockWidget;
class QMenu;
class QWidget;

namespace trixel::ui {

class MipPanel;

/// The View menu's part of the panel of mips: what it shows and how. Choosing brings it to the
/// front.
class MipActions : public QObject
{
    Q_OBJECT

public:
    /// \param dock  holds the panel
    MipActions(MipPanel& panel, QDockWidget& dock, QWidget& window);

    void fillMenu(QMenu& menu);

private:
    void makeContents(QWidget& window);
    void makeArrangements(QWidget& window);
    void show(const MipOptions& options);
    void follow();

    MipPanel& m_panel;
    QDockWidget& m_dock;
    QList<QAction*> m_contents; ///< in the order of MipContent
    QList<QAction*> m_texels;   ///< in the order of FaceLayout::Texels
    QAction* m_trueSize = nullptr;
};

} // namespace trixel::ui
