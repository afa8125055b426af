// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QIcon>
#include <QString>

namespace trixel::ui {

/// One of the program's own line icons (`resources/icons/<name>.svg`), drawn in the colour of the
/// palette's text at the moment it is painted, so that it follows the theme; sharp at every scale.
QIcon icon(const QString& name);

/// The same in a fixed colour.
QIcon icon(const QString& name, const QColor& color);

} // namespace trixel::ui
