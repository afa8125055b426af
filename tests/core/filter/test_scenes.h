// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small scenes to judge filters on: meshes of chosen valence and shape, levels equal or mixed,
// content that is known everywhere. All of it is made on the spot and the same every time.
#pragma once

#include "core/filter/filter_scene.h"
#include "core/lattice/texel.h"
#include "core/mesh/triangle_mesh.h"
#include "tests/core/test_meshes.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <utility>
#include <vector>

namespace trixel::test {

/// Well mixed bits of a number (splitmix64): the random source of these scenes, because it is the
/// same everywhere and can be asked for any place.
inline std::uint64_t mixed(std::uint64_t x)
{
    x += 0x9E3779B97F4A7C15U;
    x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9U;
    x = (x ^ (x >> 27U)) * 0x94D049BB133111EBU;
    return x ^ (x >> 31U);
}

/// In [0, 1), with 24 bits.
inline double uniform(std::uint64_t x)
{
    return static_cast<double>(mixed(x) >> 40U) / 16777216.0;
}

/// A stream of such numbers.
class Dice
{
public:
    explicit Dice(std::uint64_t seed)
        : m_state(mixed(seed))
    {
    }
    std::uint64_t bits() { return mixed(m_state++); }
    double uniform() { return static_cast<double>(bits() >> 40U) / 16777216.0; }
    double between(double low, double high) { return low + (high - low) * uniform(); }
    /// Uniform in the logarithm.
    double logBetween(double low, double high)
    {
        return std::exp(between(std::log(low), std::log(high)));
    }
    std::uint32_t below(std::size_t count)
    {
        return static_cast<std::uint32_t>(bits() % std::uint64_t{count});
    }

private:
    std::uint64_t m_state;
};

// Meshes ------------------------------------------------------------------------------------------

/// A flat parallelogram of 2 n² equilateral triangles with edges of length 1 in z = 0: the inner
/// vertices have valence 6.
inline TriangleMesh flatPatch(std::uint32_t n)
{
    TriangleMesh mesh = gridMesh(n);
    const float h = std::sqrt(3.0F) / 2;
    for (glm::vec3& p : mesh.positions) {
        p = static_cast<float>(n) * glm::vec3(p.x + p.y / 2, h * p.y, 0);
    }
    return mesh;
}

/// Moves every vertex by up to `amount` along each axis; with `flat` only in x and y.
inline TriangleMesh jittered(TriangleMesh mesh, float amount, std::uint64_t seed, bool flat = false)
{
    Dice dice(seed);
    for (glm::vec3& p : mesh.positions) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto by = static_cast<float>(dice.between(-amount, amount));
            p[axis] += flat && axis == 2 ? 0.0F : by;
        }
    }
    return mesh;
}

/// Every triangle cut into four at the middles of its edges.
inline TriangleMesh subdivided(const TriangleMesh& mesh)
{
    TriangleMesh finer;
    finer.positions = mesh.positions;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto next = static_cast<std::uint32_t>(finer.positions.size());
        const auto [place, isNew] = middles.try_emplace(std::minmax(a, b), next);
        if (isNew) {
            finer.positions.push_back(0.5F * (finer.positions[a] + finer.positions[b]));
        }
        return place->second;
    };
    for (const auto& [a, b, c] : mesh.triangles) {
        const std::uint32_t ab = middle(a, b);
        const std::uint32_t bc = middle(b, c);
        const std::uint32_t ca = middle(c, a);
        finer.triangles.insert(finer.triangles.end(),
                               {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    return finer;
}

/// A closed mesh of 2 · valence triangles: two poles of that valence, an equator of valence 4.
inline TriangleMesh bipyramid(std::uint32_t valence)
{
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 1}, {0, 0, -1}};
    for (std::uint32_t k = 0; k < valence; ++k) {
        const double angle = 6.283185307179586 * k / valence;
        mesh.positions.emplace_back(
            static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 0.0F);
    }
    for (std::uint32_t k = 0; k < valence; ++k) {
        const std::uint32_t next = 2 + (k + 1) % valence;
        mesh.triangles.push_back({0, 2 + k, next});
        mesh.triangles.push_back({1, next, 2 + k});
    }
    return mesh;
}

/// A closed mesh of 8 · valence triangles of many shapes, with vertices of valence 4 and 6 and two
/// of the valence asked for.
inline TriangleMesh closedIrregular(std::uint32_t valence, std::uint64_t seed)
{
    return jittered(subdivided(bipyramid(valence)), 0.12F, seed);
}

// Texels ------------------------------------------------------------------------------------------

