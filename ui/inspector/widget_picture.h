// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QWidget>

#include "ui/inspector/picture_source.h"

#include <memory>

namespace trixel::ui {

/// What a picture of a panel is made of: itself or the one widget in it that knows how to draw
/// itself for that, a chart, or else its widgets as they are. It ends with the panel.
/// \param name  of the file, for widgets as they are
std::unique_ptr<PictureSource> pictureOf(QWidget& panel, const QString& name);

} // namespace trixel::ui
