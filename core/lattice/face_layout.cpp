// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lattice/face_layout.h"

#include "core/base/check.h"
#include "core/lattice/paint_projection.h"

#include <algorithm>

namespace trixel {

PlaneMap PlaneMap::inverse() const
{
    const double whole = area();
    check(whole != 0, "a map that keeps an area");
    PlaneMap back{{0, 0}, {y.y / whole, -x.y / whole}, {-y.x / whole, x.x / whole}};
    back.origin = -back.vector(origin);
    return back;
}

PlaneMap PlaneMap::after(const PlaneMap& first) const
{
    return {point(first.origin), vector(first.x), vector(first.y)};
}

FaceLayout FaceLayout::triangle(glm::dvec2 v0, glm::dvec2 v1, glm::dvec2 v2)
{
    const PlaneMap map{v0, v1 - v0, v2 - v0};
    check(map.area() != 0, "a triangle with an area");
    return {Texels::Triangles, map};
}

FaceLayout FaceLayout::rectilinear()
{
    return {Texels::Triangles, {{0, 0}, {1, 0}, {0.5, 1}}};
}

FaceLayout FaceLayout::packed()
{
    return {Texels::Pixels, {}};
}

glm::dvec2 FaceLayout::corner(std::size_t vertex) const
{
    check(vertex < 3, "one of three vertices");
    return vertex == 0 ? m_map.origin : m_map.origin + (vertex == 1 ? m_map.x : m_map.y);
}

TexelOutline FaceLayout::outline() const
{
    if (m_texels == Texels::Triangles) {
        return TexelOutline(std::array{corner(0), corner(1), corner(2)});
    }
    return TexelOutline(std::array{corner(0), corner(1), m_map.point({1, 1}), corner(2)});
}

TexelOutline FaceLayout::outline(Level level, TexelCoord texel) const
{
    if (m_texels == Texels::Triangles) {
        return TexelOutline(triangleOf(level, texel));
    }
    const PackedPixel pixel = packedPixel(level, texel);
    const double side = 1.0 / level.resolution();
    const glm::dvec2 low(pixel.x * side, pixel.y * side);
    return TexelOutline(std::array{m_map.point(low),
                                   m_map.point(low + glm::dvec2(side, 0)),
                                   m_map.point(low + glm::dvec2(side, side)),
                                   m_map.point(low + glm::dvec2(0, side))});
}

glm::dvec2 FaceLayout::centre(Level level, TexelCoord texel) const
{
    return place(level, texel, centroid(level, texel));
}

glm::dvec2 FaceLayout::place(Level level, TexelCoord texel, glm::dvec2 uv) const
{
    if (m_texels == Texels::Triangles) {
        return m_map.point(uv);
    }
    return m_map.point(toPacked(level, texel.half, uv) / static_cast<double>(level.resolution()));
}

std::array<glm::dvec2, 3> FaceLayout::triangleOf(Level level, TexelCoord texel) const
{
    std::array<glm::dvec2, 3> placed = corners(level, texel);
    for (glm::dvec2& corner : placed) {
        corner = place(level, texel, corner);
    }
    return placed;
}

std::optional<TexelCoord> FaceLayout::texelAt(Level level, glm::dvec2 point) const
{
    const glm::dvec2 p = m_map.inverse().point(point);
    if (m_texels == Texels::Triangles) {
        return p.x >= 0 && p.y >= 0 && p.x + p.y <= 1 ? std::optional(trixel::texelAt(level, p))
                                                      : std::nullopt;
    }
    if (!(p.x >= 0 && p.y >= 0 && p.x <= 1 && p.y <= 1)) {
        return std::nullopt;
    }
    const double last = level.resolution() - 1;
    const auto cell = [&](double x) {
        return static_cast<std::uint16_t>(std::min(x * level.resolution(), last));
    };
    return trixel::texelAt(level, PackedPixel{cell(p.x), cell(p.y)});
}

} // namespace trixel
