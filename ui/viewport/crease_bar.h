// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QCheckBox;
class QDoubleSpinBox;
class QLabel;

namespace trixel::ui {

class Document;

/// A line over a view to choose from which angle edges are creases of the limit surface. Every
/// change shows at once; all from opening to closing are one undo step. Esc or its button close it.
class CreaseBar : public QFrame
{
    Q_OBJECT

public:
    CreaseBar(QWidget& view, Document& document);

    void ask();
    /// Puts it at the top of the view, in the middle; to be called when the view's size changed.
    void place();

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void follow();
    void choose();
    void close();

    QWidget& m_view;
    Document& m_document;
    QCheckBox* m_isOn;
    QDoubleSpinBox* m_angle;
    QLabel* m_own;          ///< of the mesh's own creases
    bool m_goesOn = false;  ///< with the change before
    bool m_chooses = false; ///< what changes is by this bar
};

} // namespace trixel::ui
