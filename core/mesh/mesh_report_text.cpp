// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_report.h"

#include <algorithm>

namespace trixel {
namespace {

constexpr std::size_t kNamed = 5;

std::string counted(std::size_t count, const std::string& one, const std::string& many)
{
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

template <class Item, class NumberOf>
std::string named(const std::vector<Item>& items, NumberOf numberOf)
{
    std::string text = items.size() == 1 ? " (face " : " (faces ";
    for (std::size_t i = 0; i < std::min(items.size(), kNamed); ++i) {
        text += (i > 0 ? ", " : "") + std::to_string(numberOf(items[i]));
    }
    return text + (items.size() > kNamed ? ", …)" : ")");
}

void describeFaces(const std::vector<FaceId>& faces,
                   const std::string& adjective,
                   const std::string& cost,
                   std::vector<std::string>& lines)
{
    if (!faces.empty()) {
        lines.push_back(counted(faces.size(), adjective + " face", adjective + " faces") +
                        named(faces, [](FaceId face) { return indexOf(face); }) + ": " + cost);
    }
}

} // namespace

std::vector<std::string> MeshReport::describe() const
{
    std::vector<std::string> lines;
    if (!nonManifoldEdges.empty()) {
        lines.push_back(
            counted(nonManifoldEdges.size(), "side of a face", "sides of faces") +
            " on edges that do not join exactly two faces of opposite direction" +
            named(nonManifoldEdges, [](const Edge& side) { return indexOf(side.face); }) +
            ": treated as borders, so filtering does not cross them");
    }
    describeFaces(degenerateFaces, "degenerate", "without area, nothing to see or to hit", lines);
    describeFaces(duplicateFaces, "duplicate", "they hide each other", lines);
    describeFaces(flippedFaces,
                  "flipped",
                  "wound against their surroundings, which are borders to them",
                  lines);
    describeFaces(isolatedFaces, "isolated", "no neighbours, all three edges are borders", lines);
    describeFaces(halfEdgeRefusedFaces,
                  "refused",
                  "left out of the half-edge structure, painted like any other",
                  lines);
    if (borderEdges > 0) {
        lines.push_back(counted(borderEdges, "border edge", "border edges") + " of one face");
    }
    if (unusedVertices > 0) {
        lines.push_back(counted(unusedVertices, "vertex", "vertices") + " of no face");
    }
    if (polygonsCut > 0) {
        lines.push_back(counted(polygonsCut, "polygon", "polygons") + " cut into triangles");
    }
    return lines;
}

} // namespace trixel
