// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/face_table_view.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QScopedValueRollback>
#include <QStyledItemDelegate>

#include "ui/document/face_selection.h"
#include "ui/document/inspection.h"
#include "ui/inspector/face_table_model.h"

#include <algorithm>
#include <utility>

namespace trixel::ui {

namespace {

constexpr glm::vec2 kCentroid{1.0F / 3.0F};
/// Digits that come sooner belong to one number.
constexpr qint64 kTypingMs = 1200;
/// Of a larger selection the first face is gone to, not the first row.
constexpr std::size_t kMostSought = 10'000;

/// Draws rows as the faces' selection says, and the inspected one lightly.
class FaceRowsDelegate : public QStyledItemDelegate
{
public:
    FaceRowsDelegate(const std::optional<FaceId>& looked, QObject* parent)
        : QStyledItemDelegate(parent)
        , m_looked(looked)
    {
    }

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        if (index.data(FaceTableModel::SelectedRole).toBool()) {
            option->state |= QStyle::State_Selected | QStyle::State_Active;
        } else if (m_looked && FaceId{index.data(FaceTableModel::FaceRole).toUInt()} == *m_looked) {
            constexpr float kLight = 0.3F;
            QColor light = option->palette.color(QPalette::Highlight);
            light.setAlphaF(kLight);
            option->backgroundBrush = light;
        }
    }

private:
    const std::optional<FaceId>& m_looked;
};

/// Keys that the table takes although commands of the window have them.
bool isTaken(const QKeyEvent& key)
{
    const Qt::KeyboardModifiers modifiers = key.modifiers() & ~Qt::KeypadModifier;
    if (key.matches(QKeySequence::SelectAll) || key.matches(QKeySequence::Copy)) {
        return true;
    }
    if ((modifiers & ~(Qt::ShiftModifier | Qt::ControlModifier)) != 0) {
        return false;
    }
    switch (key.key()) {
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
    case Qt::Key_Home:
    case Qt::Key_End:
    case Qt::Key_Space:
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        return modifiers == Qt::NoModifier;
    default:
        return modifiers == Qt::NoModifier && key.key() >= Qt::Key_0 && key.key() <= Qt::Key_9;
    }
}

bool movesRow(int key)
{
    return key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_PageUp ||
           key == Qt::Key_PageDown || key == Qt::Key_Home || key == Qt::Key_End;
}

} // namespace

FaceTableView::FaceTableView(FaceTableModel& model,
                             FaceSelection& selection,
                             Inspection& inspection,
                             QWidget* parent)
    : QTableView(parent)
    , m_model(model)
    , m_selection(selection)
    , m_inspection(inspection)
{
    setModel(&model);
    setItemDelegate(new FaceRowsDelegate(m_looked, this));
    setSelectionBehavior(SelectRows);
    setSelectionMode(SingleSelection); // of the current row; selectionCommand() selects nothing
    setEditTriggers(NoEditTriggers);
    setShowGrid(false);
    setAlternatingRowColors(true);
    setWordWrap(false);
    setTabKeyNavigation(false);
    setVerticalScrollMode(ScrollPerItem);
    setHorizontalScrollMode(ScrollPerPixel);
    viewport()->setMouseTracking(true);
    // Rows of one height, so that a million of them need no measuring.
    QHeaderView* rows = verticalHeader();
    rows->hide();
    rows->setSectionResizeMode(QHeaderView::Fixed);
    rows->setMinimumSectionSize(fontMetrics().height() + 4);
    rows->setDefaultSectionSize(fontMetrics().height() + 4);

    connect(&selection, &FaceSelection::changed, this, &FaceTableView::takeSelection);
    connect(&inspection, &Inspection::changed, this, &FaceTableView::takeInspection);
}

bool FaceTableView::goTo(FaceId face)
{
    const auto row = m_model.rowOf(face);
    if (row) {
        setCurrentIndex(m_model.index(*row, std::max(0, currentIndex().column())));
    }
    return row.has_value();
}

void FaceTableView::selectAll()
{
    if (m_model.rowCount() > 0) {
        chooseRange(0, m_model.rowCount() - 1, false);
    }
}

void FaceTableView::keyboardSearch(const QString& search)
{
    if (!m_typedAt.isValid() || m_typedAt.elapsed() > kTypingMs) {
        m_typed.clear();
    }
    m_typedAt.start();
    for (const QChar letter : search) {
        if (letter.isDigit()) {
            m_typed += letter;
        }
    }
    bool isNumber = false;
    const uint face = m_typed.toUInt(&isNumber);
    if (isNumber && goTo(FaceId{face})) {
        pointAtRow(currentIndex().row());
    } else if (isNumber) {
        emit notice(tr("Face %1 is not listed.").arg(face));
    }
}

QItemSelectionModel::SelectionFlags FaceTableView::selectionCommand(const QModelIndex& /*index*/,
                                                                    const QEvent* /*event*/) const
{
    return QItemSelectionModel::NoUpdate;
}

bool FaceTableView::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride &&
        isTaken(*static_cast<const QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    return QTableView::event(event);
}

