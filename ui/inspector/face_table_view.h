// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QTableView>

#include "core/base/ids.h"

#include <functional>
#include <optional>
#include <vector>

namespace trixel::ui {

class FaceSelection;
class FaceTableModel;
class Inspection;

/// The table of faces. Its selection is the document's one selection of faces, in which a million
/// rows are no more work than one: rows are drawn as selected by asking for each that is seen.
///
/// | what | how |
/// |---|---|
/// | select one face, more, a range | click, Ctrl+click, Shift+click; drag; arrow keys, with Shift
/// | | select all listed | Ctrl+A | | select or not the current face | Space | | go to a face in
/// the view | double click, Enter | | go to a row | type the number of the face | | copy the
/// selected rows | Ctrl+C |
class FaceTableView : public QTableView
{
    Q_OBJECT

public:
    FaceTableView(FaceTableModel& model,
                  FaceSelection& selection,
                  Inspection& inspection,
                  QWidget* parent = nullptr);

    /// Makes the row of a face the current one and scrolls to it. False where it is not listed.
    bool goTo(FaceId face);
    /// Selects all listed faces.
    void selectAll() override;
    /// Goes to the face whose number is typed, digit by digit.
    void keyboardSearch(const QString& search) override;

signals:
    /// The user wants to see a face.
    void faceChosen(trixel::FaceId face);
    void copyWanted();
    /// One sentence about what could not be done.
    void notice(const QString& sentence);

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    QItemSelectionModel::SelectionFlags selectionCommand(const QModelIndex& index,
                                                         const QEvent* event) const override;

private:
    void choose(int row, Qt::KeyboardModifiers modifiers);
    void chooseRange(int from, int to, bool adds);
    void change(const std::function<void()>& work);
    void pointAtRow(int row);
    void updateRow(std::optional<FaceId> face);
    void takeSelection();
    void takeInspection();
    int anchorRow() const;

    FaceTableModel& m_model;
    FaceSelection& m_selection;
    Inspection& m_inspection;
    std::optional<FaceId> m_anchor; ///< where a range begins
    std::optional<FaceId> m_looked; ///< the inspected face, while it is pointed at
    QPersistentModelIndex m_pressed;
    bool m_isChoosing = false; ///< the selection changes from here
    bool m_isPointing = false; ///< the inspection changes from here
    QString m_typed;
    QElapsedTimer m_typedAt;
};

} // namespace trixel::ui
