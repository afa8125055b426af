// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

#include <functional>

class QLabel;
class QPushButton;
class QToolButton;

namespace trixel::ui {

/// One sentence above the view, which stays usable: an error or a note, with a button for what can
/// be done about it. A new message takes the place of the last.
class MessageBar : public QFrame
{
    Q_OBJECT

public:
    enum class Kind { Note, Error };

    /// A way out offered beside the sentence.
    struct Remedy
    {
        QString text; ///< of the button, with a mnemonic
        std::function<void()> act;
    };

    explicit MessageBar(QWidget* parent = nullptr);

    void showMessage(Kind kind, const QString& sentence);
    void showMessage(Kind kind, const QString& sentence, Remedy remedy);
    void showNote(const QString& sentence) { showMessage(Kind::Note, sentence); }
    void showError(const QString& sentence) { showMessage(Kind::Error, sentence); }
    /// Takes away the message, if any.
    void dismiss();

    /// The sentence shown; empty when there is none.
    QString sentence() const;
    Kind kind() const { return m_kind; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void applyColors();

    Kind m_kind = Kind::Note;
    QLabel* m_icon;
    QLabel* m_text;
    QPushButton* m_button;
    QToolButton* m_close;
    std::function<void()> m_act;
};

} // namespace trixel::ui
