// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_winding.h"

#include <cstdint>
#include <utility>

namespace trixel {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFU;

// Faces joined by the adjacency are wound alike: a patch. Patches numbered by their lowest face.
struct Patches
{
    std::vector<std::uint32_t> ofFace;
    std::vector<std::size_t> sizes;
};

Patches findPatches(const Adjacency& adjacency)
{
    Patches patches;
    patches.ofFace.assign(adjacency.faceCount(), kNone);
    std::vector<FaceId> pending;
    for (std::size_t f = 0; f < adjacency.faceCount(); ++f) {
        if (patches.ofFace[f] != kNone) {
            continue;
        }
        const auto patch = static_cast<std::uint32_t>(patches.sizes.size());
        patches.sizes.push_back(0);
        patches.ofFace[f] = patch;
        pending.push_back(faceId(f));
        while (!pending.empty()) {
            const FaceId face = pending.back();
            pending.pop_back();
            ++patches.sizes[patch];
            for (const LocalEdge edge : kLocalEdges) {
                const auto other = adjacency.neighbour(face, edge);
                if (other && patches.ofFace[indexOf(other->face)] == kNone) {
                    patches.ofFace[indexOf(other->face)] = patch;
                    pending.push_back(other->face);
                }
            }
        }
    }
    return patches;
}

using Neighbours = std::vector<std::vector<std::uint32_t>>;

Neighbours opposedPatches(const Patches& patches, std::span<const FacePair> opposed)
{
    Neighbours neighbours(patches.sizes.size());
    for (const FacePair& pair : opposed) {
        const std::uint32_t a = patches.ofFace[indexOf(pair.a)];
        const std::uint32_t b = patches.ofFace[indexOf(pair.b)];
        if (a != b) {
            neighbours[a].push_back(b);
            neighbours[b].push_back(a);
        }
    }
    return neighbours;
}

// Two-colours the patches of the component of `start`; returns those of the smaller colour.
std::vector<std::uint32_t> minority(std::uint32_t start,
                                    const Patches& patches,
                                    const Neighbours& neighbours,
                                    std::vector<bool>& seen)
{
    std::vector<std::uint32_t> members[2];
    std::size_t faces[2] = {0, 0};
    std::vector<std::pair<std::uint32_t, unsigned>> pending{{start, 0U}};
    seen[start] = true;
    while (!pending.empty()) {
        const auto [patch, colour] = pending.back();
        pending.pop_back();
        members[colour].push_back(patch);
        faces[colour] += patches.sizes[patch];
        for (const std::uint32_t other : neighbours[patch]) {
            if (!seen[other]) {
                seen[other] = true;
                pending.emplace_back(other, 1U - colour);
            }
        }
    }
    return faces[0] < faces[1] ? members[0] : members[1];
}

} // namespace

std::vector<FaceId> findFlippedFaces(const Adjacency& adjacency, std::span<const FacePair> opposed)
{
    if (opposed.empty()) {
        return {};
    }
    const Patches patches = findPatches(adjacency);
    const Neighbours neighbours = opposedPatches(patches, opposed);
    std::vector<bool> seen(patches.sizes.size(), false);
    std::vector<bool> flipped(patches.sizes.size(), false);
    for (std::uint32_t patch = 0; patch < seen.size(); ++patch) {
        if (!seen[patch]) {
            for (const std::uint32_t member : minority(patch, patches, neighbours, seen)) {
                flipped[member] = true;
            }
        }
    }
    std::vector<FaceId> faces;
    for (std::size_t f = 0; f < patches.ofFace.size(); ++f) {
        if (flipped[patches.ofFace[f]]) {
            faces.push_back(faceId(f));
        }
    }
    return faces;
}

} // namespace trixel
