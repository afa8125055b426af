// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/io/project.h"

#include <filesystem>
#include <optional>

namespace trixel::app {

enum class FileKind { Mesh, Ptx, Project };

/// What a file's name says it is, whatever its case; nothing for endings that are not known.
std::optional<FileKind> fileKindOf(const std::filesystem::path& path);

/// The same, with the sentence that says which endings are known.
Result<FileKind> expectFileKind(const std::filesystem::path& path);

/// Fails unless the file's name ends as wanted; `expectEnding("a.png", FileKind::Ptx)` says so.
Status expectEnding(const std::filesystem::path& path, FileKind wanted);

/// Opens a project, or a `.ptx` that carries its mesh as if it were one.
Result<Project> openPainted(const std::filesystem::path& path, Progress& progress);

} // namespace trixel::app
