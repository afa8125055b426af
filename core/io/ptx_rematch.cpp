// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ptx_rematch.h"

#include "core/io/open_paint.h"
#include "core/io/project_metadata.h"
#include "core/io/ptx_mesh_match.h"
#include "core/io/ptx_reader.h"
#include "core/io/sharpness_metadata.h"
#include "core/layers/compose.h"
#include "core/texture/rearranged_faces.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace trixel {

namespace {

bool fitsAsItStands(const PtxFile& file, const Surface& surface)
{
    bool fits = true;
    matchPtxWithMesh(file.infos(),
                     surface.adjacency(),
                     surface.report().nonManifoldEdges,
                     [&](const std::string& /*sentence*/) { return fits = false; });
    return fits;
}

FaceMatch asTheyStand(std::size_t faceCount)
{
    FaceMatch match(faceCount);
    for (std::size_t k = 0; k < faceCount; ++k) {
        match[k].face = faceId(k);
    }
    return match;
}

std::optional<TriangleMesh> ownMesh(std::span<const PtxMetadata> metadata, std::uint32_t faceCount)
{
    if (!carriesMesh(metadata)) {
        return std::nullopt;
    }
    auto mesh = meshOf(metadata, faceCount);
    return mesh ? std::optional(std::move(*mesh)) : std::nullopt; // damaged: as if there was none
}

tl::unexpected<Error> inFile(const std::filesystem::path& path, const Error& error)
{
    return error.kind == ErrorKind::Contents ? prefixed(path.string(), error)
                                             : tl::unexpected(error);
}

/// Every layer's faces, and what they look like together.
Result<Layered> rearranged(LayerStack layers, const FaceMatch& match, Progress& progress)
{
    std::vector<LayerId> all{kBaseLayer};
    for (const Layer& layer : layers.layers()) {
        all.push_back(layer.id);
    }
    const auto share = 1.0 / static_cast<double>(all.size() + 1);
    double begin = 0;
    for (const LayerId layer : all) {
        StageProgress moving(progress, begin, begin + share);
        auto texels = rearranged(layers.texels(layer), match, Threads::all(), moving);
        if (!texels) {
            return tl::unexpected(texels.error());
        }
        layers.texels(layer) = std::move(*texels);
        begin += share;
    }
    StageProgress composing(progress, begin, 1);
    return composed(std::move(layers), Threads::all(), composing);
}

Status rearrange(OpenedPaint& paint, const FaceMatch& match, Progress& progress)
{
    if (paint.layers.isPlain()) {
        return rearranged(paint.texels, match, Threads::all(), progress)
            .map([&](TexelStore&& texels) { paint.texels = std::move(texels); });
    }
    return rearranged(std::move(paint.layers), match, progress).map([&](Layered&& layered) {
        paint.texels = std::move(layered.shown);
        paint.layers = std::move(layered.layers);
    });
}

} // namespace

std::size_t PtxMatch::moved() const
{
    std::size_t count = 0;
    for (std::size_t k = 0; k < faces.size(); ++k) {
        count += faces[k].face == faceId(k) ? 0 : 1;
    }
    return count;
}

std::size_t PtxMatch::turned() const
{
    return static_cast<std::size_t>(std::ranges::count_if(faces, [](const MatchedFace& face) {
        return face.corners != kSameCorners && !turnsOver(face.corners);
    }));
}

std::size_t PtxMatch::turnedOver() const
{
    return static_cast<std::size_t>(std::ranges::count_if(
        faces, [](const MatchedFace& face) { return turnsOver(face.corners); }));
}

std::string PtxMatch::describe() const
{
    if (isIdentity(faces)) {
        return "its faces are the mesh's as they stand";
    }
    return std::string(by == MatchedBy::Positions ? "by their positions" : "by their neighbours") +
           ": " + std::to_string(moved()) + " of " + std::to_string(faces.size()) +
           " faces have another number, " + std::to_string(turned()) +
           " begin at another corner, " + std::to_string(turnedOver()) +
           " are wound the other way round";
}

Result<PtxMatch> matchPtx(const PtxFile& file,
                          std::span<const PtxMetadata> metadata,
                          const Surface& surface,
                          Progress& progress)
{
    const TriangleMesh& mesh = surface.mesh();
    if (file.faceCount() != mesh.faceCount()) {
        return contentsError("is a texture of " + std::to_string(file.faceCount()) +
                             " faces, the mesh has " + std::to_string(mesh.faceCount()));
    }
    const std::optional<TriangleMesh> own = ownMesh(metadata, file.faceCount());
    std::optional<Error> why;
    if (own) {
        StageProgress placing(progress, 0, 0.4);
        auto match = matchByPositions(mesh, *own, placing);
        if (match) {
            const MatchedBy by = isIdentity(*match) ? MatchedBy::Order : MatchedBy::Positions;
            return PtxMatch{std::move(*match), by};
        }
        if (match.error().kind == ErrorKind::Cancelled) {
            return tl::unexpected(match.error());
        }
        why = match.error();
    }
    if (fitsAsItStands(file, surface)) {
        return PtxMatch{asTheyStand(mesh.faceCount()), MatchedBy::Order};
    }
    StageProgress linking(progress, 0.4, 1);
    auto match = matchByNeighbours(
        surface.adjacency(), own ? buildAdjacency(own->triangles) : adjacencyOf(file), linking);
    if (match) {
        return PtxMatch{std::move(*match), MatchedBy::Neighbours};
    }
    if (match.error().kind == ErrorKind::Cancelled) {
        return tl::unexpected(match.error());
    }
    // What speaks against the places is said where there are any: it is easier to look into.
    return contentsError("does not fit the mesh in any order: " +
                         (why ? *why : match.error()).message);
}

Result<MatchedPtx> openPtxMatched(const std::filesystem::path& path,
                                  std::shared_ptr<const Surface> surface,
                                  Progress& progress,
                                  const OpenOptions& options)
{
    MemoryBudget budget;
    auto file = openPtxFile(path, budget);
    if (!file) {
        return tl::unexpected(file.error());
    }
    auto metadata = file->metadata(budget);
    if (!metadata) {
        return inFile(path, metadata.error());
    }
    const Result<CreaseAngle> creases = creaseAngleOf(*metadata);
    if (!creases) {
        return inFile(path, creases.error());
    }
    const bool hasMips = file->levelCount() > 1;
    StageProgress matching(progress, 0, 0.4);
    auto match = matchPtx(*file, *metadata, *surface, matching);
    if (!match) {
        return inFile(path, match.error());
    }
    StageProgress reading(progress, 0.4, 0.8);
    auto opened = openPaint(std::move(*file), path.string(), *metadata, options, budget, reading);
    if (!opened) {
        return inFile(path, opened.error());
    }
    if (match->by != MatchedBy::Order) {
        StageProgress moving(progress, 0.8, 1);
        if (Status moved = rearrange(*opened, match->faces, moving); !moved) {
            return inFile(path, moved.error());
        }
    }
    return MatchedPtx{{std::move(surface),
                       std::move(opened->texels),
                       withoutMesh(std::move(*metadata)),
                       std::move(opened->faces),
                       *creases,
                       std::move(opened->layers)},
                      std::move(*match),
                      hasMips};
}

} // namespace trixel
