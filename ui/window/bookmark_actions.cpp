// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/bookmark_actions.h"

#include <QDockWidget>
#include <QMenu>
#include <QTreeView>

#include "ui/docks/camera_files.h"
#include "ui/docks/views_panel.h"
#include "ui/document/document.h"
#include "ui/document/view_bookmarks.h"
#include "ui/window/actions.h"

#include <algorithm>

namespace trixel::ui {

namespace {

constexpr int kPlaces = 9;       // Alt+1 to Alt+9
constexpr int kMostListed = 30;  // in the menu; the panel has all
constexpr int kLongestText = 40; // of a menu entry, in characters

/// A name as a menu shows it.
QString menuText(QString name)
{
    if (name.size() > kLongestText) {
        name = name.left(kLongestText) + "…";
    }
    return name.replace('&', "&&");
}

} // namespace

BookmarkActions::BookmarkActions(Document& document,
                                 ViewsPanel& panel,
                                 QDockWidget& dock,
                                 QWidget& window)
    : QObject(&window)
    , m_document(document)
    , m_panel(panel)
    , m_dock(dock)
{
    ActionMaker make(window);
    m_bookmark = make(tr("&Bookmark View"),
                      tr("Keep what the view shows among the project's views"),
                      QKeySequence(Qt::CTRL | Qt::Key_B));
    m_addDistant = make(tr("&Any View Beyond…"),
                        tr("Count every view no closer to the surface than this one"));
    m_load = make(tr("&Load Cameras…"), tr("Add the views of a cameras file (JSON)"));
    m_save = make(tr("&Save Cameras…"), tr("Write the bookmarked views to a cameras file"));
    m_manage = make(tr("&Manage…"), tr("List the bookmarked views: rename, change, remove"));
    connect(m_bookmark, &QAction::triggered, &panel, &ViewsPanel::bookmark);
    connect(m_addDistant, &QAction::triggered, this, [this] {
        manage(); // its distance is there to be changed
        m_panel.addDistant();
    });
    connect(m_load, &QAction::triggered, &panel.files(), &CameraFiles::askForLoad);
    connect(m_save, &QAction::triggered, &panel.files(), &CameraFiles::askForSave);
    connect(m_manage, &QAction::triggered, this, &BookmarkActions::manage);
    makePlaces(window);
    connect(&document, &Document::opened, this, &BookmarkActions::follow);
    connect(&document.bookmarks(), &ViewBookmarks::changed, this, &BookmarkActions::follow);
    follow();
}

void BookmarkActions::makePlaces(QWidget& window)
{
    ActionMaker make(window);
    for (int k = 0; k < kPlaces; ++k) {
        QAction* place = make(tr("View &%1").arg(k + 1),
                              tr("Go to this view"),
                              QKeySequence(Qt::ALT | static_cast<Qt::Key>(Qt::Key_1 + k)));
        connect(place, &QAction::triggered, this, [this, k] { m_panel.goTo(k); });
        m_places += place;
    }
}

void BookmarkActions::follow()
{
    const ViewBookmarks& bookmarks = m_document.bookmarks();
    const bool open = m_document.isOpen();
    for (QAction* action : {m_bookmark, m_addDistant, m_load}) {
        action->setEnabled(open);
    }
    m_save->setEnabled(!bookmarks.isEmpty());
    const int cameras = static_cast<int>(bookmarks.views().cameras.size());
    for (int k = 0; k < kPlaces; ++k) {
        const bool exists = k < cameras;
        m_places[k]->setVisible(exists);
        m_places[k]->setEnabled(exists);
        if (exists) {
            m_places[k]->setText(tr("&%1  %2").arg(k + 1).arg(menuText(bookmarks.name(k))));
        }
    }
}

void BookmarkActions::listMore()
{
    qDeleteAll(m_more);
    m_more.clear();
    const ViewBookmarks& bookmarks = m_document.bookmarks();
    const int cameras = static_cast<int>(bookmarks.views().cameras.size());
    for (int k = kPlaces; k < std::min(cameras, kMostListed); ++k) {
        auto* place = new QAction(menuText(bookmarks.name(k)), m_menu);
        place->setToolTip(tr("Go to this view"));
        connect(place, &QAction::triggered, this, [this, k] { m_panel.goTo(k); });
        m_more += place;
    }
    m_menu->insertActions(m_afterPlaces, m_more);
}

void BookmarkActions::manage()
{
    m_dock.show();
    m_dock.raise();
    if (auto* list = m_dock.findChild<QTreeView*>();
        list != nullptr && list->isVisibleTo(&m_dock)) {
        list->setFocus(Qt::ShortcutFocusReason);
    }
}

void BookmarkActions::fillMenu(QMenu& menu)
{
    menu.addAction(m_bookmark);
    m_menu = menu.addMenu(tr("Bookmarked &Views"));
    m_menu->addActions(m_places);
    m_afterPlaces = m_menu->addSeparator();
    m_menu->addActions({m_addDistant, m_load, m_save, m_manage});
    connect(m_menu, &QMenu::aboutToShow, this, &BookmarkActions::listMore);
}

} // namespace trixel::ui
