// SPDX-License-Identifier: GPL-3.0-or-later
//
// A whole atlas of one float channel in memory, for tests.
#pragma once

#include "core/atlas/atlas_address.h"
#include "core/atlas/atlas_texels.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

namespace trixel::test {

inline const TexelFormat kOneFloat{TexelType::Float, 1, std::nullopt};

/// An n × n grid of squares, each of two triangles whose corners are numbered from any of theirs:
/// every pairing of edges occurs, and neighbours unfold as parallelograms.
inline TriangleMesh turnedGrid(int n, unsigned seed)
{
    std::mt19937 random(seed);
    TriangleMesh mesh;
    const auto id = [n](int i, int j) { return static_cast<std::uint32_t>(i + j * (n + 1)); };
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            mesh.positions.push_back({static_cast<float>(i), static_cast<float>(j), 0});
        }
    }
    const auto add = [&](Triangle triangle) {
        std::rotate(
            triangle.begin(), triangle.begin() + static_cast<long>(random() % 3), triangle.end());
        mesh.triangles.push_back(triangle);
    };
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            add({id(i, j), id(i + 1, j), id(i, j + 1)});
            add({id(i + 1, j + 1), id(i, j + 1), id(i + 1, j)});
        }
    }
    return mesh;
}

inline glm::vec3 pointOf(const TriangleMesh& mesh, FaceId face, glm::dvec2 uv)
{
    const auto corners = mesh.corners(face);
    return corners[0] + static_cast<float>(uv.x) * (corners[1] - corners[0]) +
           static_cast<float>(uv.y) * (corners[2] - corners[0]);
}

/// Every texel holds the value of a function of its face and centroid.
template <class Function>
TexelStore storeOf(const FaceMap<Level>& levels, const Function& function)
{
    TexelStore store(kOneFloat, levels, std::vector<std::byte>(4));
    for (std::size_t f = 0; f < levels.size(); ++f) {
        const Level level = levels[faceId(f)];
        const std::span<std::byte> texels = store.writable(faceId(f));
        for (std::uint32_t k = 0; k < level.texelCount(); ++k) {
            const float value = function(faceId(f), centroid(level, texelAt(level, TexelIndex(k))));
            std::memcpy(texels.data() + 4 * k, &value, 4);
        }
    }
    return store;
}

/// Pages of an atlas; what no tile has written is NaN.
struct AtlasPages
{
    AtlasLayout layout;
    std::vector<std::vector<float>> pages;

    AtlasPages(AtlasLayout planned, const TexelStore& store, const Adjacency& adjacency)
        : layout(std::move(planned))
    {
        for (const AtlasPage& page : layout.pages()) {
            pages.emplace_back(std::size_t{page.width} * page.height,
                               std::numeric_limits<float>::quiet_NaN());
        }
        AtlasTexels texels(store, adjacency);
        while (true) {
            for (std::size_t f = 0; f < layout.faceCount(); ++f) {
                const Level own = layout.level(faceId(f));
                if (own == texels.level() || (own > texels.level() && layout.options().mips)) {
                    fill(texels, faceId(f));
                }
            }
            if (texels.level() == Level()) {
                break;
            }
            texels.coarsen(Threads{1});
        }
    }

    float value(const AtlasTap& tap) const
    {
        return pages[tap.page]
                    [std::size_t{tap.pixel.y} * layout.pages()[tap.page].width + tap.pixel.x];
    }
    template <class Taps>
    double sum(const Taps& taps) const
    {
        double result = 0;
        for (const AtlasTap& tap : taps) {
            result += tap.weight * static_cast<double>(value(tap));
        }
        return result;
    }

private:
    void fill(const AtlasTexels& texels, FaceId face)
    {
        const AtlasPlace place = layout.place(face, texels.level());
        const std::size_t width = layout.pages()[place.page].width;
        float* first = pages[place.page].data() + place.origin.y * width + place.origin.x;
        texels.fill(face,
                    layout.tile(texels.level()),
                    reinterpret_cast<std::byte*>(first),
                    sizeof(float) * width);
    }
};

} // namespace trixel::test
