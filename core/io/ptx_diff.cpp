// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ptx_diff.h"

#include "core/io/ptx_file.h"
#include "core/io/ptx_metadata.h"
#include "core/io/ptx_reader.h"

#include <memory>
#include <unordered_map>
#include <utility>

namespace trixel {

namespace {

/// The faces of a file that outlives the comparison, at full resolution.
DiffSide sideOf(const PtxFile& file)
{
    return {file.format(),
            file.faceCount(),
            [&file](FaceId face) { return file.info(face).level(); },
            [&file] {
                auto decoder = std::make_shared<PtxDecoder>();
                return [&file, decoder](FaceId face) -> Result<FaceTexels> {
                    auto texels = file.texels(face, 0, *decoder);
                    if (!texels) {
                        return tl::unexpected(texels.error());
                    }
                    return std::move(**texels);
                };
            }};
}

std::string alphaName(const TexelFormat& format)
{
    return format.alpha ? "channel " + std::to_string(*format.alpha) : std::string("no channel");
}

void noteFormats(const PtxFile& a, const PtxFile& b, std::vector<std::string>& notes)
{
    if (a.format().type != b.format().type) {
        notes.push_back("the first stores " + std::string(nameOf(a.format().type)) +
                        ", the second " + std::string(nameOf(b.format().type)));
    }
    if (a.format().alpha != b.format().alpha) {
        notes.push_back("the first has " + alphaName(a.format()) + " as alpha, the second " +
                        alphaName(b.format()));
    }
    if (a.levelCount() != b.levelCount()) {
        notes.push_back("the first stores " + std::to_string(a.levelCount()) +
                        " levels, the second " + std::to_string(b.levelCount()));
    }
}

bool sameLinks(const PtxFaceInfo& a, const PtxFaceInfo& b)
{
    for (std::size_t edge = 0; edge < 3; ++edge) {
        if (a.adjacentFaces[edge] != b.adjacentFaces[edge] ||
            (a.adjacentFaces[edge] >= 0 && a.adjacentEdge(edge) != b.adjacentEdge(edge))) {
            return false;
        }
    }
    return true;
}

void noteLinks(const PtxFile& a, const PtxFile& b, std::vector<std::string>& notes)
{
    std::size_t count = 0;
    std::size_t first = 0;
    for (std::size_t face = a.faceCount(); face-- > 0;) {
        if (!sameLinks(a.infos()[face], b.infos()[face])) {
            ++count;
            first = face;
        }
    }
    if (count > 0) {
        notes.push_back(std::to_string(count) + " faces have other neighbours, the first is face " +
                        std::to_string(first));
    }
}

void noteMetadata(std::span<const PtxMetadata> a,
                  std::span<const PtxMetadata> b,
                  std::vector<std::string>& notes)
{
    std::unordered_map<std::string, const PtxMetadata*> rest;
    for (const PtxMetadata& item : b) {
        rest.emplace(item.key, &item);
    }
    for (const PtxMetadata& item : a) {
        const auto found = rest.find(item.key);
        if (found == rest.end()) {
            notes.push_back("only the first has the metadata \"" + item.key + "\"");
            continue;
        }
        if (item.value.index() != found->second->value.index() ||
            valueBytes(item) != valueBytes(*found->second)) {
            notes.push_back("the metadata \"" + item.key + "\" differ");
        }
        rest.erase(found);
    }
    for (const PtxMetadata& item : b) { // not from the map: its order is nobody's
        if (rest.contains(item.key)) {
            notes.push_back("only the second has the metadata \"" + item.key + "\"");
        }
    }
}

} // namespace

Result<PtxDiff>
diffPtx(const std::filesystem::path& a, const std::filesystem::path& b, Progress& progress)
{
    MemoryBudget budget;
    const auto fileA = openPtxFile(a, budget);
    if (!fileA) {
        return tl::unexpected(fileA.error());
    }
    const auto fileB = openPtxFile(b, budget);
    if (!fileB) {
        return tl::unexpected(fileB.error());
    }
    const DiffSide sideA = sideOf(*fileA);
    const DiffSide sideB = sideOf(*fileB);
    PtxDiff diff;
    diff.incomparable = incomparable(sideA, sideB);
    if (!diff.incomparable.empty()) {
        return diff;
    }
    const auto metadataA = fileA->metadata(budget);
    if (!metadataA) {
        return prefixed(a.string(), metadataA.error());
    }
    const auto metadataB = fileB->metadata(budget);
    if (!metadataB) {
        return prefixed(b.string(), metadataB.error());
    }
    noteFormats(*fileA, *fileB, diff.notes);
    noteLinks(*fileA, *fileB, diff.notes);
    noteMetadata(*metadataA, *metadataB, diff.notes);
    auto texels = diffTexels(sideA, sideB, {}, progress);
    if (!texels) {
        return texels.error().kind == ErrorKind::Cancelled
                   ? tl::unexpected(texels.error())
                   : prefixed(a.string() + " or " + b.string(), texels.error());
    }
    static_cast<TexelDiff&>(diff) = std::move(*texels);
    return diff;
}

} // namespace trixel
