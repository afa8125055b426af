// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/crease_bar.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QScopedValueRollback>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/document/document.h"

namespace trixel::ui {

namespace {

constexpr int kMargin = 8;
constexpr double kFirstAngle = 30; // keeps what looks like an edge, and not what looks like a bend
constexpr double kStep = 5;

QString ownText(const Sharpness& sharpness)
{
    const int creases = static_cast<int>(sharpness.creases.size());
    const int vertices = static_cast<int>(sharpness.vertices.size());
    return CreaseBar::tr("Besides, the mesh says so of %1 and %2.")
        .arg(CreaseBar::tr("%Ln edge(s)", nullptr, creases),
             CreaseBar::tr("%Ln vertex(es)", nullptr, vertices));
}

} // namespace

CreaseBar::CreaseBar(QWidget& view, Document& document)
    : QFrame(&view)
    , m_view(view)
    , m_document(document)
    , m_isOn(new QCheckBox(tr("&Keep edges sharp that are folded by more than")))
    , m_angle(new QDoubleSpinBox)
    , m_own(new QLabel)
{
    setObjectName("creaseBar");
    setFrameStyle(QFrame::StyledPanel | QFrame::Plain);
    setAutoFillBackground(true);
    setCursor(Qt::ArrowCursor);
    auto* closing = new QToolButton;
    closing->setText(QStringLiteral("✕"));
    closing->setAutoRaise(true);
    closing->setAccessibleName(tr("Close"));
    closing->setToolTip(tr("Close (Esc)"));
    auto* line = new QHBoxLayout;
    line->addWidget(m_isOn);
    line->addWidget(m_angle);
    line->addWidget(closing);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(4);
    layout->addLayout(line);
    layout->addWidget(m_own);

    m_isOn->setToolTip(tr("Edges between faces that meet at more than the angle are creases of "
                          "the limit surface; off smooths all but the mesh's own"));
    m_angle->setRange(0, 180);
    m_angle->setDecimals(1);
    m_angle->setSingleStep(kStep);
    m_angle->setSuffix(QStringLiteral("°"));
    m_angle->setKeyboardTracking(false);
    m_angle->setAccessibleName(tr("Crease angle"));
    m_angle->setToolTip(tr("0° keeps every edge that is not flat, 180° none"));
    m_own->setAccessibleName(tr("Creases of the mesh"));
    m_own->setToolTip(tr("Creases and sharp vertices that the mesh's file names"));
    connect(m_isOn, &QCheckBox::toggled, this, &CreaseBar::choose);
    connect(m_angle, &QDoubleSpinBox::valueChanged, this, &CreaseBar::choose);
    connect(closing, &QToolButton::clicked, this, &CreaseBar::close);
    connect(&document, &Document::creasesChanged, this, &CreaseBar::follow);
    connect(&document, &Document::opened, this, &CreaseBar::hide);
    m_angle->setValue(kFirstAngle);
    follow();
    hide();
}

void CreaseBar::ask()
{
    m_goesOn = false;
    const Sharpness& own = m_document.surface()->mesh().sharpness;
    m_own->setVisible(!own.isEmpty());
    m_own->setText(ownText(own));
    follow();
    place();
    show();
    raise();
    m_isOn->setFocus(Qt::ShortcutFocusReason);
}

void CreaseBar::place()
{
    adjustSize();
    move((m_view.width() - width()) / 2, kMargin);
}

void CreaseBar::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape) {
        close();
    } else {
        QFrame::keyPressEvent(event);
    }
}

/// Shows what the document has.
void CreaseBar::follow()
{
    const CreaseAngle angle = m_document.creaseAngle();
    const QSignalBlocker quietSwitch(m_isOn);
    const QSignalBlocker quietAngle(m_angle);
    m_isOn->setChecked(angle.has_value());
    m_angle->setEnabled(angle.has_value());
    if (angle) {
        m_angle->setValue(double{*angle});
    }
    m_goesOn = m_goesOn && m_chooses; // undone meanwhile: another step
}

void CreaseBar::choose()
{
    const QScopedValueRollback<bool> chooses(m_chooses, true);
    m_document.setCreaseAngle(
        m_isOn->isChecked() ? CreaseAngle(static_cast<float>(m_angle->value())) : CreaseAngle(),
        m_goesOn);
    m_goesOn = true;
}

void CreaseBar::close()
{
    hide();
    m_view.setFocus(Qt::OtherFocusReason);
}

} // namespace trixel::ui