/// Where a texel is asked for its value.
struct TexelPlace
{
    FaceId face{};
    Level level;
    TexelIndex index{};
    glm::dvec3 position{0}; ///< of its centroid, on the mesh
    int channel = 0;
};

using Content = std::function<float(const TexelPlace&)>;

inline Content constantContent(float value)
{
    return [value](const TexelPlace&) { return value; };
}

/// White noise in [0, 1): every texel and channel on its own.
inline Content noiseContent(std::uint64_t seed)
{
    return [seed](const TexelPlace& at) {
        const std::uint64_t texel = indexOf(at.face) << 32U | indexOf(at.index);
        return static_cast<float>(
            uniform(mixed(texel ^ mixed(seed)) + static_cast<std::uint64_t>(at.channel)));
    };
}

/// 0 and 1 by turns in cubes of a size, so that they continue over edges.
inline Content checkerContent(double size)
{
    return [size](const TexelPlace& at) {
        const glm::dvec3 cell = at.position / size;
        const auto sum = std::floor(cell.x) + std::floor(cell.y) + std::floor(cell.z);
        return static_cast<float>(std::fmod(std::abs(sum + at.channel), 2.0));
    };
}

/// origin + gradient · position. On a flat mesh that is affine in every face and across them.
inline Content affineContent(glm::dvec3 gradient, double origin)
{
    return [=](const TexelPlace& at) {
        return static_cast<float>(origin + gradient.x * at.position.x + gradient.y * at.position.y +
                                  gradient.z * at.position.z);
    };
}

/// A level for each face, in [low, high].
inline FaceMap<Level> mixedLevels(std::size_t faceCount, int low, int high, std::uint64_t seed)
{
    Dice dice(seed);
    FaceMap<Level> levels(faceCount);
    for (Level& level : levels.values()) {
        level = Level(low + static_cast<int>(dice.below(static_cast<std::size_t>(high - low + 1))));
    }
    return levels;
}

/// Float texels of the content, evaluated at every centroid.
inline TexelStore filledStore(const TriangleMesh& mesh,
                              const FaceMap<Level>& levels,
                              const Content& content,
                              int channels = 1)
{
    const TexelFormat format{TexelType::Float, static_cast<std::uint16_t>(channels), std::nullopt};
    const std::vector<std::byte> zero(format.texelBytes());
    TexelStore store(format, levels, zero);
    for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) {
        TexelPlace at;
        at.face = faceId(f);
        at.level = levels[at.face];
        const auto corners = mesh.corners(at.face);
        std::vector<float> values;
        for (std::uint32_t t = 0; t < at.level.texelCount(); ++t) {
            at.index = static_cast<TexelIndex>(t);
            const glm::dvec2 uv = centroid(at.level, texelAt(at.level, at.index));
            at.position = glm::dvec3(corners[0]) +
                          uv.x * (glm::dvec3(corners[1]) - glm::dvec3(corners[0])) +
                          uv.y * (glm::dvec3(corners[2]) - glm::dvec3(corners[0]));
            for (at.channel = 0; at.channel < channels; ++at.channel) {
                values.push_back(content(at));
            }
        }
        std::memcpy(store.writable(at.face).data(), values.data(), values.size() * sizeof(float));
    }
    return store;
}

// Scenes ------------------------------------------------------------------------------------------

/// A mesh with texels, and what filters read of it.
struct TestScene
{
    TriangleMesh mesh;
    TexelStore texels;
    std::shared_ptr<const FilterSurface> surface;
    FilterScene filter;
};

inline TestScene makeScene(TriangleMesh mesh, TexelStore texels)
{
    TestScene scene;
    scene.surface = std::make_shared<FilterSurface>(
        FilterSurface::fromMesh(mesh, buildAdjacency(mesh.triangles)));
    NoProgress progress;
    auto built = FilterScene::build(scene.surface, texels, Threads{1}, progress);
    check(built.has_value(), "a scene that nobody cancels");
    scene.mesh = std::move(mesh);
    scene.texels = std::move(texels);
    scene.filter = std::move(*built);
    return scene;
}

inline TestScene
makeScene(TriangleMesh mesh, const FaceMap<Level>& levels, const Content& content, int channels = 1)
{
    TexelStore texels = filledStore(mesh, levels, content, channels);
    return makeScene(std::move(mesh), std::move(texels));
}

/// All faces of one level.
inline TestScene makeScene(TriangleMesh mesh, Level level, const Content& content, int channels = 1)
{
    const FaceMap<Level> levels(mesh.faceCount(), level);
    return makeScene(std::move(mesh), levels, content, channels);
}

} // namespace trixel::test
