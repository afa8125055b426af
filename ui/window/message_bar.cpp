// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/message_bar.h"

#include <QAccessible>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include "ui/window/icons.h"

namespace trixel::ui {

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent)
    , m_icon(new QLabel)
    , m_text(new QLabel)
    , m_button(new QPushButton)
    , m_close(new QToolButton)
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(10, 6, 6, 6);
    layout->setSpacing(8);
    layout->addWidget(m_icon);
    layout->addWidget(m_text, 1);
    layout->addWidget(m_button);
    layout->addWidget(m_close);

    setAutoFillBackground(true);
    m_icon->setAccessibleName(tr("Kind of message"));
    m_icon->setToolTip(tr("Message"));
    m_text->setWordWrap(true);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_text->setToolTip(tr("The text can be selected and copied"));
    m_close->setIcon(icon("close"));
    m_close->setAutoRaise(true);
    m_close->setAccessibleName(tr("Close message"));
    m_close->setToolTip(tr("Close this message"));
    connect(m_close, &QToolButton::clicked, this, &MessageBar::dismiss);
    connect(m_button, &QPushButton::clicked, this, [this] {
        const std::function<void()> act = m_act; // may show the next message
        dismiss();
        if (act) {
            act();
        }
    });
    hide();
}

void MessageBar::showMessage(Kind kind, const QString& sentence)
{
    showMessage(kind, sentence, {});
}

void MessageBar::showMessage(Kind kind, const QString& sentence, Remedy remedy)
{
    m_kind = kind;
    m_text->setText(sentence);
    m_text->setAccessibleName(sentence);
    m_act = std::move(remedy.act);
    m_button->setVisible(!remedy.text.isEmpty());
    m_button->setText(remedy.text);
    m_button->setAccessibleName(QString(remedy.text).remove('&'));
    m_button->setToolTip(QString(remedy.text).remove('&'));
    applyColors();
    show();
    QAccessibleEvent alert(m_text, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
}

void MessageBar::dismiss()
{
    m_act = {};
    m_text->clear();
    hide();
}

QString MessageBar::sentence() const
{
    return m_text->text();
}

void MessageBar::changeEvent(QEvent* event)
{
    QFrame::changeEvent(event);
    if (event->type() == QEvent::ApplicationPaletteChange) {
        applyColors();
    }
}

void MessageBar::applyColors()
{
    const bool error = m_kind == Kind::Error;
    // White on these darker tones reads well in either theme.
    QPalette colors;
    colors.setColor(QPalette::Window, error ? QColor(0x8c2b2b) : QColor(0x2b5878));
    colors.setColor(QPalette::WindowText, Qt::white);
    setPalette(colors);
    const int size = fontMetrics().height();
    m_icon->setPixmap(icon(error ? "error" : "note", Qt::white).pixmap(size, size));
    m_close->setIcon(icon("close", Qt::white));
}

} // namespace trixel::ui
