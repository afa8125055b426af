// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/style.h"

#include <QMainWindow>
#include <QPainter>
#include <QStyleOption>
#include <QTabBar>

namespace trixel::ui {

namespace {

/// Between a background and what is written on it.
QColor halfway(const QColor& a, const QColor& b)
{
    return {(a.red() + b.red()) / 2, (a.green() + b.green()) / 2, (a.blue() + b.blue()) / 2};
}

} // namespace

Style::Style()
    : QProxyStyle("Fusion")
{
}

void Style::polish(QWidget* widget)
{
    QProxyStyle::polish(widget);
    auto* tabs = qobject_cast<QTabBar*>(widget);
    if (tabs != nullptr && qobject_cast<QMainWindow*>(tabs->parentWidget()) != nullptr) {
        tabs->setElideMode(Qt::ElideNone); // the window asks for ElideRight when it makes them
    }
}

void Style::drawPrimitive(PrimitiveElement element,
                          const QStyleOption* option,
                          QPainter* painter,
                          const QWidget* widget) const
{
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    if (element == PE_IndicatorCheckBox || element == PE_IndicatorRadioButton) {
        const QPalette& palette = option->palette;
        const bool focused = (option->state & State_HasFocus) != 0;
        painter->save();
        painter->setBrush(Qt::NoBrush);
        painter->setPen(focused ? palette.color(QPalette::Highlight)
                                : halfway(palette.color(QPalette::Window),
                                          palette.color(QPalette::WindowText)));
        const QRect outline = option->rect.adjusted(0, 0, -1, -1);
        if (element == PE_IndicatorCheckBox) {
            painter->drawRect(outline);
        } else {
            painter->setRenderHint(QPainter::Antialiasing);
            painter->drawEllipse(QRectF(outline).adjusted(0.5, 0.5, -0.5, -0.5));
        }
        painter->restore();
    }
}

void Style::drawControl(ControlElement element,
                        const QStyleOption* option,
                        QPainter* painter,
                        const QWidget* widget) const
{
    if (element == CE_ToolBar) {
        painter->fillRect(option->rect, option->palette.window());
        return;
    }
    QProxyStyle::drawControl(element, option, painter, widget);
}

int Style::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const
{
    constexpr int kTabSpace =
        12; // left and right of a tab's text, so that six panels can be told apart
    return metric == PM_TabBarTabHSpace ? kTabSpace
                                        : QProxyStyle::pixelMetric(metric, option, widget);
}

int Style::styleHint(StyleHint hint,
                     const QStyleOption* option,
                     const QWidget* widget,
                     QStyleHintReturn* answer) const
{
    return hint == SH_DialogButtonBox_ButtonsHaveIcons
               ? 0
               : QProxyStyle::styleHint(hint, option, widget, answer);
}

} // namespace trixel::ui
