// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>

#include <filesystem>
#include <optional>

namespace trixel::ui {

class MainWindow;

/// What every program with Trixel's window does first: names for the settings, the OpenGL format,
/// style and theme. Before the `QApplication` is made: `prepareApplication`; after:
/// `setUpApplication`.
void prepareApplication();
void setUpApplication(QApplication& application);

/// Opens the window and runs it until it closes.
/// \param file  a project, a `.ptx` or a mesh; without one the sample scene opens
/// \return      the program's exit status
int runWindow(int argc, char** argv, const std::optional<std::filesystem::path>& file);

} // namespace trixel::ui
