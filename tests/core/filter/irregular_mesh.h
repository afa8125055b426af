// SPDX-License-Identifier: GPL-3.0-or-later
//
// A closed mesh without any regularity, for properties that must hold on every mesh.
#pragma once

#include "tests/core/test_meshes.h"

#include <algorithm>
#include <map>
#include <random>
#include <set>

namespace trixel::test {

/// A dented sphere of 20 · 4^steps faces whose vertices have valence 3 to 10 and whose faces begin
/// at any of their corners.
inline TriangleMesh irregularSphere(int steps, unsigned seed)
{
    TriangleMesh mesh = sphereMesh(steps);
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> jitter(-0.12F, 0.12F);
    for (glm::vec3& p : mesh.positions) {
        const float x = jitter(random);
        const float y = jitter(random);
        p += glm::vec3(x, y, jitter(random));
    }
    // Flip edges at random where valences stay within bounds.
    const std::size_t count = mesh.triangles.size();
    std::vector<int> valence(mesh.positions.size(), 0);
    for (const Triangle& t : mesh.triangles) {
        for (const std::uint32_t v : t) {
            ++valence[v];
        }
    }
    for (std::size_t attempt = 0; attempt < 3 * count; ++attempt) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> faceOf;
        for (std::size_t f = 0; f < count; ++f) {
            for (std::size_t k = 0; k < 3; ++k) {
                faceOf[{mesh.triangles[f][k], mesh.triangles[f][(k + 1) % 3]}] = f;
            }
        }
        const std::size_t f = random() % count;
        const std::size_t k = random() % 3;
        const std::uint32_t a = mesh.triangles[f][k];
        const std::uint32_t b = mesh.triangles[f][(k + 1) % 3];
        const std::uint32_t c = mesh.triangles[f][(k + 2) % 3];
        const std::size_t g = faceOf.at({b, a});
        const Triangle& other = mesh.triangles[g];
        const std::uint32_t d =
            *std::ranges::find_if(other, [&](std::uint32_t v) { return v != a && v != b; });
        if (valence[a] <= 3 || valence[b] <= 3 || valence[c] >= 10 || valence[d] >= 10 ||
            faceOf.contains({c, d}) || faceOf.contains({d, c})) {
            continue;
        }
        --valence[a];
        --valence[b];
        ++valence[c];
        ++valence[d];
        mesh.triangles[f] = {c, a, d};
        mesh.triangles[g] = {d, b, c};
    }
    for (Triangle& t : mesh.triangles) {
        std::ranges::rotate(t, t.begin() + random() % 3);
    }
    return mesh;
}

/// Levels from `least` to `most`, independent of each other.
inline FaceMap<Level> randomLevels(std::size_t faces, int least, int most, unsigned seed)
{
    std::mt19937 random(seed);
    FaceMap<Level> levels(static_cast<std::uint32_t>(faces));
    for (std::size_t f = 0; f < faces; ++f) {
        levels[faceId(f)] = Level(least + static_cast<int>(random() % unsigned(most - least + 1)));
    }
    return levels;
}

} // namespace trixel::test
