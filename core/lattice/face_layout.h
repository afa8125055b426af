// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the texels of a face are drawn in a plane: as triangles, which is what they are on the
// mesh, or as the square pixels that a file stores them in.
#pragma once

#include "core/lattice/texel.h"

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <optional>
#include <span>

namespace trixel {

/// An affine map of the plane: p goes to origin + p.x · x + p.y · y.
struct PlaneMap
{
    glm::dvec2 origin{0, 0};
    glm::dvec2 x{1, 0};
    glm::dvec2 y{0, 1};

    glm::dvec2 point(glm::dvec2 p) const { return origin + vector(p); }
    glm::dvec2 vector(glm::dvec2 p) const { return p.x * x + p.y * y; }
    /// Area of the image of the unit square; negative where the map turns over.
    double area() const { return x.x * y.y - x.y * y.x; }
    /// \return  the map back; `area` is not 0 (checked)
    PlaneMap inverse() const;
    /// This map after another.
    PlaneMap after(const PlaneMap& first) const;

    bool operator==(const PlaneMap&) const = default;
};

/// The corners of a texel, three or four, in order round it.
class TexelOutline
{
public:
    explicit TexelOutline(const std::array<glm::dvec2, 3>& corners)
        : m_corners{corners[0], corners[1], corners[2], corners[2]}
        , m_count(3)
    {
    }
    explicit TexelOutline(const std::array<glm::dvec2, 4>& corners)
        : m_corners(corners)
        , m_count(4)
    {
    }

    std::span<const glm::dvec2> corners() const { return {m_corners.data(), m_count}; }

private:
    std::array<glm::dvec2, 4> m_corners;
    std::size_t m_count;
};

/// A face laid out in a plane. Where its vertices lie is the same for every level; edge e runs from
/// corner e to the next.
class FaceLayout
{
public:
    enum class Texels {
        Triangles, ///< (u,v) goes where the map takes it
        Pixels     ///< pixel (x,y) of the packed square covers [x, x+1] × [y, y+1], over R mapped
    };

    /// Texels as they are on a triangle with these corners, which are not on one line (checked).
    static FaceLayout triangle(glm::dvec2 v0, glm::dvec2 v1, glm::dvec2 v2);
    /// x = u + v/2, y = v: rows of texels are rows of the plane, as filters that work along rows
    /// see them.
    static FaceLayout rectilinear();
    /// The packed square from (0,0) to (1,1). Upper texels lie beyond the diagonal from V1 to V2,
    /// turned over.
    static FaceLayout packed();

    Texels texels() const { return m_texels; }
    /// From (u,v), or from the packed square over R, to the plane.
    const PlaneMap& map() const { return m_map; }
    /// The same layout moved by a map of the plane.
    FaceLayout moved(const PlaneMap& map) const { return {m_texels, map.after(m_map)}; }

    /// Where V0, V1, V2 lie.
    glm::dvec2 corner(std::size_t vertex) const;
    /// Of all texels together: the triangle or the square.
    TexelOutline outline() const;
    TexelOutline outline(Level level, TexelCoord texel) const;
    /// Where the texel's centroid is drawn: its own, or the centre of its pixel.
    glm::dvec2 centre(Level level, TexelCoord texel) const;
    /// Where a point of a texel is drawn. Pixels show the triangle of the texel 1/6 off, so that
    /// its centroid meets their centre (`toPacked`).
    glm::dvec2 place(Level level, TexelCoord texel, glm::dvec2 uv) const;
    /// Corners of the texel's triangle as `place` puts them: its outline where texels are
    /// triangles.
    std::array<glm::dvec2, 3> triangleOf(Level level, TexelCoord texel) const;
    /// The texel drawn at a point; nothing beside the face.
    std::optional<TexelCoord> texelAt(Level level, glm::dvec2 point) const;

    bool operator==(const FaceLayout&) const = default;

private:
    FaceLayout(Texels texels, const PlaneMap& map)
        : m_texels(texels)
        , m_map(map)
    {
    }

    Texels m_texels;
    PlaneMap m_map;
};

} // namespace trixel
