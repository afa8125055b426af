// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/footprint_lines.h"

#include "core/lattice/texel.h"
#include "core/mesh/triangle_geometry.h"
#include "ui/inspector/footprint_net_painter.h"
#include "ui/viewport/surface_lines.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <numbers>
#include <optional>

namespace trixel::ui {

namespace {

constexpr int kEllipsePoints = 96;
/// How far texels are drawn inside their edges, so that neighbours stay apart.
constexpr double kInset = 0.15;
/// Of the largest weight: texels that count less stay as they are.
constexpr double kLeastShare = 0.02;
/// Lines that are drawn larger reach further than filters do: the parallelogram's corners are √2
/// from the centre.
constexpr double kLinesCut = 1.8;
/// Pieces of a straight line on a curved face.
constexpr int kCurveCuts = 8;

struct Part
{
    double from = 0;
    double to = 1;
};

/// The part of a segment inside a triangle that turns left; nothing where they do not meet.
std::optional<Part>
inside(const std::array<glm::dvec2, 3>& triangle, glm::dvec2 from, glm::dvec2 to)
{
    Part part;
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec2 edge = triangle[(k + 1) % 3] - triangle[k];
        const auto height = [&](glm::dvec2 p) {
            return edge.x * (p.y - triangle[k].y) - edge.y * (p.x - triangle[k].x);
        };
        const double a = height(from);
        const double b = height(to);
        if (a < 0 && b < 0) {
            return std::nullopt;
        }
        if (a < 0) {
            part.from = std::max(part.from, a / (a - b));
        } else if (b < 0) {
            part.to = std::min(part.to, a / (a - b));
        }
    }
    return part.from < part.to ? std::optional(part) : std::nullopt;
}

std::vector<glm::dvec2> ellipseOf(glm::dvec2 major, glm::dvec2 minor)
{
    std::vector<glm::dvec2> line;
    for (int k = 0; k <= kEllipsePoints; ++k) {
        const double angle = 2 * std::numbers::pi * k / kEllipsePoints;
        line.push_back(std::cos(angle) * major + std::sin(angle) * minor);
    }
    return line;
}

} // namespace

std::vector<render::Polyline> onSurface(const FootprintNet& net,
                                        const SeenSurface& surface,
                                        std::span<const glm::dvec2> line,
                                        glm::vec4 color,
                                        float width)
{
    std::vector<render::Polyline> pieces;
    for (const FootprintNet::Face& face : net.faces) {
        const auto toWorld = [&](glm::dvec2 point) {
            return surface.position(face.face, insideTriangle(face.uvOf(point)));
        };
        bool joins = false; // the segment before ended where this one begins
        for (std::size_t k = 0; k + 1 < line.size(); ++k) {
            const auto part = inside(face.corners, line[k], line[k + 1]);
            if (!part) {
                joins = false;
                continue;
            }
            const glm::dvec2 along = line[k + 1] - line[k];
            if (!joins || part->from > 0) {
                render::Polyline piece;
                piece.color = color;
                piece.width = width;
                piece.hiddenOpacity = 0.3F;
                piece.points.push_back(toWorld(line[k] + part->from * along));
                pieces.push_back(std::move(piece));
            }
            const int cuts = surface.isLimit() ? kCurveCuts : 1;
            for (int c = 1; c <= cuts; ++c) {
                const double t = part->from + (part->to - part->from) * c / cuts;
                pieces.back().points.push_back(toWorld(line[k] + t * along));
            }
            joins = part->to >= 1;
        }
    }
    return pieces;
}

std::vector<render::Polyline> footprintOnSurface(const FootprintNet& net,
                                                 const SeenSurface& surface,
                                                 FootprintRole role,
                                                 bool widened)
{
    const bool live = role == FootprintRole::Live;
    std::vector<render::Polyline> lines;
    const auto add = [&](std::span<const glm::dvec2> line, glm::vec4 color, float width) {
        for (render::Polyline& piece :
             onSurface(net, surface, line, live ? color : kFrozenColor, width)) {
            lines.push_back(std::move(piece));
        }
    };
    const glm::dvec2 h1 = net.w1 / 2.0;
    const glm::dvec2 h2 = net.w2 / 2.0;
    const std::array<glm::dvec2, 5> sides = {-h1 - h2, h1 - h2, h1 + h2, h2 - h1, -h1 - h2};
    add(sides, kParallelogramColor, 1.2F);
    add(ellipseOf(widened ? net.widenedMajor : net.major, widened ? net.widenedMinor : net.minor),
        kEllipseColor,
        1.6F);
    if (live) {
        for (const glm::dvec2 half : {h1, h2}) {
            add(std::array<glm::dvec2, 2>{glm::dvec2(0), half}, kParallelogramColor, 2.0F);
        }
    }
    return lines;
}

std::vector<render::Polyline>
weightsOnSurface(const SeenSurface& surface, const Contributions& weights, std::size_t most)
{
    std::vector<render::Polyline> lines;
    if (weights.texels.empty()) {
        return lines;
    }
    const double heaviest = weights.texels.front().weight;
    const std::size_t count = std::min(most, weights.texels.size());
    for (std::size_t k = count; k-- > 0;) { // the heaviest last, above the others
        const Contribution& one = weights.texels[k];
        const double share = heaviest > 0 ? one.weight / heaviest : 0;
        if (share < kLeastShare) {
            continue;
        }
        const QColor color = weightColor(share);
        const glm::dvec2 middle = centroid(one.level, one.texel);
        render::Polyline line;
        for (const glm::dvec2 corner : corners(one.level, one.texel)) {
            const glm::vec2 uv(glm::mix(corner, middle, kInset));
            line.points.push_back(surface.position(one.face, uv));
        }
        line.closed = true;
        line.color = {color.redF(), color.greenF(), color.blueF(), 0.95F};
        line.width = 1.0F + 1.5F * static_cast<float>(std::sqrt(share));
        line.outlined = false; // they would hide small texels
        lines.push_back(std::move(line));
    }
    return lines;
}

double magnificationOf(const ProbedFootprint& probed, bool enlarged)
{
    const bool pixel =
        probed.source == FootprintSource::Screen || probed.source == FootprintSource::Tilted;
    return pixel && enlarged ? kFootprintEnlarged : 1.0;
}

std::vector<render::Polyline>
marksOnSurface(const SeenSurface& surface, const TexelStore& texels, const FootprintMarks& marks)
{
    const Surface& cage = surface.cage();
    std::vector<render::Polyline> lines;
    const auto add = [&](const ProbedFootprint& probed, FootprintRole role) {
        const double magnification = magnificationOf(probed, marks.enlarged);
        PlacedFootprint larger = probed.placed;
        larger.footprint.w1 *= magnification;
        larger.footprint.w2 *= magnification;
        NetLimits limits;
        limits.cut = kLinesCut;
        const FootprintNet net =
            footprintNet(cage.mesh(), cage.adjacency(), texels, larger, limits);
        std::ranges::move(footprintOnSurface(net, surface, role, magnification == 1.0),
                          std::back_inserter(lines));
    };
    if (marks.live != nullptr && marks.weights != nullptr) {
        lines = weightsOnSurface(surface, *marks.weights);
    }
    if (marks.frozen != nullptr) {
        add(*marks.frozen, FootprintRole::Frozen);
    }
    if (marks.live != nullptr) {
        add(*marks.live, FootprintRole::Live);
    }
    return lines;
}

} // namespace trixel::ui
