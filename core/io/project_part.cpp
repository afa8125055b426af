// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/project_part.h"

#include "core/io/channel_colors.h"
#include "core/io/project_metadata.h"
#include "core/layers/layer_edits.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <set>
#include <string>
#include <utility>

namespace trixel {

namespace {

/// Stands for a vertex that no face of the part has.
constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();

Status checkPart(const Project& project, const ProjectPart& part)
{
    for (const FaceId face : part.faces) {
        if (indexOf(face) >= project.texels.faceCount()) {
            return contentsError("there is no face " + std::to_string(indexOf(face)) + ": " +
                                 std::to_string(project.texels.faceCount()) + " faces");
        }
    }
    for (const std::uint16_t channel : part.channels) {
        if (channel >= project.texels.format().channels) {
            return contentsError("there is no channel " + std::to_string(channel) + ": " +
                                 std::to_string(project.texels.format().channels) + " channels");
        }
    }
    return {};
}

/// Creases along edges of the faces, and sharp vertices of theirs, by their new numbers.
Sharpness sharpnessOf(const Sharpness& whole,
                      std::span<const std::uint32_t> numbers,
                      const TriangleMesh& part)
{
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const Triangle& t : part.triangles) {
        for (std::size_t k = 0; k < 3 && !whole.creases.empty(); ++k) {
            edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
        }
    }
    Sharpness sharpness;
    for (Crease crease : whole.creases) {
        crease.from = numbers[crease.from];
        crease.to = numbers[crease.to];
        if (edges.contains(std::minmax(crease.from, crease.to))) {
            sharpness.creases.push_back(crease);
        }
    }
    for (SharpVertex vertex : whole.vertices) {
        vertex.vertex = numbers[vertex.vertex];
        if (vertex.vertex != kUnused) {
            sharpness.vertices.push_back(vertex);
        }
    }
    return sharpness;
}

TriangleMesh meshOfFaces(const TriangleMesh& whole, std::span<const FaceId> faces)
{
    std::vector<std::uint32_t> numbers(whole.positions.size(), kUnused);
    for (const FaceId face : faces) {
        for (const std::uint32_t vertex : whole.triangles[indexOf(face)]) {
            numbers[vertex] = 0;
        }
    }
    TriangleMesh mesh;
    for (std::size_t v = 0; v < numbers.size(); ++v) {
        if (numbers[v] != kUnused) {
            numbers[v] = static_cast<std::uint32_t>(mesh.positions.size());
            mesh.positions.push_back(whole.positions[v]);
        }
    }
    for (const FaceId face : faces) {
        const Triangle& t = whole.triangles[indexOf(face)];
        mesh.triangles.push_back({numbers[t[0]], numbers[t[1]], numbers[t[2]]});
        if (!whole.sourceFaces.empty()) {
            mesh.sourceFaces.push_back(whole.sourceFace(face));
        }
        if (whole.hasUvs()) {
            const auto uvs = whole.uvs(face);
            mesh.cornerUvs.insert(mesh.cornerUvs.end(), uvs.begin(), uvs.end());
        }
    }
    mesh.sharpness = sharpnessOf(whole.sharpness, numbers, mesh);
    return mesh;
}

TexelStore texelsOf(const TexelStore& whole, std::span<const FaceId> faces)
{
    const std::vector<std::byte> none(whole.format().texelBytes());
    TexelStore texels(static_cast<std::uint32_t>(faces.size()), whole.format(), Level(), none);
    for (std::size_t k = 0; k < faces.size(); ++k) {
        texels.exchange(faceId(k), whole.face(faces[k]));
    }
    return texels;
}

FaceTexels channelsOf(const FaceTexels& face,
                      const TexelFormat& format,
                      std::span<const std::uint16_t> channels)
{
    const std::size_t value = byteSize(format.type);
    const std::size_t count = face.byteCount() / format.texelBytes();
    std::vector<std::byte> picked(count * channels.size() * value);
    std::byte* to = picked.data();
    for (std::size_t k = 0; k < count; ++k) {
        const std::byte* texel = face.bytes().data() + k * format.texelBytes();
        for (const std::uint16_t channel : channels) {
            std::memcpy(to, texel + channel * value, value);
            to += value;
        }
    }
    return face.isConstant() ? FaceTexels::constant(face.level(), picked)
                             : FaceTexels::full(face.level(), channels.size() * value, picked);
}

Result<TexelStore> withChannels(const TexelStore& texels,
                                const std::vector<std::uint16_t>& channels,
                                Threads threads,
                                Progress& progress)
{
    const TexelFormat& format = texels.format();
    TexelFormat picked{format.type, static_cast<std::uint16_t>(channels.size()), std::nullopt};
    if (format.alpha) {
        const auto alpha = std::ranges::find(channels, *format.alpha);
        if (alpha != channels.end()) {
            picked.alpha = static_cast<std::uint16_t>(alpha - channels.begin());
        }
    }
    return texels.transformed(
        picked,
        [&](const FaceTexels& face) { return channelsOf(face, format, channels); },
        threads,
        progress);
}

void forgetFill(Project& project)
{
    std::erase_if(project.metadata, [](const PtxMetadata& item) { return item.key == kFillKey; });
}

/// The project as if the layer was all of it.
Result<Project> ofLayer(const Project& project, LayerId layer, Threads threads, Progress& progress)
{
    auto texels = layerAlone(project.layers, layer, threads, progress);
    if (!texels) {
        return tl::unexpected(texels.error());
    }
    Project result = project;
    result.layers = {};
    result.texels = std::move(*texels);
    if (layer == kBaseLayer) {
        return result;
    }
    forgetFill(result);
    forgetChannelColors(result);
    if (auto declared = channelColors(project)) {
        declared->push_back(ColorSpace::Raw); // of the coverage
        declareChannelColors(result, *declared);
    }
    return result;
}

Status pickFaces(Project& project, std::span<const FaceId> faces, Progress& progress)
{
    auto surface = Surface::build(meshOfFaces(project.surface->mesh(), faces), progress);
    if (!surface) {
        return tl::unexpected(surface.error());
    }
    project.surface = std::move(*surface);
    project.texels = texelsOf(project.texels, faces);
    return {};
}

Status pickChannels(Project& project,
                    const std::vector<std::uint16_t>& channels,
                    Threads threads,
                    Progress& progress)
{
    const auto declared = channelColors(project);
    auto texels = withChannels(project.texels, channels, threads, progress);
    if (!texels) {
        return tl::unexpected(texels.error());
    }
    project.texels = std::move(*texels);
    forgetFill(project);
    forgetChannelColors(project);
    if (declared) {
        std::vector<ColorSpace> picked;
        for (const std::uint16_t channel : channels) {
            picked.push_back((*declared)[channel]);
        }
        declareChannelColors(project, picked);
    }
    return {};
}

/// What faces and channels are picked from: what is shown, or one layer.
Result<Project>
wholeOf(const Project& project, const ProjectPart& part, Threads threads, Progress& progress)
{
    if (part.layer && !project.layers.has(*part.layer)) {
        return contentsError("the layer is not one of the project's");
    }
    if (part.layer && !project.layers.isPlain()) {
        return ofLayer(project, *part.layer, threads, progress);
    }
    Project shown = project;
    shown.layers = {};
    return shown;
}

} // namespace

Result<Project>
partOf(const Project& project, const ProjectPart& part, Threads threads, Progress& progress)
{
    StageProgress choosing(progress, 0, 0.3);
    auto result = wholeOf(project, part, threads, choosing);
    if (!result) {
        return result;
    }
    if (const Status usable = checkPart(*result, part); !usable) {
        return tl::unexpected(usable.error());
    }
    StageProgress building(progress, 0.3, 0.6);
    StageProgress picking(progress, 0.6, 1);
    Status picked;
    if (!part.faces.empty()) {
        picked = pickFaces(*result, part.faces, building);
    }
    if (picked && !part.channels.empty()) {
        picked = pickChannels(*result, part.channels, threads, picking);
    }
    return picked ? std::move(result) : tl::unexpected(picked.error());
}

} // namespace trixel
