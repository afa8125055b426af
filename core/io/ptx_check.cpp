// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ptx_check.h"

#include "core/io/layers_metadata.h"
#include "core/io/project_metadata.h"
#include "core/io/ptx_face_checker.h"
#include "core/io/ptx_mesh_match.h"
#include "core/io/ptx_neighbourhood.h"
#include "core/io/ptx_reader.h"
#include "core/mesh/shared_progress.h"

#include <algorithm>
#include <atomic>
#include <optional>
#include <string>

namespace trixel {

namespace {

constexpr std::size_t kGrainFaces = 512;

void checkLinks(const PtxFile& file, PtxFaultList& faults)
{
    const auto infos = file.infos();
    for (std::size_t face = 0; face < infos.size(); ++face) {
        for (std::size_t edge = 0; edge < 3; ++edge) {
            const std::int64_t other = infos[face].adjacentFaces[edge];
            if (other < 0) {
                continue;
            }
            const auto otherEdge = static_cast<std::size_t>(infos[face].adjacentEdge(edge));
            const PtxFaceInfo& back = infos[static_cast<std::size_t>(other)];
            const std::int64_t named = back.adjacentFaces[otherEdge];
            if (named == static_cast<std::int64_t>(face) &&
                back.adjacentEdge(otherEdge) == static_cast<int>(edge)) {
                continue;
            }
            faults.add(PtxFault::Link,
                       face,
                       "face " + std::to_string(face) + " names edge " + std::to_string(otherEdge) +
                           " of face " + std::to_string(other) + " across its edge " +
                           std::to_string(edge) + ", which " +
                           (named < 0
                                ? "is a border"
                                : "leads to edge " + std::to_string(back.adjacentEdge(otherEdge)) +
                                      " of face " + std::to_string(named)));
        }
    }
}

void checkFlags(const PtxFile& file, PtxFaultList& faults)
{
    for (std::size_t face = 0; face < file.faceCount(); ++face) {
        const PtxFaceInfo& info = file.infos()[face];
        if ((info.flags & PtxFaceInfo::kConstantNeighbours) != 0 &&
            neighbourhoodOf(
                file.infos(), file.constantValues(), file.format().texelBytes(), face) ==
                PtxNeighbourhood::Different) {
            faults.add(PtxFault::Flag,
                       face,
                       "face " + std::to_string(face) +
                           " is marked as having a constant neighbourhood, but has not");
        }
        if ((info.flags & PtxFaceInfo::kSubface) != 0) {
            faults.add(PtxFault::Flag,
                       face,
                       "face " + std::to_string(face) +
                           " is marked as a subface, which only textures of quads have");
        }
    }
}

void checkMesh(const PtxFile& file, const TriangleMesh& mesh, PtxFaultList& faults)
{
    if (mesh.faceCount() != file.faceCount()) {
        faults.add(PtxFault::Mesh,
                   0,
                   "the texture has " + std::to_string(file.faceCount()) + " faces, the mesh " +
                       std::to_string(mesh.faceCount()));
        return;
    }
    const Adjacency adjacency = buildAdjacency(mesh.triangles);
    const MeshReport report = inspectMesh(mesh, adjacency);
    std::size_t count = 0;
    matchPtxWithMesh(file.infos(), adjacency, report.nonManifoldEdges, [&](std::string sentence) {
        faults.add(PtxFault::Mesh, count++, std::move(sentence));
        return true;
    });
}

// Looks at the metadata. Gives the mesh that the file carries, if it carries one that can be used.
std::optional<TriangleMesh>
checkMetadata(const PtxFile& file, MemoryBudget& budget, PtxFaultList& faults)
{
    const auto items = file.metadata(budget);
    if (!items) {
        faults.add(PtxFault::Metadata, 0, items.error().message);
        return std::nullopt;
    }
    if (const auto shown = shownFormat(file.format(), *items); !shown) {
        faults.add(PtxFault::Metadata, 0, shown.error().message);
    }
    if (!carriesMesh(*items)) {
        return std::nullopt;
    }
    auto mesh = meshOf(*items, file.faceCount());
    if (!mesh) {
        faults.add(PtxFault::Metadata, 0, mesh.error().message);
        return std::nullopt;
    }
    return std::move(*mesh);
}

Status checkFaces(const PtxFile& file, PtxFaultList& faults, Progress& progress)
{
    const std::size_t count = file.faceCount();
    const Threads threads = Threads::all();
    const std::size_t grain =
        std::clamp<std::size_t>(count / (std::size_t{16} * threads.count), 1, kGrainFaces);
    SharedProgress shared(progress, (count + grain - 1) / grain);
    std::atomic<std::size_t> next{0};
    parallelFor(threads.count, 1, threads, [&](std::size_t, std::size_t) {
        PtxFaceChecker checker(file, faults);
        for (std::size_t begin = next.fetch_add(grain); begin < count && shared.goesOn();
             begin = next.fetch_add(grain)) {
            for (std::size_t face = begin; face < std::min(begin + grain, count); ++face) {
                checker.check(faceId(face));
            }
            shared.step();
        }
    });
    return shared.goesOn() ? Status() : Status(cancelled());
}

} // namespace

Result<std::vector<std::string>>
checkPtx(const std::filesystem::path& path, const PtxCheckOptions& options, Progress& progress)
{
    MemoryBudget budget;
    const auto file = openPtxFile(path, budget);
    if (!file) {
        return tl::unexpected(file.error());
    }
    PtxFaultList faults(options.maxFaultsOfAKind);
    const std::optional<TriangleMesh> own = checkMetadata(*file, budget, faults);
    checkLinks(*file, faults);
    checkFlags(*file, faults);
    if (options.mesh != nullptr || own) {
        checkMesh(*file, options.mesh != nullptr ? *options.mesh : *own, faults);
    }
    return checkFaces(*file, faults, progress).map([&] { return faults.sentences(); });
}

} // namespace trixel
