// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "ui/viewport/view_settings.h"

#include <utility>
#include <vector>

class QAction;
class QComboBox;
class QMenu;
class QToolBar;
class QWidget;

namespace trixel::ui {

class Document;
class Viewport;

/// The View menu and tool bar: how the surface is drawn and from where.
class ViewActions : public QObject
{
    Q_OBJECT

public:
    ViewActions(const Document& document,
                ViewSettings& settings,
                Viewport& viewport,
                QWidget& window);

    void fillMenu(QMenu& menu);
    void fillToolBar(QToolBar& bar);

private:
    QAction* addSwitch(const QString& text,
                       const QString& toolTip,
                       const QKeySequence& shortcut,
                       const QString& iconName,
                       bool ViewOptions::*option);
    void followLimit();
    void makeLimit(Viewport& viewport);
    void makeMips();
    void setMipDrop(int drop);
    /// \param drop  shown then, if there are as many mips
    void listMips(int drop);
    void follow();

    const Document& m_document;
    ViewSettings& m_settings;
    QWidget& m_window;
    std::vector<std::pair<QAction*, bool ViewOptions::*>> m_switches;
    QAction* m_limit = nullptr;
    QAction* m_creases = nullptr;
    std::vector<std::pair<QAction*, double>> m_limitErrors; ///< pixels
    Viewport& m_viewport;
    QAction* m_frame = nullptr;
    QAction* m_frameAll = nullptr;
    QAction* m_coarser = nullptr;
    QAction* m_finer = nullptr;
    QComboBox* m_mips = nullptr;
};

} // namespace trixel::ui
