// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/last_folder.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>

namespace trixel::ui {

namespace {

constexpr auto kFolderKey = "files/folder";

} // namespace

QString lastFolder()
{
    return QSettings().value(kFolderKey, QDir::homePath()).toString();
}

QString folderToSaveIn()
{
    const QString folder = lastFolder();
    return QFileInfo(folder).isWritable() ? folder : QDir::homePath();
}

void rememberFolderOf(const QString& path)
{
    QSettings().setValue(kFolderKey, QFileInfo(path).absolutePath());
}

} // namespace trixel::ui
