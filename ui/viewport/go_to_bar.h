// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QLabel;
class QLineEdit;

namespace trixel::ui {

class Inspection;

/// A line over a view to write in which texel to go to. While it is written in, it says what is
/// named so far, or what was expected instead. Enter goes there; Esc, and the keyboard going
/// elsewhere, close it.
class GoToBar : public QFrame
{
    Q_OBJECT

public:
    explicit GoToBar(QWidget& view);

    /// Opens with the address of the texel looked at, to be written over.
    void ask(Inspection& inspection);
    /// Puts it at the top of the view, in the middle; to be called when the view's size changed.
    void place();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void judge(const QString& text);
    void go();
    void close();

    QWidget& m_view;
    Inspection* m_inspection = nullptr;
    QLineEdit* m_address;
    QLabel* m_verdict;
};

} // namespace trixel::ui