void FaceTableView::keyPressEvent(QKeyEvent* event)
{
    if (event->matches(QKeySequence::Copy)) {
        emit copyWanted();
        return;
    }
    if (event->matches(QKeySequence::SelectAll)) {
        selectAll();
        return;
    }
    const QModelIndex before = currentIndex();
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        if (before.isValid()) {
            emit faceChosen(m_model.faceAt(before.row()));
        }
        return;
    }
    if (event->key() == Qt::Key_Space) {
        if (before.isValid()) {
            choose(before.row(), Qt::ControlModifier);
        }
        return;
    }
    if (movesRow(event->key()) && m_model.rowCount() > 0) {
        const bool toEnd = event->key() == Qt::Key_Home || event->key() == Qt::Key_End;
        if (toEnd) { // of the table, not of the row
            const int row = event->key() == Qt::Key_Home ? 0 : m_model.rowCount() - 1;
            setCurrentIndex(m_model.index(row, std::max(0, before.column())));
        } else {
            QTableView::keyPressEvent(event);
        }
        if (currentIndex().isValid()) {
            if (event->modifiers() != Qt::ControlModifier) {
                choose(currentIndex().row(), event->modifiers());
            }
            pointAtRow(currentIndex().row());
        }
        return;
    }
    QTableView::keyPressEvent(event);
}

void FaceTableView::mousePressEvent(QMouseEvent* event)
{
    const QModelIndex at = indexAt(event->position().toPoint());
    if (!at.isValid()) {
        return;
    }
    setCurrentIndex(at);
    if (event->button() == Qt::LeftButton) {
        m_pressed = at;
        choose(at.row(), event->modifiers());
    } else if (event->button() == Qt::RightButton &&
               !m_selection.contains(m_model.faceAt(at.row()))) {
        choose(at.row(), Qt::NoModifier);
    }
}

void FaceTableView::mouseMoveEvent(QMouseEvent* event)
{
    const QModelIndex at = indexAt(event->position().toPoint());
    if (event->buttons() == Qt::LeftButton && m_pressed.isValid() && at.isValid() &&
        at.row() != currentIndex().row()) {
        setCurrentIndex(at);
        chooseRange(anchorRow(), at.row(), event->modifiers() == Qt::ControlModifier);
    }
    if (at.isValid()) {
        pointAtRow(at.row());
    } else {
        m_inspection.pointAway();
    }
}

void FaceTableView::mouseReleaseEvent(QMouseEvent* /*event*/)
{
    m_pressed = QPersistentModelIndex();
}

void FaceTableView::mouseDoubleClickEvent(QMouseEvent* event)
{
    const QModelIndex at = indexAt(event->position().toPoint());
    if (event->button() == Qt::LeftButton && at.isValid()) {
        emit faceChosen(m_model.faceAt(at.row()));
    }
}

void FaceTableView::leaveEvent(QEvent* event)
{
    m_inspection.pointAway();
    QTableView::leaveEvent(event);
}

void FaceTableView::focusOutEvent(QFocusEvent* event)
{
    m_inspection.pointAway();
    QTableView::focusOutEvent(event);
}

int FaceTableView::anchorRow() const
{
    const auto row = m_anchor ? m_model.rowOf(*m_anchor) : std::nullopt;
    return row.value_or(std::max(0, currentIndex().row()));
}

void FaceTableView::choose(int row, Qt::KeyboardModifiers modifiers)
{
    const FaceId face = m_model.faceAt(row);
    if (modifiers.testFlag(Qt::ShiftModifier)) {
        chooseRange(anchorRow(), row, modifiers.testFlag(Qt::ControlModifier));
        return;
    }
    m_anchor = face;
    change([&] {
        if (!modifiers.testFlag(Qt::ControlModifier)) {
            m_selection.set({face});
        } else if (m_selection.contains(face)) {
            m_selection.remove({face});
        } else {
            m_selection.add({face});
        }
    });
}

void FaceTableView::chooseRange(int from, int to, bool adds)
{
    const std::span<const FaceId> faces = m_model.facesOf(std::min(from, to), std::max(from, to));
    if (!m_anchor) {
        m_anchor = m_model.faceAt(from);
    }
    std::vector<FaceId> chosen(faces.begin(), faces.end());
    change([&] {
        if (adds) {
            m_selection.add(std::move(chosen));
        } else {
            m_selection.set(std::move(chosen));
        }
    });
}

void FaceTableView::change(const std::function<void()>& work)
{
    const QScopedValueRollback choosing(m_isChoosing, true);
    work();
}

void FaceTableView::pointAtRow(int row)
{
    const QScopedValueRollback pointing(m_isPointing, true);
    m_inspection.pointAt(m_model.faceAt(row), kCentroid);
}

void FaceTableView::updateRow(std::optional<FaceId> face)
{
    const auto row = face ? m_model.rowOf(*face) : std::nullopt;
    if (row) {
        const QRect cell = visualRect(m_model.index(*row, 0));
        viewport()->update(0, cell.top(), viewport()->width(), cell.height());
    }
}

/// What was chosen elsewhere is gone to.
void FaceTableView::takeSelection()
{
    viewport()->update();
    if (m_isChoosing || m_selection.isEmpty() || !isVisible()) {
        return;
    }
    std::optional<int> first;
    const std::span<const FaceId> faces = m_selection.faces();
    for (const FaceId face : faces.first(std::min(faces.size(), kMostSought))) {
        const auto row = m_model.rowOf(face);
        if (row && (!first || *row < *first)) {
            first = row;
        }
    }
    if (first) {
        m_anchor = m_model.faceAt(*first);
        goTo(*m_anchor);
    }
}

/// The face that is pointed at elsewhere is lit; a held one is gone to as well.
void FaceTableView::takeInspection()
{
    const auto& texel = m_inspection.texel();
    const std::optional<FaceId> face =
        texel && m_inspection.isPointedAt() ? std::optional(texel->place.face) : std::nullopt;
    if (face == m_looked && !m_inspection.isHeld()) {
        return;
    }
    updateRow(std::exchange(m_looked, face));
    updateRow(face);
    if (face && m_inspection.isHeld() && !m_isPointing && isVisible()) {
        if (const auto row = m_model.rowOf(*face)) {
            scrollTo(m_model.index(*row, 0));
        }
    }
}

} // namespace trixel::ui
