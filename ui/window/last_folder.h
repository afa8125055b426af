// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace trixel::ui {

/// The folder last used, kept over sessions; the home folder at first.
QString lastFolder();
/// The same, or the home folder where nothing can be written to that.
QString folderToSaveIn();
void rememberFolderOf(const QString& path);

} // namespace trixel::ui
