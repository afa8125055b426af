// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/panel_frames.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QRegularExpression>

#include "ui/window/panel_actions.h"

namespace trixel::ui {

namespace {

constexpr int kPanelWidth = 310;

QString tr(const char* text)
{
    return QCoreApplication::translate("trixel::ui::PanelFrames", text);
}

} // namespace

QDockWidget* PanelFrames::beside(const QString& name,
                                 const QString& title,
                                 QWidget* content,
                                 const QKeySequence& shortcut) const
{
    QDockWidget* dock = frame(name, title, content);
    m_window.addDockWidget(Qt::RightDockWidgetArea, dock);
    m_actions.add(*dock, shortcut);
    return dock;
}

QDockWidget* PanelFrames::below(const QString& name,
                                const QString& title,
                                QWidget* content,
                                const QKeySequence& shortcut) const
{
    QDockWidget* dock = frame(name, title, content);
    m_window.addDockWidget(Qt::BottomDockWidgetArea, dock);
    dock->hide();
    m_actions.add(*dock, shortcut);
    return dock;
}

QDockWidget* PanelFrames::frame(const QString& name, const QString& title, QWidget* content) const
{
    auto* dock = new QDockWidget(title);
    dock->setObjectName(name);
    dock->setWidget(content);
    dock->setMinimumWidth(kPanelWidth);
    // Behind other panels' tabs Qt calls a panel visible: hidden, it knows that nobody sees it.
    QObject::connect(dock, &QDockWidget::visibilityChanged, content, [content](bool seen) {
        content->setVisible(seen);
    });
    for (QWidget* button : dock->findChildren<QWidget*>(QRegularExpression("^qt_dockwidget_.*"))) {
        button->setToolTip(button->objectName().contains("close") ? tr("Close the panel")
                                                                  : tr("Detach the panel"));
    }
    return dock;
}

} // namespace trixel::ui
