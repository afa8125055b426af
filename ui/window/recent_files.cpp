// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/recent_files.h"

#include <QAction>
#include <QFileInfo>
#include <QMenu>
#include <QSettings>

namespace trixel::ui {

namespace {

constexpr auto kKey = "files/recent";

} // namespace

RecentFiles::RecentFiles(QObject* parent)
    : QObject(parent)
{
}

QStringList RecentFiles::paths() const
{
    return QSettings().value(kKey).toStringList().mid(0, kMax);
}

void RecentFiles::add(const QString& path)
{
    const QString absolute = QFileInfo(path).absoluteFilePath();
    QStringList all = paths();
    all.removeAll(absolute);
    all.prepend(absolute);
    QSettings().setValue(kKey, all.mid(0, kMax));
}

void RecentFiles::clear()
{
    QSettings().remove(kKey);
}

void RecentFiles::attachTo(QMenu& menu)
{
    menu.setToolTipsVisible(true);
    connect(&menu, &QMenu::aboutToShow, this, [this, &menu] { fill(menu); });
    fill(menu);
}

void RecentFiles::fill(QMenu& menu)
{
    menu.clear();
    int number = 0;
    for (const QString& path : paths()) {
        const QFileInfo file(path);
        const bool isThere = file.exists();
        ++number;
        QString name = file.fileName();
        name.replace('&', "&&");
        const QString label = number < 10 ? QString("&%1  %2").arg(number).arg(name) : name;
        QAction* action = menu.addAction(isThere ? label : tr("%1 (missing)").arg(label));
        action->setToolTip(path);
        action->setEnabled(isThere);
        connect(action, &QAction::triggered, this, [this, path] { emit chosen(path); });
    }
    if (number == 0) {
        menu.addAction(tr("No files yet"))->setEnabled(false);
        return;
    }
    menu.addSeparator();
    connect(menu.addAction(tr("&Clear list")), &QAction::triggered, this, &RecentFiles::clear);
}

} // namespace trixel::ui
