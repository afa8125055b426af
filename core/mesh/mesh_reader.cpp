// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_reader.h"

#include "core/base/read_file.h"
#include "core/mesh/readers.h"

#include <algorithm>
#include <new>

namespace trixel {
namespace {

// Whether the lines of a text end with CR alone, as programs of the first Macintosh wrote them.
bool endsLinesWithReturns(std::string_view bytes)
{
    constexpr auto kNone = std::string_view::npos;
    return bytes.find('\n') == kNone && bytes.find('\r') != kNone && bytes.find('\0') == kNone;
}

std::string withLineFeeds(std::string_view bytes)
{
    std::string text(bytes);
    std::replace(text.begin(), text.end(), '\r', '\n');
    return text;
}

bool startsAsUtf16(std::string_view bytes)
{
    return bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF");
}

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
    if (format != MeshFormat::Stl && startsAsUtf16(bytes)) {
        return contentsError("line 1: expected text in UTF-8 or ASCII, found UTF-16");
    }
    try {
        if (endsLinesWithReturns(bytes)) {
            return parse(format, withLineFeeds(bytes), progress);
        }
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
