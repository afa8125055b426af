// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/verb.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <span>

namespace trixel::app {

/// What the program returns to the shell.
enum ExitStatus : int {
    kDone = 0,
    kFaultsFound = 1,  ///< by `check` and `diff`
    kUnusable = 2,     ///< contents or arguments
    kPathTrouble = 3,  ///< a path cannot be read or written
    kInterrupted = 130 ///< by Ctrl+C; nothing is left behind
};

/// Opens the window, on a file if one is given, and returns the exit status when it closes.
using OpenWindow = std::function<int(const std::optional<std::filesystem::path>& file)>;

/// Runs the verb that the arguments name, opens the window if they name none, or prints help or
/// version. Results go to standard output; an error is one line on standard error.
/// \param furtherVerbs  added to those of `verb.h`: the ones that need a display
/// \param openWindow    empty in a program without a window
/// \return              an `ExitStatus`
int runCommandLine(int argc,
                   const char* const* argv,
                   std::span<const AddVerb> furtherVerbs,
                   const OpenWindow& openWindow);

/// Prints an error as its one line and says which exit status it means.
int reportError(const Error& error);

} // namespace trixel::app
