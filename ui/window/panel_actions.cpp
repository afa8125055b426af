// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/panel_actions.h"

#include <QAbstractSpinBox>
#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QKeyEvent>
#include <QMainWindow>
#include <QMenu>
#include <QSettings>

#include "ui/window/actions.h"
#include "ui/window/theme.h"

#include <utility>

namespace trixel::ui {

namespace {

constexpr auto kThemeKey = "view/theme";

} // namespace

PanelActions::PanelActions(QMainWindow& window, QWidget& view)
    : QObject(&window)
    , m_window(window)
    , m_view(view)
{
    ActionMaker make(window);
    m_toggleAll = make(tr("&Hide Panels"),
                       tr("Give the whole window to the view, or bring the panels back"),
                       {Qt::Key_Tab});
    // In the view alone: in the panels Tab goes from field to field.
    window.removeAction(m_toggleAll);
    view.addAction(m_toggleAll);
    m_toggleAll->setShortcutContext(Qt::WidgetShortcut);
    m_next = make(tr("&Next Panel"), tr("Move the keyboard to the next panel"), {Qt::Key_F6});
    connect(m_toggleAll, &QAction::triggered, this, &PanelActions::toggleAll);
    connect(m_next, &QAction::triggered, this, &PanelActions::focusNext);
    makeThemes();
    qApp->installEventFilter(this);
}

void PanelActions::add(QDockWidget& dock, const QKeySequence& shortcut)
{
    QAction* action = dock.toggleViewAction();
    action->setShortcut(shortcut);
    action->setToolTip(tr("Show or hide the panel %1 (%2)")
                           .arg(dock.windowTitle(), shortcut.toString(QKeySequence::NativeText)));
    // Among those that share its place, too, what was asked for is in front.
    connect(action, &QAction::triggered, &dock, [&dock](bool shown) {
        if (shown) {
            dock.raise();
        }
    });
    m_window.addAction(action);
    m_docks += &dock;
}

void PanelActions::fillMenu(QMenu& menu)
{
    QMenu* panels = menu.addMenu(tr("&Panels"));
    for (QDockWidget* dock : std::as_const(m_docks)) {
        panels->addAction(dock->toggleViewAction());
    }
    panels->addSeparator();
    panels->addAction(m_toggleAll);
    panels->addAction(m_next);
    menu.addMenu(tr("T&heme"))->addActions(m_themes);
}

void PanelActions::toggleAll()
{
    if (!m_hidden.isEmpty()) {
        for (QDockWidget* dock : std::exchange(m_hidden, {})) {
            dock->show();
        }
        return;
    }
    for (QDockWidget* dock : std::as_const(m_docks)) {
        if (!dock->isHidden()) {
            m_hidden += dock;
            dock->hide();
        }
    }
}

void PanelActions::focusNext()
{
    QList<QWidget*> stops{&m_view};
    for (QDockWidget* dock : std::as_const(m_docks)) {
        if (!dock->isHidden()) {
            stops += dock->widget();
        }
    }
    qsizetype at = 0;
    for (qsizetype k = 0; k < stops.size(); ++k) {
        const QWidget* focus = QApplication::focusWidget();
        if (focus != nullptr && (stops[k] == focus || stops[k]->isAncestorOf(focus))) {
            at = k;
        }
    }
    QWidget* next = stops[(at + 1) % stops.size()];
    if (auto* dock = qobject_cast<QDockWidget*>(next->parentWidget())) {
        dock->raise();
    }
    if (next->focusPolicy() == Qt::NoFocus) {
        for (QWidget* child : next->findChildren<QWidget*>()) {
            const bool takesTab = (child->focusPolicy() & Qt::TabFocus) != 0;
            if (takesTab && child->isEnabled() && child->isVisibleTo(next)) {
                next = child;
                break;
            }
        }
    }
    next->setFocus(Qt::TabFocusReason);
}

void PanelActions::makeThemes()
{
    auto* group = new QActionGroup(this);
    const Theme current =
        themeFromName(QSettings().value(kThemeKey).toString()).value_or(Theme::System);
    const std::pair<Theme, QString> choices[] = {
        {Theme::System, tr("Like the &System")},
        {Theme::Dark, tr("&Dark")},
        {Theme::Light, tr("&Light")},
    };
    for (const auto& [theme, text] : choices) {
        QAction* action = ActionMaker(m_window).toggle(text, tr("Colours of the window"));
        action->setChecked(theme == current);
        group->addAction(action);
        m_themes += action;
        connect(action, &QAction::triggered, this, [chosen = theme] {
            QSettings().setValue(kThemeKey, nameOf(chosen));
            applyTheme(chosen);
        });
    }
}

bool PanelActions::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<const QKeyEvent*>(event)->key();
        const bool leaves = key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Escape;
        auto* field = qobject_cast<QAbstractSpinBox*>(watched);
        if (leaves && field != nullptr && field->window() == &m_window) {
            field->interpretText();
            m_view.setFocus();
            return true;
        }
    }
    return false;
}

} // namespace trixel::ui
