// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSurfaceFormat>

#include <optional>

namespace trixel::ui {

/// What the view asks for: OpenGL 4.1 core with a depth buffer; edges are smoothed where a graphics
/// card does it for free, not where the processor draws. Nothing where a context cannot be made, or
/// the platform has no windows for it: there a QOpenGLWidget would take the whole window down with
/// it. Tried once.
std::optional<QSurfaceFormat> usableFormat();

} // namespace trixel::ui
