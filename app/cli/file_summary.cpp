// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/file_summary.h"

#include "app/cli/file_kind.h"
#include "app/cli/output.h"
#include "core/io/layers_metadata.h"
#include "core/io/project_metadata.h"
#include "core/mesh/mesh_reader.h"
#include "core/mesh/surface.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>

namespace trixel::app {
namespace {

MeshSummary summaryOf(const Surface& surface)
{
    MeshSummary summary;
    summary.vertices = surface.mesh().positions.size();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto component = static_cast<glm::length_t>(axis);
        summary.low[axis] = surface.low()[component];
        summary.high[axis] = surface.high()[component];
    }
    summary.borderEdges = surface.report().borderEdges;
    summary.report = surface.report().describe();
    return summary;
}

Status describeMesh(FileSummary& summary, Progress& progress)
{
    StageProgress reading(progress, 0, 0.5);
    auto mesh = readMesh(summary.path, reading);
    if (!mesh) {
        return tl::unexpected(mesh.error());
    }
    StageProgress building(progress, 0.5, 1);
    const auto surface = Surface::build(std::move(*mesh), building);
    if (!surface) {
        return tl::unexpected(surface.error());
    }
    summary.faces = (*surface)->mesh().faceCount();
    summary.mesh = summaryOf(**surface);
    return {};
}

Status describePtx(FileSummary& summary)
{
    auto ptx = summarisePtx(summary.path);
    if (!ptx) {
        return tl::unexpected(ptx.error());
    }
    summary.faces = ptx->faceCount;
    summary.ptx = std::move(*ptx);
    return {};
}

std::string_view nameOf(FileKind kind)
{
    switch (kind) {
    case FileKind::Mesh:
        return "mesh";
    case FileKind::Ptx:
        return "ptx";
    case FileKind::Project:
        break;
    }
    return "project";
}

std::string typeOf(const PtxSummary::Item& item)
{
    constexpr std::array<const char*, 6> kNames = {
        "string", "int8", "int16", "int32", "float", "double"};
    return kNames.at(item.type);
}

/// Vertices of the mesh that the file carries; nothing without one.
std::optional<std::uint64_t> vertexCount(const PtxSummary& ptx)
{
    for (const PtxSummary::Item& item : ptx.metadata) {
        if (item.key == kVertexPositionsKey) {
            return item.count / 3;
        }
    }
    return std::nullopt;
}

/// Bytes of all texels at full resolution, constant faces spread out.
std::uint64_t fullBytes(const PtxSummary& ptx)
{
    return ptx.texelCount * ptx.format.texelBytes();
}

nlohmann::json jsonOf(const PtxSummary& ptx)
{
    nlohmann::json levels = nlohmann::json::object();
    for (std::size_t level = 0; level < ptx.facesOfLevel.size(); ++level) {
        if (ptx.facesOfLevel[level] > 0) {
            levels[std::to_string(level)] = ptx.facesOfLevel[level];
        }
    }
    nlohmann::json metadata = nlohmann::json::array();
    for (const PtxSummary::Item& item : ptx.metadata) {
        metadata.push_back({{"key", item.key}, {"type", typeOf(item)}, {"count", item.count}});
        if (item.type == 0) {
            metadata.back()["text"] = item.text;
        }
    }
    const auto vertices = vertexCount(ptx);
    nlohmann::json layers = nlohmann::json::array();
    for (const LayerSettings& layer : ptx.layers) {
        layers.push_back({{"name", layer.name},
                          {"opacity", layer.opacity},
                          {"blend", trixel::nameOf(layer.blend)},
                          {"visible", layer.isVisible}});
    }
    return {{"vertices", vertices ? nlohmann::json(*vertices) : nlohmann::json()},
            {"type", trixel::nameOf(ptx.format.type)},
            {"channels", ptx.format.channels},
            {"alpha", ptx.format.alpha ? nlohmann::json(*ptx.format.alpha) : nlohmann::json()},
            {"layers", layers},
            {"levels", levels},
            {"constantFaces", ptx.constantFaces},
            {"editedFaces", ptx.editedFaces},
            {"texels", ptx.texelCount},
            {"texelBytes", fullBytes(ptx)},
            {"storedBytes", ptx.texelBytes},
            {"mips", ptx.levelCount > 1},
            {"carriesMesh", ptx.carriesMesh},
            {"metadata", metadata}};
}

/// Lines of "name   value", the values below each other.
class Table
{
public:
    void row(const std::string& name, const std::string& value)
    {
        constexpr std::size_t kColumn = 16;
        m_text << name << std::string(kColumn - std::min(kColumn - 1, name.size()), ' ') << value
               << '\n';
    }
    std::string text() const { return m_text.str(); }

private:
    std::ostringstream m_text;
};

void addRows(Table& table, const MeshSummary& mesh)
{
    std::ostringstream size;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        size << (axis == 0 ? "" : " x ") << mesh.high[axis] - mesh.low[axis];
    }
    table.row("vertices", grouped(mesh.vertices));
    table.row("size", size.str());
    for (const std::string& line : mesh.report) {
        table.row("report", line);
    }
}

