// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/welcome.h"

#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace trixel::ui {

Welcome::Welcome(const QList<QAction*>& actions, QWidget* parent)
    : QWidget(parent)
{
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(10);
    layout->addStretch(1);
    auto* title = new QLabel(tr("Drop a mesh, a .ptx or a .trixel project here"));
    QFont large = title->font();
    large.setPointSizeF(large.pointSizeF() * 1.5);
    title->setFont(large);
    title->setToolTip(tr("Files can be dropped anywhere on the window"));
    auto* subtitle = new QLabel(tr("OBJ, PLY, STL and OFF meshes need no UVs: paint at once."));
    subtitle->setToolTip(title->toolTip());
    layout->addWidget(title, 0, Qt::AlignHCenter);
    layout->addWidget(subtitle, 0, Qt::AlignHCenter);
    layout->addSpacing(8);
    for (QAction* action : actions) {
        auto* button = new QPushButton(action->icon(), action->text());
        button->setToolTip(action->toolTip());
        button->setAccessibleName(QString(action->text()).remove('&'));
        button->setMinimumWidth(200);
        layout->addWidget(button, 0, Qt::AlignHCenter);
        connect(button, &QPushButton::clicked, action, &QAction::trigger);
    }
    layout->addStretch(1);
}

} // namespace trixel::ui
