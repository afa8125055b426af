// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/split_bar.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolButton>

#include "ui/viewport/filtering_words.h"
#include "ui/viewport/method_title.h"
#include "ui/viewport/view_settings.h"

#include <algorithm>
#include <utility>

namespace trixel::ui {

namespace {

constexpr int kWidth = 11; // logical pixels that the pointer can take hold of
constexpr int kGrip = 44;
constexpr int kGap = 6;
constexpr double kStep = 0.01;

QString coarserText(int levels)
{
    return levels == 0   ? SplitBar::tr("own levels")
           : levels == 1 ? SplitBar::tr("1 level coarser")
                         : SplitBar::tr("%1 levels coarser").arg(levels);
}

} // namespace

SplitBar::SplitBar(ViewSettings& settings,
                   QWidget* view,
                   int bottom,
                   std::function<bool(const ViewSettings&)> isShown)
    : QWidget(view)
    , m_settings(settings)
    , m_left(makeButton(view, tr("What A, left of the line, shows")))
    , m_right(makeButton(view, tr("What B, right of the line, shows")))
    , m_bottom(bottom)
    , m_isShown(std::move(isShown))
{
    setObjectName("splitBar");
    setAccessibleName(tr("Line between A and B"));
    setToolTip(tr("Drag the line, or move it by the arrow keys: A is left of it, B right"));
    setCursor(Qt::SplitHCursor);
    setFocusPolicy(Qt::StrongFocus);
    connect(&settings, &ViewSettings::comparisonChanged, this, &SplitBar::follow);
    connect(&settings, &ViewSettings::methodChanged, this, &SplitBar::follow);
    connect(&settings, &ViewSettings::viewChanged, this, &SplitBar::follow);
    follow();
}

QToolButton* SplitBar::makeButton(QWidget* view, const QString& name)
{
    auto* button = new QToolButton(view);
    button->setPopupMode(QToolButton::InstantPopup);
    button->setAccessibleName(name);
    button->setToolTip(name);
    button->setStyleSheet("QToolButton { background: rgba(22, 22, 24, 225); color: #e2e2e2; "
                          "border: none; border-radius: 4px; padding: 4px 14px 4px 8px; }");
    return button;
}

void SplitBar::setMenus(QMenu* left, QMenu* right)
{
    m_left->setMenu(left);
    m_right->setMenu(right);
}

QString SplitBar::leftText() const
{
    return m_left->text();
}

QString SplitBar::rightText() const
{
    return m_right->text();
}

void SplitBar::follow()
{
    const Comparison& comparison = m_settings.comparison();
    const int dropped = m_settings.view().mipDrop;
    switch (comparison.by) {
    case ComparedBy::Method:
        m_left->setText(tr("A: %1").arg(methodTitle(m_settings.method())));
        m_right->setText(tr("B: %1").arg(methodTitle(comparison.method)));
        break;
    case ComparedBy::Level:
        m_left->setText(tr("A: %1").arg(coarserText(dropped)));
        m_right->setText(tr("B: %1").arg(coarserText(dropped + comparison.levelsDropped)));
        break;
    case ComparedBy::Before:
        m_left->setText(tr("A: now"));
        m_right->setText(tr("B: before"));
        break;
    case ComparedBy::Filtering:
        m_left->setText(tr("A: %1").arg(filteringTitle(m_settings.view().filtering)));
        m_right->setText(tr("B: %1").arg(filteringTitle(comparison.filtering)));
        break;
    case ComparedBy::Nothing:
        break;
    }
    for (QWidget* widget : {static_cast<QWidget*>(this),
                            static_cast<QWidget*>(m_left),
                            static_cast<QWidget*>(m_right)}) {
        widget->setVisible(comparison.isOn() && (!m_isShown || m_isShown(m_settings)));
    }
    place();
}

void SplitBar::place()
{
    const QSize view = parentWidget()->size();
    const int line = static_cast<int>(m_settings.comparison().split * view.width());
    setGeometry(line - kWidth / 2, 0, kWidth, view.height());
    m_left->adjustSize();
    m_right->adjustSize();
    const int top = view.height() - m_bottom - m_left->height();
    m_left->move(line - kGap - m_left->width(), top);
    m_right->move(line + kGap, top);
}

void SplitBar::moveTo(double split)
{
    Comparison comparison = m_settings.comparison();
    comparison.split = std::clamp(split, 0.0, 1.0);
    m_settings.setComparison(comparison);
}

void SplitBar::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double middle = 0.5 * width();
    // Light on dark, so that it is seen over any texels.
    painter.setPen(QPen(QColor(0, 0, 0, 150), 3));
    painter.drawLine(QPointF(middle, 0), QPointF(middle, height()));
    painter.setPen(QPen(hasFocus() ? palette().color(QPalette::Highlight) : QColor(Qt::white), 1));
    painter.drawLine(QPointF(middle, 0), QPointF(middle, height()));
    painter.setBrush(QColor(22, 22, 24));
    painter.drawRoundedRect(QRectF(1.5, 0.5 * (height() - kGrip), width() - 3.0, kGrip), 4, 4);
}

void SplitBar::mousePressEvent(QMouseEvent* event)
{
    m_grabbedAt = event->position().toPoint().x() - width() / 2;
}

void SplitBar::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons().testFlag(Qt::LeftButton)) {
        const double x = mapTo(parentWidget(), event->position()).x() - m_grabbedAt;
        moveTo(x / std::max(1, parentWidget()->width()));
    }
}

void SplitBar::keyPressEvent(QKeyEvent* event)
{
    const double split = m_settings.comparison().split;
    switch (event->key()) {
    case Qt::Key_Left:
        return moveTo(split - kStep);
    case Qt::Key_Right:
        return moveTo(split + kStep);
    case Qt::Key_Home:
        return moveTo(0);
    case Qt::Key_End:
        return moveTo(1);
    default:
        QWidget::keyPressEvent(event);
    }
}

void SplitBar::focusInEvent(QFocusEvent* event)
{
    QWidget::focusInEvent(event);
    update();
}

void SplitBar::focusOutEvent(QFocusEvent* event)
{
    QWidget::focusOutEvent(event);
    update();
}

} // namespace trixel::ui
