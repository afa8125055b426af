// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/corner_normals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <random>

using namespace trixel;
using namespace trixel::render;

namespace {

/// As the shader does it.
glm::vec3 unpack(std::uint32_t bits)
{
    const glm::vec2 p((static_cast<float>(bits & 0xffffU) - 32768.0F) / 32767.0F,
                      (static_cast<float>(bits >> 16U) - 32768.0F) / 32767.0F);
    glm::vec3 n(p.x, p.y, 1.0F - std::abs(p.x) - std::abs(p.y));
    const float fold = std::max(-n.z, 0.0F);
    n.x += n.x < 0 ? fold : -fold;
    n.y += n.y < 0 ? fold : -fold;
    return glm::normalize(n);
}

/// Two right triangles that share the edge x = 0 and enclose `degrees` between their normals.
TriangleMesh fold(float degrees)
{
    const float a = degrees * 3.14159265F / 180.0F;
    return {{{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {std::cos(a), 0, -std::sin(a)}},
            {{0, 1, 2}, {0, 3, 1}},
            {}};
}

} // namespace

TEST(CornerNormals, packingKeepsADirectionToAThousandthOfADegree)
{
    std::mt19937 engine(3);
    std::normal_distribution<float> in;
    for (int k = 0; k < 5000; ++k) {
        const glm::vec3 n = glm::normalize(glm::vec3(in(engine), in(engine), in(engine)));
        EXPECT_LT(glm::length(unpack(packNormal(n)) - n), 1e-4F);
    }
    for (const glm::vec3 n : {glm::vec3(0, 0, 1), glm::vec3(0, 0, -1), glm::vec3(-1, 0, 0)}) {
        EXPECT_LT(glm::length(unpack(packNormal(n)) - n), 1e-4F);
    }
}

TEST(CornerNormals, gentleFoldsAreSmoothAndSharpOnesHard)
{
    const auto smooth = cornerNormals(fold(30));
    EXPECT_LT(glm::length(unpack(smooth[0]) - unpack(smooth[3])), 1e-3F);
    const auto hard = cornerNormals(fold(80));
    EXPECT_LT(glm::length(unpack(hard[0]) - glm::vec3(0, 0, 1)), 1e-3F);
    EXPECT_GT(glm::length(unpack(hard[0]) - unpack(hard[3])), 1.0F);
}

TEST(CornerNormals, degenerateFacesStillGetUnitNormals)
{
    TriangleMesh mesh = fold(10);
    mesh.triangles.push_back({0, 0, 1});
    mesh.positions.push_back({5, 5, 5});
    mesh.triangles.push_back({4, 4, 4});
    for (const std::uint32_t bits : cornerNormals(mesh)) {
        EXPECT_NEAR(glm::length(unpack(bits)), 1, 1e-5);
    }
}

TEST(CornerNormals, anEmptyMeshHasNone)
{
    EXPECT_TRUE(cornerNormals({}).empty());
}
