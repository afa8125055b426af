// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/swatches.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QPainter>
#include <QStyleOption>

#include <algorithm>

namespace trixel::ui {

namespace {

constexpr QSize kSmall(18, 18);

} // namespace

SwatchButton::SwatchButton(QSize size, QWidget* parent)
    : QAbstractButton(parent)
    , m_size(size)
{
    setFixedSize(size);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
}

void SwatchButton::setColor(const QColor& color)
{
    m_color = color;
    describe();
    update();
}

void SwatchButton::setPurpose(const QString& purpose)
{
    m_purpose = purpose;
    describe();
}

void SwatchButton::describe()
{
    const bool opaque = m_color.alpha() == 255;
    const QString code = m_color.name(opaque ? QColor::HexRgb : QColor::HexArgb);
    setToolTip(tr("%1: %2").arg(m_purpose, code));
    setAccessibleName(tr("%1 %2").arg(m_purpose, code));
}

void SwatchButton::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    const QRect inside = rect().adjusted(1, 1, -1, -1);
    if (m_color.alpha() < 255) {
        painter.fillRect(inside, Qt::white);
        painter.fillRect(inside, QBrush(Qt::gray, Qt::Dense4Pattern));
    }
    painter.fillRect(inside, m_color);
    const bool marked = hasFocus() || underMouse();
    painter.setPen(marked ? palette().color(QPalette::Highlight)
                          : palette().color(QPalette::Shadow));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
    if (hasFocus()) {
        painter.setPen(palette().color(QPalette::BrightText));
        painter.drawRect(rect().adjusted(1, 1, -2, -2));
    }
}

SwatchRow::SwatchRow(int perRow, const QString& purpose, QWidget* parent)
    : QWidget(parent)
    , m_perRow(perRow)
    , m_purpose(purpose)
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(2);
    grid->setColumnStretch(perRow, 1);
}

void SwatchRow::setColors(const std::vector<QColor>& colors)
{
    auto* grid = static_cast<QGridLayout*>(layout());
    while (m_swatches.size() < colors.size()) {
        auto* swatch = new SwatchButton(kSmall, this);
        swatch->setPurpose(m_purpose);
        const int k = static_cast<int>(m_swatches.size());
        grid->addWidget(swatch, k / m_perRow, k % m_perRow);
        connect(
            swatch, &SwatchButton::clicked, this, [this, swatch] { emit chosen(swatch->color()); });
        swatch->installEventFilter(this);
        m_swatches.push_back(swatch);
    }
    m_shown = colors.size();
    stopAt(std::min(m_stop, m_shown > 0 ? m_shown - 1 : 0));
    for (std::size_t k = 0; k < m_swatches.size(); ++k) {
        m_swatches[k]->setVisible(k < colors.size());
        if (k < colors.size()) {
            m_swatches[k]->setColor(colors[k]);
        }
    }
}

void SwatchRow::stopAt(std::size_t swatch)
{
    m_stop = swatch;
    for (std::size_t k = 0; k < m_swatches.size(); ++k) {
        m_swatches[k]->setFocusPolicy(k == m_stop ? Qt::StrongFocus : Qt::ClickFocus);
    }
}

bool SwatchRow::eventFilter(QObject* watched, QEvent* event)
{
    const auto at = std::ranges::find(m_swatches, watched);
    if (at == m_swatches.end()) {
        return false;
    }
    const auto here = static_cast<int>(at - m_swatches.begin());
    if (event->type() == QEvent::FocusIn) {
        stopAt(static_cast<std::size_t>(here));
    }
    if (event->type() != QEvent::KeyPress) {
        return false;
    }
    const int key = static_cast<const QKeyEvent*>(event)->key();
    const int step = key == Qt::Key_Left    ? -1
                     : key == Qt::Key_Right ? 1
                     : key == Qt::Key_Up    ? -m_perRow
                     : key == Qt::Key_Down  ? m_perRow
                                            : 0;
    if (step == 0) {
        return false;
    }
    const int next = here + step;
    if (next >= 0 && next < static_cast<int>(m_shown)) {
        m_swatches[static_cast<std::size_t>(next)]->setFocus(Qt::OtherFocusReason);
    }
    return true;
}

const std::vector<QColor>& paletteColors()
{
    static const std::vector<QColor> colors{
        0xffffff, 0xc8c8c8, 0xf2a7a0, 0xf5c78e, 0xf4e59a, 0xb9dd9c, 0x9fdcc6, 0x9ccbec,
        0xa9aef0, 0xdba8e4, 0xe9c9a9, 0xc09a78, 0x808080, 0x404040, 0xd8342b, 0xe8842a,
        0xe9c62c, 0x5fae3a, 0x1fa187, 0x2a7fc4, 0x4450c8, 0xa13bb5, 0x96613a, 0x5a3a22};
    return colors;
}

} // namespace trixel::ui
