// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/file_kind.h"

#include "core/mesh/mesh_reader.h"

#include <algorithm>
#include <string>

namespace trixel::app {
namespace {

constexpr const char* kPtxEnding = ".ptx";
constexpr const char* kProjectEnding = ".trixel";

std::string endingOf(const std::filesystem::path& path)
{
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return ending;
}

} // namespace

std::optional<FileKind> fileKindOf(const std::filesystem::path& path)
{
    const std::string ending = endingOf(path);
    if (ending == kPtxEnding) {
        return FileKind::Ptx;
    }
    if (ending == kProjectEnding) {
        return FileKind::Project;
    }
    if (meshFormatOf(path)) {
        return FileKind::Mesh;
    }
    return std::nullopt;
}

Result<FileKind> expectFileKind(const std::filesystem::path& path)
{
    if (const auto kind = fileKindOf(path)) {
        return *kind;
    }
    return contentsError(path.string() +
                         ": expected a name that ends in .obj, .ply, .stl, .off, "
                         ".ptx or .trixel, found '" +
                         path.extension().string() + "'.");
}

Status expectEnding(const std::filesystem::path& path, FileKind wanted)
{
    if (fileKindOf(path) == wanted) {
        return {};
    }
    const char* ending = wanted == FileKind::Ptx       ? kPtxEnding
                         : wanted == FileKind::Project ? kProjectEnding
                                                       : ".obj, .ply, .stl or .off";
    return contentsError(path.string() + ": expected a name that ends in " + ending + ", found '" +
                         path.extension().string() + "'.");
}

Result<Project> openPainted(const std::filesystem::path& path, Progress& progress)
{
    if (fileKindOf(path) == FileKind::Ptx) {
        return openPtx(path, progress);
    }
    if (const Status project = expectEnding(path, FileKind::Project); !project) {
        return contentsError(path.string() + ": expected a project (.trixel) or a .ptx, found '" +
                             path.extension().string() + "'.");
    }
    return openProject(path, progress);
}

} // namespace trixel::app
