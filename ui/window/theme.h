// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPalette>
#include <QString>

#include <optional>

namespace trixel::ui {

/// Colours of the window. Greys are neutral, so that they don't tint the eye that judges paint.
enum class Theme { System, Dark, Light };

/// Name in the settings: "system", "dark", "light".
QString nameOf(Theme theme);
std::optional<Theme> themeFromName(const QString& name);

QPalette darkPalette();
QPalette lightPalette();

/// Whether the desktop asks for dark windows, by its portal, else by the palette it gave the
/// program at start. A bare X server that says nothing counts as dark.
bool systemIsDark();

/// Gives the application the Fusion style and the theme's palette.
void applyTheme(Theme theme);

} // namespace trixel::ui
