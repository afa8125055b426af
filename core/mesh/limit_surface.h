// SPDX-License-Identifier: GPL-3.0-or-later
//
// The smooth surface that Loop subdivision of a cage comes to, evaluated at any point of any face.
#pragma once

#include "core/base/result.h"
#include "core/mesh/bvh.h"
#include "core/mesh/triangle_mesh.h"

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>

namespace trixel {

/// A point of the limit surface and how it changes with (u,v) of its face, in world units.
struct LimitPoint
{
    glm::dvec3 position{0};
    glm::dvec3 perU{0};
    glm::dvec3 perV{0};

    /// Unit normal, on the side from which the face is counter-clockwise; zero where the surface
    /// folds onto a line or a point.
    glm::dvec3 normal() const;
    /// Corners of the triangle that touches the surface here: with them as V0, V1, V2 the
    /// derivatives and this point are those of a flat face. \param uv  of this point
    std::array<glm::vec3, 3> tangentFace(glm::dvec2 uv) const;
};

/// The limit surface of a cage by Loop's scheme. Faces, their ids and their (u,v) are the cage's.
/// Border edges become smooth curves that depend on the border alone, border vertices of a single
/// face stay corners, creases and sharp vertices stay as sharp as they say. Edges of three and more
/// faces, or run along twice in the same direction, are creases. Immutable and shared; every
/// function may be called from several threads.
///
/// Within 1/32 of a face around a vertex of other than six faces the surface is an approximation of
/// OpenSubdiv's, smooth and the same from each face: off the true limit by up to 4e-5 of an edge's
/// length, and along it by up to 4e-3, at ten faces around; its derivatives there are within 1e-2.
/// Elsewhere it is exact.
class LimitSurface
{
    struct Patches;

public:
    /// Copies what it needs of the cage. Takes about 1 s for a million faces.
    /// Fails, naming the face, vertex or crease, on a cage that `loopRefined` refuses, and on
    /// creases of vertices beyond the cage's or a sharpness outside [0, kSharp].
    /// \param sharpness  in the place of the cage's own
    static Result<std::shared_ptr<const LimitSurface>> build(const TriangleMesh& cage,
                                                             const Sharpness& sharpness);
    /// As sharp as the cage itself says.
    static Result<std::shared_ptr<const LimitSurface>> build(const TriangleMesh& cage)
    {
        return build(cage, cage.sharpness);
    }
    /// Whether a cage has a limit surface, but for memory; fails as `build`.
    static Status check(const TriangleMesh& cage);
    ~LimitSurface();
    LimitSurface(const LimitSurface&) = delete;
    LimitSurface& operator=(const LimitSurface&) = delete;

    std::size_t faceCount() const { return m_triangles.size(); }
    std::size_t edgeCount() const;
    std::size_t vertexCount() const { return m_positions.size(); }

    /// The cage's vertices of a face.
    const Triangle& vertices(FaceId face) const { return m_triangles[indexOf(face)]; }
    /// Numbers below edgeCount(), in the order of `LocalEdge`; faces that share an edge of the cage
    /// give it the same number.
    std::array<std::uint32_t, 3> edges(FaceId face) const;
    /// All three vertices are inside the mesh, have six faces and no crease: the face is one
    /// polynomial of degree four.
    bool isRegular(FaceId face) const;

    /// Evaluates points of one face after the other; one a thread. The surface must outlive it.
    class Evaluator
    {
    public:
        explicit Evaluator(const LimitSurface& surface);
        ~Evaluator();
        Evaluator(Evaluator&&) noexcept;

        /// Prepares a face (checked to exist); does nothing when it is the present one.
        void moveTo(FaceId face);

        /// \param uv  of the present face: u, v >= 0 and u + v <= 1
        glm::dvec3 position(glm::dvec2 uv) const;
        /// With both derivatives. \param uv  as above
        LimitPoint at(glm::dvec2 uv) const;

    private:
        struct State;
        std::unique_ptr<State> m_state;
    };

    /// One point by itself; an Evaluator is faster for several of a face.
    LimitPoint at(FaceId face, glm::dvec2 uv) const;

private:
    LimitSurface();

    std::vector<glm::vec3> m_positions;
    std::vector<Triangle> m_triangles;
    std::unique_ptr<Patches> m_patches;
};

} // namespace trixel
