// SPDX-License-Identifier: GPL-3.0-or-later
//
// Throwing an image onto a surface: straight, from a camera, or from four corners.
#pragma once

#include "core/base/result.h"
#include "core/mapping/mapping.h"
#include "core/mapping/quad.h"
#include "core/mesh/bvh.h"
#include "core/mesh/triangle_mesh.h"

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>

namespace trixel {

/// An image thrown onto a surface through a plane that is seen from a point or from afar. Planar,
/// quadrilateral and camera mapping are the three ways of making one.
struct Projection
{
    /// From the world to homogeneous places of the plane: (x/w, y/w), w > 0 in front.
    glm::dmat4 toPlane{1};
    /// Where in the plane the image's corners lie: (s,t) = (0,0), (1,0), (1,1), (0,1).
    Quad corners;
    bool isRectangle = true; ///< whether `corners` is the unit square
    /// Only faces that turn counter-clockwise in the plane are reached.
    bool frontOnly = false;
    /// Only what nothing hides is reached. \p eye  in homogeneous places of the world (w 0: from
    /// afar, towards the viewer)
    bool visibleOnly = false;
    glm::dvec4 eye{0, 0, 1, 0};
};

/// Straight along right × up. \param origin  of the image's lower left corner
/// \param right, up  along its width and height, as long as they are. Fails if they span nothing.
Result<Projection> planarProjection(glm::dvec3 origin, glm::dvec3 right, glm::dvec3 up);

/// From four corners in space, in the order of `Projection::corners`, straight along the direction
/// that sees most of them. Fails, in one sentence, if they are a line, cross each other or bend
/// inwards: then no point of the image has one place.
Result<Projection> quadProjection(const std::array<glm::dvec3, 4>& corners);

/// Four corners in the picture of a camera. \param toClip  world to clip space
/// \param corners  in clip space, x to the right and y upwards from -1 to 1; fails as above
Result<Projection> cameraQuadProjection(const glm::dmat4& toClip, const Quad& corners);

/// What a camera sees, over the whole of its picture. \param toClip  from the world to clip space,
/// x to the right and y upwards from -1 to 1; fails if it cannot be inverted
Result<Projection> cameraProjection(const glm::dmat4& toClip);

/// Fails, in one sentence, unless the corners go round a convex area counter-clockwise or
/// clockwise.
Status checkQuad(const Quad& quad);

/// By a projection; what it does not reach does not land.
class ProjectionMapping final : public Mapping
{
public:
    /// \param mesh  outlives this
    /// \param bvh   of the mesh; outlives this. Needed for `visibleOnly` (checked)
    ProjectionMapping(const TriangleMesh& mesh, const Projection& projection, const Bvh* bvh);

    ImagePlace at(FaceId face, glm::dvec2 uv, double step) const override;

private:
    bool isSeen(FaceId face, const glm::dvec3& point) const;

    const TriangleMesh& m_mesh;
    Projection m_projection;
    const Bvh* m_bvh;
    double m_size = 1; ///< of the mesh, world units
};

} // namespace trixel
