// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/tool_actions.h"

#include <QAbstractSpinBox>
#include <QActionGroup>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QToolBar>

#include "ui/window/actions.h"

#include <utility>

namespace trixel::ui {

ToolActions::ToolActions(ViewSettings& settings, QWidget& window)
    : QObject(&window)
    , m_settings(settings)
    , m_window(window)
    , m_group(new QActionGroup(this))
{
    add(Tool::Brush, tr("&Brush"), tr("Paint with the brush"), Qt::Key_B, "brush");
    add(Tool::Eraser,
        tr("&Eraser"),
        tr("Go back to the colour before painting"),
        Qt::Key_E,
        "eraser");
    add(Tool::Fill, tr("&Fill"), tr("Give a face the brush's colour"), Qt::Key_G, "fill");
    add(Tool::Pick,
        tr("&Pick Colour"),
        tr("Take the colour of a texel (hold S)"),
        Qt::Key_unknown,
        "pick");
    add(Tool::Select, tr("&Select Faces"), tr("Choose faces"), Qt::Key_Q, "select");
    add(Tool::Inspect,
        tr("&Inspect Texels"),
        tr("Hold a texel to look at, step to its neighbours"),
        Qt::Key_I,
        "inspect");
    connect(&settings, &ViewSettings::toolChanged, this, &ToolActions::follow);
    qApp->installEventFilter(this);
    follow();
}

void ToolActions::add(
    Tool tool, const QString& text, const QString& toolTip, int key, const QString& iconName)
{
    const QKeySequence shortcut = key == Qt::Key_unknown ? QKeySequence() : QKeySequence(key);
    QAction* action = ActionMaker(m_window).toggle(text, toolTip, shortcut, iconName);
    m_group->addAction(action);
    m_actions[tool] = action;
    connect(action, &QAction::triggered, this, [this, tool] { m_settings.setTool(tool); });
}

void ToolActions::follow()
{
    const Tool tool = m_settings.tool();
    m_actions.at(tool)->setChecked(true);
    const BlendMode blend = tool == Tool::Eraser ? BlendMode::Erase : BlendMode::Normal;
    if (m_settings.brush().blend != blend) {
        Brush brush = m_settings.brush();
        brush.blend = blend;
        m_settings.setBrush(brush);
    }
}

void ToolActions::fillMenu(QMenu& menu)
{
    menu.addActions(m_group->actions());
}

void ToolActions::fillToolBar(QToolBar& bar)
{
    bar.addActions(m_group->actions());
}

QString ToolActions::hintFor(Tool tool)
{
    const QString navigate = tr("middle or Alt+drag: orbit · Shift+middle: pan · wheel: zoom");
    switch (tool) {
    case Tool::Brush:
        return tr("Drag to paint · [ ] size · hold S: pick · %1").arg(navigate);
    case Tool::Eraser:
        return tr("Drag to erase · [ ] size · %1").arg(navigate);
    case Tool::Fill:
        return tr("Click a face to fill it · %1").arg(navigate);
    case Tool::Select:
        return tr("Click or drag over faces to select · Shift adds · Ctrl removes · %1")
            .arg(navigate);
    case Tool::Inspect:
        return tr("Click a texel to hold it, again to let it go · arrow keys: next texel · "
                  "Ctrl+G: go to · %1")
            .arg(navigate);
    case Tool::Pick:
        break;
    }
    return tr("Click a texel to take its colour · %1").arg(navigate);
}

bool ToolActions::takesText() const
{
    const QWidget* focus = QApplication::focusWidget();
    return qobject_cast<const QLineEdit*>(focus) != nullptr ||
           qobject_cast<const QAbstractSpinBox*>(focus) != nullptr;
}

bool ToolActions::eventFilter(QObject* /*watched*/, QEvent* event)
{
    if (event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease) {
        const auto* key = static_cast<const QKeyEvent*>(event);
        if (key->key() != Qt::Key_S || key->isAutoRepeat()) {
            return false;
        }
        const bool down = event->type() == QEvent::KeyPress;
        const bool plain = key->modifiers() == Qt::NoModifier;
        if (down && plain && m_window.isActiveWindow() && !takesText() && !m_toolBeforePick) {
            m_toolBeforePick = m_settings.tool();
            m_settings.setTool(Tool::Pick);
        } else if (!down && m_toolBeforePick) {
            m_settings.setTool(*std::exchange(m_toolBeforePick, std::nullopt));
        }
    } else if (event->type() == QEvent::ApplicationStateChange && m_toolBeforePick) {
        // The release went to another program.
        m_settings.setTool(*std::exchange(m_toolBeforePick, std::nullopt));
    }
    return false;
}

} // namespace trixel::ui
