// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/paint/limit_texels.h"

#include "core/lattice/texel.h"
#include "core/paint/stroke_buffer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace trixel {

namespace {

/// Between the corners of a square the surface leaves them by its bend, along the diagonal twice.
constexpr double kAcross = 3;

/// A square of the face's (u,v), or the half of it that lies within the face.
struct Square
{
    glm::dvec2 low{0};
    double side = 0;
};

/// Appends what the surface is at the square's corners that the face has.
void addCorners(const Square& square,
                const LimitSurface::Evaluator& evaluator,
                std::vector<glm::dvec3>& points)
{
    for (const glm::dvec2 corner : {glm::dvec2(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
        const glm::dvec2 uv = square.low + square.side * corner;
        if (uv.x + uv.y <= 1) { // squares stand on a lattice: none is cut but along its diagonal
            points.push_back(evaluator.position(uv));
        }
    }
}

} // namespace

LimitFaceTexels::LimitFaceTexels(const LimitMesh& limit,
                                 FaceId face,
                                 Level level,
                                 std::shared_ptr<const DabReach> reach)
    : m_reach(std::move(reach))
    , m_face(face)
    , m_level(level)
    , m_side(std::min(level.resolution(), StrokeFace::kTileSide))
    , m_perRow(level.resolution() / m_side)
    , m_tiles(std::size_t{m_perRow} * m_perRow)
{
    LimitSurface::Evaluator evaluator(limit.surface());
    evaluator.moveTo(face);
    const FaceBend& bend = limit.tessellation().bends().faces()[indexOf(face)];
    for (std::uint32_t y = 0; y < m_perRow; ++y) {
        for (std::uint32_t x = 0; x < m_perRow; ++x) {
            bound(m_tiles[std::size_t{y} * m_perRow + x], x, y, evaluator, bend);
        }
    }
}

// A tile of the packed square holds lower texels of one square of the face's and upper texels of
// its mirror image.
void LimitFaceTexels::bound(Tile& tile,
                            std::uint32_t tileX,
                            std::uint32_t tileY,
                            const LimitSurface::Evaluator& evaluator,
                            const FaceBend& bend) const
{
    const double side = 1.0 / m_perRow; // a power of two: exact
    const glm::dvec2 low = side * glm::dvec2(tileX, tileY);
    const glm::dvec2 mirrored(1 - side - low.y, 1 - side - low.x);
    std::vector<glm::dvec3> points;
    for (const glm::dvec2 at : {low, mirrored}) {
        addCorners({at, side}, evaluator, points);
    }
    glm::dvec3 sum(0);
    for (const glm::dvec3& p : points) {
        sum += p;
    }
    tile.centre = glm::vec3(sum / static_cast<double>(points.size()));
    double radius = 0;
    for (const glm::dvec3& p : points) {
        radius = std::max(radius, glm::distance(p, glm::dvec3(tile.centre)));
    }
    const double off = kAcross * bend.inside * std::pow(side, bend.power);
    tile.radius = static_cast<float>((radius + off) * 1.0001);
}

bool LimitFaceTexels::isInReach(std::uint32_t tileX, std::uint32_t tileY, const Dab& dab) const
{
    const Tile& tile = m_tiles[std::size_t{tileY} * m_perRow + tileX];
    return glm::distance(tile.centre, dab.centre) <= (tile.radius + dab.radius) * 1.0001F;
}

LimitTexel LimitFaceTexels::evaluated(glm::dvec2 uv, const LimitSurface::Evaluator& evaluator) const
{
    if (!m_reach) {
        return {glm::vec3(evaluator.position(uv)), {}};
    }
    const LimitPoint point = evaluator.at(uv);
    return {glm::vec3(point.position), m_reach->turned(m_face, glm::vec3(point.normal()))};
}

std::span<const LimitTexel> LimitFaceTexels::texels(std::uint32_t tileX,
                                                    std::uint32_t tileY,
                                                    LimitSurface::Evaluator& evaluator)
{
    Tile& tile = m_tiles[std::size_t{tileY} * m_perRow + tileX];
    if (tile.texels.empty()) {
        evaluator.moveTo(m_face);
        tile.texels.reserve(std::size_t{m_side} * m_side);
        for (std::uint32_t y = tileY * m_side; y < (tileY + 1) * m_side; ++y) {
            for (std::uint32_t x = tileX * m_side; x < (tileX + 1) * m_side; ++x) {
                const PackedPixel pixel{static_cast<std::uint16_t>(x),
                                        static_cast<std::uint16_t>(y)};
                const glm::dvec2 uv = centroid(m_level, texelAt(m_level, pixel));
                tile.texels.push_back(evaluated(uv, evaluator));
            }
        }
    }
    return tile.texels;
}

LimitFaceTexels& LimitTexels::face(FaceId face, Level level)
{
    std::unique_ptr<LimitFaceTexels>& found = m_faces[static_cast<std::uint32_t>(face)];
    if (!found) {
        found = std::make_unique<LimitFaceTexels>(*m_limit, face, level, m_reach);
    }
    return *found;
}

} // namespace trixel
