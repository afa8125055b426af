// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/atlas/hidden_colors.h"
#include "core/lattice/edge_transfer.h"
#include "tests/core/filter/test_scenes.h"

#include <gtest/gtest.h>

#include <array>

using namespace trixel;
using namespace trixel::test;

namespace {

constexpr std::size_t kOpacity = 1;

/// One channel and the opacity, weighed; nothing is shown but by some faces.
class Shown
{
public:
    explicit Shown(const TriangleMesh& mesh)
        : m_surface(std::make_shared<const FilterSurface>(
              FilterSurface::fromMesh(mesh, buildAdjacency(mesh.triangles))))
        , m_texels(TexelFormat{TexelType::Float, 2, kOpacity},
                   FaceMap<Level>(mesh.faceCount(), Level(2)),
                   std::as_bytes(std::span(kNothing)))
    {
    }

    void show(std::size_t face, float value, float opacity)
    {
        const std::array<float, 2> texel{value * opacity, opacity};
        m_texels.exchange(faceId(face),
                          FaceTexels::constant(Level(2), std::as_bytes(std::span(texel))));
    }

    FilterScene scene() const
    {
        NoProgress progress;
        return *FilterScene::build(m_surface, m_texels, Threads{1}, progress);
    }

private:
    static constexpr std::array<float, 2> kNothing{};

    std::shared_ptr<const FilterSurface> m_surface;
    TexelStore m_texels;
};

std::array<float, 2> middleOf(const HiddenColors& colors, std::size_t face)
{
    std::array<float, 2> value{7, 7};
    colors.at(faceId(face), {0.25F, 0.5F}, value);
    return value;
}

/// Two sheets that are not connected.
TriangleMesh twoSheets()
{
    TriangleMesh mesh = gridMesh(6);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const TriangleMesh other = gridMesh(2);
    for (const glm::vec3& p : other.positions) {
        mesh.positions.push_back(p + glm::vec3(0, 0, 1));
    }
    for (Triangle triangle : other.triangles) {
        for (std::uint32_t& vertex : triangle) {
            vertex += first;
        }
        mesh.triangles.push_back(triangle);
    }
    return mesh;
}

TEST(HiddenColors, oneColourGoesOnAsFarAsFacesAreConnected)
{
    Shown shown(twoSheets());
    shown.show(0, 0.75F, 0.2F);
    const FilterScene scene = shown.scene();
    const HiddenColors colors(scene, kOpacity);
    const std::size_t connected = gridMesh(6).faceCount();
    for (std::size_t face = 0; face < scene.faceCount(); ++face) {
        const auto value = middleOf(colors, face);
        EXPECT_NEAR(value[0], face < connected ? 0.75F : 0.0F, 1e-6) << face;
        EXPECT_EQ(value[1], 0) << face;
    }
}

TEST(HiddenColors, betweenTwoColoursTheyGoOverWithoutAJump)
{
    const TriangleMesh mesh = gridMesh(8);
    const std::size_t last = mesh.faceCount() - 1;
    Shown shown(mesh);
    shown.show(0, 1, 1);
    shown.show(last, 0, 1);
    const FilterScene scene = shown.scene();
    const HiddenColors colors(scene, kOpacity);
    EXPECT_NEAR(middleOf(colors, 0)[0], 1, 1e-6);
    EXPECT_NEAR(middleOf(colors, last)[0], 0, 1e-6);
    const Adjacency& adjacency = scene.surface().adjacency();
    for (std::size_t face = 0; face < scene.faceCount(); ++face) {
        const float value = middleOf(colors, face)[0];
        EXPECT_GE(value, 0);
        EXPECT_LE(value, 1);
        for (const LocalEdge edge : {LocalEdge::E0, LocalEdge::E1, LocalEdge::E2}) {
            if (const auto next = adjacency.neighbour(faceId(face), edge)) {
                std::array<float, 2> here{};
                std::array<float, 2> there{};
                colors.at(faceId(face), glm::vec2(fromEdge(edge, {0.3, 0})), here);
                colors.at(next->face, glm::vec2(fromEdge(next->edge, {0.7, 0})), there);
                EXPECT_NEAR(here[0], there[0], 1e-6);
            }
        }
    }
}

} // namespace
