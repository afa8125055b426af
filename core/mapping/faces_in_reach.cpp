// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mapping/faces_in_reach.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace trixel {

namespace {

struct Box
{
    glm::dvec2 low{INFINITY};
    glm::dvec2 high{-INFINITY};

    void include(glm::dvec2 point)
    {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
};

Box boxOf(const Quad& quad)
{
    Box box;
    for (const glm::dvec2 corner : {quad.p00, quad.p10, quad.p11, quad.p01}) {
        box.include(corner);
    }
    return box;
}

class Reach
{
public:
    explicit Reach(const Projection& projection)
        : m_projection(projection)
        , m_box(boxOf(projection.corners))
    {
    }

    bool operator()(const std::array<glm::vec3, 3>& corners) const
    {
        Box face;
        std::array<glm::dvec2, 3> places{};
        int behind = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec4 at = m_projection.toPlane * glm::dvec4(glm::dvec3(corners[k]), 1);
            if (at.w > 0) {
                places[k] = glm::dvec2(at) / at.w;
                face.include(places[k]);
            } else {
                ++behind;
            }
        }
        if (behind > 0) {
            return behind < 3; // one that the eye's plane cuts may be anywhere
        }
        // A little more than nothing, for rounding: turned away only where that is beyond doubt.
        const glm::dvec2 a = places[1] - places[0];
        const glm::dvec2 b = places[2] - places[0];
        const bool isBack = a.x * b.y - a.y * b.x < -1e-9 * (glm::length(a) * glm::length(b));
        const double slack = 1e-9 * glm::length(m_box.high - m_box.low);
        const bool isOutside =
            face.low.x > m_box.high.x + slack || face.low.y > m_box.high.y + slack ||
            face.high.x < m_box.low.x - slack || face.high.y < m_box.low.y - slack;
        return !isOutside && !(m_projection.frontOnly && isBack);
    }

private:
    const Projection& m_projection;
    Box m_box;
};

} // namespace

std::vector<FaceId> facesInReach(const Projection& projection,
                                 const TriangleMesh& mesh,
                                 std::span<const FaceId> faces,
                                 Threads threads)
{
    const Reach reaches(projection);
    std::vector<std::uint8_t> isReached(faces.size());
    parallelFor(faces.size(), 4096, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            isReached[k] = reaches(mesh.corners(faces[k])) ? 1 : 0;
        }
    });
    std::vector<FaceId> reached;
    for (std::size_t k = 0; k < faces.size(); ++k) {
        if (isReached[k] != 0) {
            reached.push_back(faces[k]);
        }
    }
    return reached;
}

} // namespace trixel
