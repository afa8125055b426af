// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/selection_lines.h"

#include "core/lattice/edge_transfer.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace trixel::ui {

namespace {

constexpr glm::vec4 kSelectionColor{1.0F, 0.62F, 0.1F, 1.0F};
constexpr float kSelectionWidth = 2.2F;

/// That an edge is drawn in on a limit surface.
constexpr int kCurvePieces = 8;

/// A border edge, from vertex to vertex with the chosen face to its left.
struct BorderEdge
{
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    FaceId face{};
    LocalEdge edge{};
};

std::vector<BorderEdge> borderOf(const Surface& surface, std::span<const FaceId> faces)
{
    std::vector<BorderEdge> border;
    for (const FaceId face : faces) {
        const Triangle& triangle = surface.mesh().triangles[indexOf(face)];
        for (const LocalEdge edge : kLocalEdges) {
            const auto across = surface.adjacency().neighbour(face, edge);
            if (!across || !std::ranges::binary_search(faces, across->face)) {
                border.push_back(
                    {triangle[indexOf(edge)], triangle[indexOf(nextEdge(edge))], face, edge});
            }
        }
    }
    std::ranges::sort(border, {}, &BorderEdge::from);
    return border;
}

/// Each edge in one line: from its end goes on whichever edge starts there and is not used yet.
std::vector<std::vector<BorderEdge>> joined(const std::vector<BorderEdge>& border)
{
    std::vector<bool> used(border.size());
    std::vector<std::vector<BorderEdge>> lines;
    for (std::size_t start = 0; start < border.size(); ++start) {
        if (used[start]) {
            continue;
        }
        std::vector<BorderEdge> line;
        for (std::size_t at = start; at < border.size();) {
            used[at] = true;
            line.push_back(border[at]);
            const std::uint32_t end = border[at].to;
            auto next = std::ranges::lower_bound(border, end, {}, &BorderEdge::from);
            while (next != border.end() && next->from == end &&
                   used[static_cast<std::size_t>(next - border.begin())]) {
                ++next;
            }
            at = next != border.end() && next->from == end
                     ? static_cast<std::size_t>(next - border.begin())
                     : border.size();
        }
        lines.push_back(std::move(line));
    }
    return lines;
}

/// Points from the start of each edge to before its end.
std::vector<glm::vec3>
pointsAlong(std::span<const BorderEdge> edges, const Surface& surface, const LimitMesh* limit)
{
    std::vector<glm::vec3> points;
    if (limit == nullptr) {
        for (const BorderEdge& edge : edges) {
            points.push_back(surface.mesh().positions[edge.from]);
        }
        points.push_back(surface.mesh().positions[edges.back().to]);
        return points;
    }
    LimitSurface::Evaluator evaluator(limit->surface());
    const auto add = [&](const BorderEdge& edge, double t) {
        evaluator.moveTo(edge.face);
        points.emplace_back(evaluator.position(fromEdge(edge.edge, {t, 0})));
    };
    for (const BorderEdge& edge : edges) {
        for (int p = 0; p < kCurvePieces; ++p) {
            add(edge, static_cast<double>(p) / kCurvePieces);
        }
    }
    add(edges.back(), 1);
    return points;
}

} // namespace

std::vector<render::Polyline>
selectionOutline(const Surface& surface, std::span<const FaceId> faces, const LimitMesh* limit)
{
    auto lines = joined(borderOf(surface, faces));
    std::ranges::stable_sort(lines, std::ranges::greater{}, &std::vector<BorderEdge>::size);
    lines.resize(std::min(lines.size(), kMostOutlineLines));
    std::vector<render::Polyline> outline;
    std::size_t left = kMostOutlineEdges;
    for (const std::vector<BorderEdge>& line : lines) {
        const std::size_t edges = std::min(line.size(), left);
        if (edges == 0) {
            break;
        }
        left -= edges;
        render::Polyline drawn;
        drawn.points = pointsAlong(std::span(line).first(edges), surface, limit);
        drawn.color = kSelectionColor;
        drawn.width = kSelectionWidth;
        drawn.hiddenOpacity = 0.2F;
        outline.push_back(std::move(drawn));
    }
    return outline;
}

} // namespace trixel::ui
