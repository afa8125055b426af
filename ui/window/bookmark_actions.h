// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>

class QAction;
class QDockWidget;
class QMenu;
class QWidget;

namespace trixel::ui {

class Document;
class ViewsPanel;

/// The View menu's part of the bookmarked views: keep one, go to one, manage them.
class BookmarkActions : public QObject
{
    Q_OBJECT

public:
    /// \param dock  holds the panel
    BookmarkActions(Document& document, ViewsPanel& panel, QDockWidget& dock, QWidget& window);

    void fillMenu(QMenu& menu);

private:
    void makePlaces(QWidget& window);
    void listMore();
    void follow();
    void manage();

    Document& m_document;
    ViewsPanel& m_panel;
    QDockWidget& m_dock;
    QAction* m_bookmark;
    QAction* m_addDistant;
    QAction* m_load;
    QAction* m_save;
    QAction* m_manage;
    QMenu* m_menu = nullptr;
    QAction* m_afterPlaces = nullptr;
    QList<QAction*> m_places; ///< the first cameras; hidden where there are fewer
    QList<QAction*> m_more;   ///< those after, made when the menu opens
};

} // namespace trixel::ui
