// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stop at the table of faces, and a picture for a ticket.
#include <QClipboard>
#include <QDockWidget>
#include <QGuiApplication>
#include <QHeaderView>
#include <QImage>

#include "app/tour/looks.h"
#include "app/tour/stops.h"
#include "ui/inspector/face_listing.h"
#include "ui/inspector/face_panel.h"
#include "ui/inspector/face_table_model.h"
#include "ui/inspector/face_table_view.h"
#include "ui/viewport/viewport.h"
#include "ui/window/message_bar.h"

#include <array>

namespace trixel::app {

namespace {

constexpr int kRows = 5; ///< that are selected; all of them can be seen

/// The middle of a row's first cell.
QPoint placeOf(const ui::FaceTableView& table, int row)
{
    return table.visualRect(table.model()->index(row, 0)).center();
}

} // namespace

Status Stops::faceTable()
{
    m_window.messages().dismiss();
    m_input.keys(QKeySequence(Qt::SHIFT | Qt::Key_F8));
    auto* panel = m_window.findChild<ui::FacePanel*>();
    if (Status there = expect(panel != nullptr, "Shift+F8 shows the table of faces"); !there) {
        return there;
    }
    auto* dock = qobject_cast<QDockWidget*>(panel->parentWidget());
    dock->raise();
    const auto isListed = [&] {
        return panel->model().rowCount() > 0 && !panel->listing().isBusy();
    };
    if (Status listed = expect(m_input.waitFor(isListed), "the faces are listed"); !listed) {
        return listed;
    }
    // The densest first: a click on the header for each direction.
    ui::FaceTableView& table = panel->table();
    QHeaderView* header = table.horizontalHeader();
    const int column = static_cast<int>(FaceColumn::Density);
    const QPoint title(header->sectionViewportPosition(column) + header->sectionSize(column) / 2,
                       header->height() / 2);
    for (int k = 0; k < 2 && header->sortIndicatorOrder() != Qt::DescendingOrder; ++k) {
        m_input.click(*header->viewport(), title);
    }
    if (Status sorted = expect(m_input.waitFor(isListed), "a click on a header sorts"); !sorted) {
        return sorted;
    }
    const std::array<QPoint, 3> rows{
        placeOf(table, 0), placeOf(table, kRows / 2), placeOf(table, kRows - 1)};
    m_input.drag(*table.viewport(), rows);
    const bool chosen = m_window.selection().faces().size() == kRows;
    if (Status selected = expect(chosen, "dragging over rows selects their faces"); !selected) {
        return selected;
    }
    m_input.hover(*table.viewport(), placeOf(table, 2));
    if (Status taken = picture("face-table"); !taken) {
        return taken;
    }
    m_input.keys(QKeySequence(Qt::SHIFT | Qt::Key_F8));
    m_window.selection().clear();
    return copiedPicture();
}

/// What goes into a ticket: the view with its legends and a line that tells what it is of.
Status Stops::copiedPicture()
{
    m_view.setFocus();
    m_input.keys(QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_C));
    const QImage copied = QGuiApplication::clipboard()->image();
    const bool whole = copied.width() >= m_view.width() && copied.height() > m_view.height();
    if (Status there = expect(whole, "Ctrl+Alt+C copies the view with its caption"); !there) {
        return there;
    }
    m_window.messages().dismiss();
    const std::filesystem::path file = m_folder / "view-with-caption.png";
    return copied.save(QString::fromStdString(file.string()))
               ? Status()
               : Status(pathError(file.string() + ": cannot be written"));
}

} // namespace trixel::app
