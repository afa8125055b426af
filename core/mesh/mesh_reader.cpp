// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_reader.h"

#include "core/base/read_file.h"
#include "core/mesh/readers.h"

#include <algorithm>
#include <new>

namespace trixel {
namespace {

Result<TriangleMesh> parse(MeshFormat format, std::string_view bytes, Progress& progress)
{
    switch (format) {
    case MeshFormat::Obj:
        return parseObj(bytes, progress);
    case MeshFormat::Ply:
        return parsePly(bytes, progress);
    case MeshFormat::Stl:
        return parseStl(bytes, progress);
    case MeshFormat::Off:
        return parseOff(bytes, progress);
    }
    return contentsError("expected a mesh format");
}

} // namespace

std::optional<MeshFormat> meshFormatOf(const std::filesystem::path& path)
{
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    if (ending == ".obj") {
        return MeshFormat::Obj;
    }
    if (ending == ".ply") {
        return MeshFormat::Ply;
    }
    if (ending == ".stl") {
        return MeshFormat::Stl;
    }
    if (ending == ".off") {
        return MeshFormat::Off;
    }
    return std::nullopt;
}

Result<TriangleMesh> parseMesh(MeshFormat format, std::string_view bytes, Progress& progress)
{
    if (bytes.empty()) {
        return contentsError("the file is empty");
    }
    try {
        return parse(format, bytes, progress);
    } catch (const std::bad_alloc&) {
        return contentsError("the mesh does not fit into memory");
    }
}

Result<TriangleMesh> readMesh(const std::filesystem::path& path, Progress& progress)
{
    const auto format = meshFormatOf(path);
    if (!format) {
        return contentsError(path.string() + ": expected a mesh (.obj, .ply, .stl or .off)");
    }
    const auto bytes = readFile(path);
    if (!bytes) {
        return tl::unexpected(bytes.error());
    }
    auto mesh = parseMesh(*format, *bytes, progress);
    if (!mesh && mesh.error().kind != ErrorKind::Cancelled) {
        return prefixed(path.string(), mesh.error());
    }
    return mesh;
}

} // namespace trixel