/// ""Lines", multiply, opacity 0.3, hidden"
std::string settingsText(const LayerSettings& layer)
{
    std::ostringstream text;
    text << '"' << layer.name << "\", " << trixel::nameOf(layer.blend) << ", opacity "
         << layer.opacity << (layer.isVisible ? "" : ", hidden");
    return text.str();
}

void addRows(Table& table, const PtxSummary& ptx)
{
    const TexelFormat& format = ptx.format;
    if (const auto vertices = vertexCount(ptx)) {
        table.row("vertices", grouped(*vertices));
    }
    table.row("type",
              std::string(trixel::nameOf(format.type)) + ", " +
                  counted(format.channels, "channel") +
                  (format.alpha ? ", alpha in channel " + std::to_string(*format.alpha) : ""));
    for (std::size_t k = ptx.layers.size(); k-- > 0;) { // as they lie on each other
        table.row("layer " + std::to_string(k + 1), settingsText(ptx.layers[k]));
    }
    table.row("texels", grouped(ptx.texelCount) + " (" + byteSizeText(fullBytes(ptx)) + ")");
    for (std::size_t level = 0; level < ptx.facesOfLevel.size(); ++level) {
        if (ptx.facesOfLevel[level] > 0) {
            table.row("level " + std::to_string(level), counted(ptx.facesOfLevel[level], "face"));
        }
    }
    table.row("constant", counted(ptx.constantFaces, "face"));
    if (ptx.editedFaces > 0) {
        table.row("edited", counted(ptx.editedFaces, "face"));
    }
    table.row("mips", ptx.levelCount > 1 ? "stored" : "not stored");
    table.row("mesh", ptx.carriesMesh ? "in the metadata" : "not in the file");
    for (const PtxSummary::Item& item : ptx.metadata) {
        if (item.key == kLayersKey) {
            continue; // told above
        }
        table.row("metadata",
                  item.key + (item.type == 0 ? ": " + item.text
                                             : ", " + counted(item.count, typeOf(item))));
    }
}

} // namespace

Result<FileSummary> summarise(const std::filesystem::path& path, Progress& progress)
{
    const auto kind = expectFileKind(path);
    if (!kind) {
        return tl::unexpected(kind.error());
    }
    FileSummary summary;
    summary.path = path;
    summary.kind = nameOf(*kind);
    const Status described =
        *kind == FileKind::Mesh ? describeMesh(summary, progress) : describePtx(summary);
    if (!described) {
        return tl::unexpected(described.error());
    }
    std::error_code unknown;
    const std::uintmax_t size = std::filesystem::file_size(path, unknown);
    summary.fileBytes = unknown ? 0 : size;
    return summary;
}

nlohmann::json toJson(const FileSummary& summary)
{
    nlohmann::json json = {{"file", summary.path.string()},
                           {"kind", summary.kind},
                           {"fileBytes", summary.fileBytes},
                           {"faces", summary.faces}};
    if (summary.mesh) {
        json["vertices"] = summary.mesh->vertices;
        json["low"] = summary.mesh->low;
        json["high"] = summary.mesh->high;
        json["borderEdges"] = summary.mesh->borderEdges;
        json["report"] = summary.mesh->report;
    }
    if (summary.ptx) {
        json.update(jsonOf(*summary.ptx));
    }
    return json;
}

std::string toText(const FileSummary& summary)
{
    Table table;
    table.row(summary.kind, summary.path.string());
    table.row("file size", byteSizeText(summary.fileBytes));
    table.row("faces", grouped(summary.faces));
    if (summary.mesh) {
        addRows(table, *summary.mesh);
    }
    if (summary.ptx) {
        addRows(table, *summary.ptx);
    }
    return table.text();
}

} // namespace trixel::app
