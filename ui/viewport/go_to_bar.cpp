// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/go_to_bar.h"

#include <QFocusEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

#include "core/texture/texel_address.h"
#include "ui/document/inspection.h"

#include <algorithm>

namespace trixel::ui {

namespace {

constexpr int kWidth = 400;
constexpr int kMargin = 8;

QString textOf(const TexelPlace& place, Level level)
{
    return GoToBar::tr("Face %1, level %2, texel (%3, %4) %5, index %6.")
        .arg(indexOf(place.face))
        .arg(level.log2())
        .arg(place.texel.i)
        .arg(place.texel.j)
        .arg(place.texel.half == TexelHalf::Lower ? GoToBar::tr("lower") : GoToBar::tr("upper"))
        .arg(indexOf(texelIndex(level, place.texel)));
}

} // namespace

GoToBar::GoToBar(QWidget& view)
    : QFrame(&view)
    , m_view(view)
    , m_address(new QLineEdit)
    , m_verdict(new QLabel)
{
    setObjectName("goToBar");
    setFrameStyle(QFrame::StyledPanel | QFrame::Plain);
    setAutoFillBackground(true);
    setCursor(Qt::ArrowCursor);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(4);
    layout->addWidget(m_address);
    layout->addWidget(m_verdict);
    m_address->setPlaceholderText(tr("face · face:index · face:i,j,upper · face@u,v"));
    m_address->setAccessibleName(tr("Texel to go to"));
    m_address->setToolTip(tr("A face, and after it which of its texels: 12, 12:38, 12:3,1,upper "
                             "or 12@0.25,0.5. Enter goes there, Esc closes"));
    m_address->installEventFilter(this);
    m_verdict->setAccessibleName(tr("What the address names"));
    m_verdict->setWordWrap(true);
    m_verdict->setMinimumHeight(2 *
                                fontMetrics().height()); // a sentence of two lines moves nothing
    m_verdict->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    connect(m_address, &QLineEdit::textChanged, this, &GoToBar::judge);
    connect(m_address, &QLineEdit::returnPressed, this, &GoToBar::go);
    hide();
}

void GoToBar::ask(Inspection& inspection)
{
    m_inspection = &inspection;
    if (const auto& texel = inspection.texel(); texel && isHidden()) {
        m_address->setText(QString::fromStdString(toText(texel->place)));
    }
    judge(m_address->text());
    m_address->selectAll();
    place();
    show();
    raise();
    m_address->setFocus(Qt::ShortcutFocusReason);
}

void GoToBar::place()
{
    const int width = std::min(kWidth, m_view.width() - 2 * kMargin);
    setFixedWidth(width);
    adjustSize();
    move((m_view.width() - width) / 2, kMargin);
}

bool GoToBar::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::KeyPress &&
        static_cast<const QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        close();
        return true;
    }
    if (event->type() == QEvent::FocusOut) {
        const Qt::FocusReason reason = static_cast<const QFocusEvent*>(event)->reason();
        // Another program, or the field's own menu, is no reason to forget what was typed.
        if (reason != Qt::ActiveWindowFocusReason && reason != Qt::PopupFocusReason) {
            hide();
        }
    }
    return QFrame::eventFilter(watched, event);
}

void GoToBar::judge(const QString& text)
{
    bool isWrong = false;
    if (text.trimmed().isEmpty()) {
        m_verdict->setText(tr("Which texel? A face alone means its first one."));
    } else {
        const WalkedSurface surface = m_inspection->surface();
        const auto place = parseTexelAddress(text.toStdString(), surface);
        isWrong = !place;
        m_verdict->setText(place ? textOf(*place, surface.level(place->face))
                                 : QString::fromStdString(place.error().message));
    }
    m_verdict->setForegroundRole(isWrong ? QPalette::WindowText : QPalette::PlaceholderText);
    QPalette field;
    if (isWrong) {
        field.setColor(QPalette::Highlight, QColor(0xc0, 0x50, 0x20)); // the frame about the field
    }
    m_address->setPalette(field);
}

void GoToBar::go()
{
    if (m_inspection->goTo(m_address->text().toStdString())) {
        close();
    } else {
        m_address->selectAll();
    }
}

void GoToBar::close()
{
    hide();
    m_view.setFocus(Qt::OtherFocusReason);
}

} // namespace trixel::ui
