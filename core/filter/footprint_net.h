// SPDX-License-Identifier: GPL-3.0-or-later
//
// A footprint and the faces it reaches, laid flat: what people look at to see what a filter does.
#pragma once

#include "core/filter/contributions.h"
#include "core/filter/query_ellipse.h"
#include "core/footprint/footprint.h"
#include "core/mesh/adjacency.h"
#include "core/mesh/triangle_mesh.h"
#include "core/texture/texel_store.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace trixel {

/// A point of a surface and the footprint about it.
struct PlacedFootprint
{
    FaceId face{};
    glm::dvec2 uv{0};
    Footprint footprint; ///< in (u,v) of the face

    bool operator==(const PlacedFootprint& other) const
    {
        return face == other.face && uv == other.uv && footprint.w1 == other.footprint.w1 &&
               footprint.w2 == other.footprint.w2;
    }
};

/// Lengths are world units; the footprint's centre is the origin, its face turns left with V0→V1
/// along x.
struct FootprintNet
{
    struct Face
    {
        FaceId face{};
        Level level; ///< of its texels
        std::array<glm::dvec2, 3> corners{};

        glm::dvec2 pointOf(glm::dvec2 uv) const
        {
            return corners[0] + uv.x * (corners[1] - corners[0]) + uv.y * (corners[2] - corners[0]);
        }
        /// Outside the face, too. The face has an area.
        glm::dvec2 uvOf(glm::dvec2 point) const;
    };
    struct Place
    {
        std::size_t face = 0; ///< in `faces`
        glm::dvec2 uv{0};
    };

    /// The footprint's own first, then as filters lay them (`Unfolding`); the neighbours of the
    /// first are there in any case.
    std::vector<Face> faces;
    bool isCut = false;   ///< there were more faces than room
    QueryEllipse ellipse; ///< what filters make of the footprint, floor and limits included
    FaceShape shape;      ///< of the first face
    glm::dvec2 w1{0}, w2{0};
    /// Half axes of one standard deviation: of the vectors alone, and with what filters add so that
    /// no ellipse falls between texels.
    glm::dvec2 major{0}, minor{0};
    glm::dvec2 widenedMajor{0}, widenedMinor{0};

    std::optional<Place> placeAt(glm::dvec2 point) const;
    /// The first face of that number.
    std::optional<std::size_t> indexOfFace(FaceId face) const;
};

/// How far a net reaches.
struct NetLimits
{
    double cut = 4.5;            ///< standard deviations
    std::size_t mostFaces = 400; ///< the nearest
};

/// \param footprint  its face exists (checked)
/// \param texels     for the levels of the faces; as many as the mesh has (checked)
FootprintNet footprintNet(const TriangleMesh& mesh,
                          const Adjacency& adjacency,
                          const TexelStore& texels,
                          const PlacedFootprint& footprint,
                          const NetLimits& limits = {});

/// The ellipse that a method's weights make: their mean and half axes of one standard deviation.
struct WeightEllipse
{
    glm::dvec2 mean{0};
    double majorSigma = 0;
    double minorSigma = 0;
    glm::dvec2 majorAxis{1, 0};
    double placed = 0; ///< part of the weight that lies on faces of the net: the rest is left out
};

/// Nothing where no weight lies on faces of the net.
std::optional<WeightEllipse> weightEllipse(const FootprintNet& net, const Contributions& weights);

} // namespace trixel
