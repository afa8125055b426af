// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stop at the bookmarked views.
#include <QDockWidget>
#include <QLineEdit>
#include <QTreeView>

#include "app/tour/looks.h"
#include "app/tour/stops.h"
#include "ui/document/view_bookmarks.h"
#include "ui/viewport/viewport.h"

#include <array>
#include <glm/geometric.hpp>

namespace trixel::app {

Status Stops::bookmarkedViews()
{
    ui::Viewport& view = m_window.viewport();
    const ui::ViewBookmarks& bookmarks = m_window.document().bookmarks();
    auto* dock = m_window.findChild<QDockWidget*>("viewsPanel");
    dock->raise();
    m_view.setFocus();
    view.lookFrom(48, 12, 1.25);
    m_input.keys(QKeySequence(Qt::CTRL | Qt::Key_B));
    const ViewCamera hero = view.view();
    // Past the chameleon, seen from its other side.
    m_input.drag(m_view, std::array{inView(0.5, 0.5), inView(0.85, 0.6)}, Qt::AltModifier);
    m_input.wheel(m_view, inView(0.4, 0.4), 3);
    m_input.keys(QKeySequence(Qt::CTRL | Qt::Key_B));
    if (Status kept = expect(bookmarks.count() == 2, "Ctrl+B bookmarks the view"); !kept) {
        return kept;
    }
    auto* list = dock->findChild<QTreeView*>();
    for (int k = 0; k < 2; ++k) {
        list->setCurrentIndex(list->model()->index(k, 0));
        list->setFocus();
        m_input.press(*list, Qt::Key_F2);
        auto* field = list->findChild<QLineEdit*>();
        if (Status edits = expect(field != nullptr, "F2 edits the name of a view"); !edits) {
            return edits;
        }
        m_input.type(*field, k == 0 ? "Hero" : "Far side");
        m_input.press(*field, Qt::Key_Return);
    }
    if (Status added = press(*dock, "Add any view beyond a distance"); !added) {
        return added;
    }
    m_input.keys(QKeySequence(Qt::ALT | Qt::Key_1));
    const ViewCamera back = view.view();
    // A camera is angles and a distance: its place comes back to rounding.
    const bool same = bookmarks.name(0) == "Hero" &&
                      glm::distance(back.position, hero.position) <
                          1e-9 * glm::distance(hero.position, hero.target) &&
                      back.target == hero.target;
    if (Status went = expect(same, "Alt+1 goes to the first view"); !went) {
        return went;
    }
    const Status taken = picture("bookmarked-views");
    m_window.findChild<QDockWidget*>("readoutPanel")->raise();
    m_view.setFocus();
    return taken;
}

} // namespace trixel::app
