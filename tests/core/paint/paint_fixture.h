// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tests of painting share: surfaces and stores made on the spot, and coverage by brute
// force over every texel of a mesh.
#pragma once

#include "core/lattice/texel.h"
#include "core/mesh/surface.h"
#include "core/paint/dab.h"
#include "core/paint/stroke.h"
#include "core/texture/texel_store.h"

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace trixel::test {

inline std::shared_ptr<const Surface> surfaceOf(TriangleMesh mesh)
{
    NoProgress progress;
    return *Surface::build(std::move(mesh), progress);
}

/// One channel of float, all zero: coverage by a white brush reads as the value itself.
inline TexelStore coverageStore(const FaceMap<Level>& levels)
{
    const TexelFormat format{TexelType::Float, 1, std::nullopt};
    const std::array<std::byte, 4> zero{};
    return TexelStore(format, levels, zero);
}

inline std::vector<std::byte> zeroFill(const TexelStore& store)
{
    return std::vector<std::byte>(store.format().texelBytes());
}

inline Brush whiteBrush(float radius)
{
    Brush brush;
    brush.radius = radius;
    brush.color = {1, 1, 1, 1};
    return brush;
}

inline float valueAt(const TexelStore& store, FaceId face, TexelIndex texel)
{
    std::array<float, 1> value{};
    decode(store.format().type, store.face(face).texel(indexOf(texel)), value);
    return value[0];
}

/// Calls work(face, texel, position of its centroid) for every texel of the store.
inline void forEachTexel(const TriangleMesh& mesh,
                         const TexelStore& store,
                         const std::function<void(FaceId, TexelIndex, glm::dvec3)>& work)
{
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const Level level = store.face(faceId(f)).level();
        const auto corners = mesh.corners(faceId(f));
        const glm::dvec3 a(corners[0]);
        for (std::uint32_t t = 0; t < level.texelCount(); ++t) {
            const glm::dvec2 uv = centroid(level, texelAt(level, TexelIndex{t}));
            work(faceId(f),
                 TexelIndex{t},
                 a + uv.x * (glm::dvec3(corners[1]) - a) + uv.y * (glm::dvec3(corners[2]) - a));
        }
    }
}

/// The falloff as documented, in double.
inline double falloffAt(double distance, double hardness)
{
    if (distance >= 1) {
        return 0;
    }
    if (distance <= hardness) {
        return 1;
    }
    const double s = (distance - hardness) / (1 - hardness);
    return 1 - s * s * (3 - 2 * s);
}

/// Every face alike to the bit, and constant in both or neither.
inline bool sameToTheBit(const TexelStore& a, const TexelStore& b)
{
    for (std::uint32_t k = 0; k < a.faceCount(); ++k) {
        const FaceTexels& x = a.face(faceId(k));
        const FaceTexels& y = b.face(faceId(k));
        if (x.isConstant() != y.isConstant() || x.level() != y.level() ||
            !std::ranges::equal(x.bytes(), y.bytes())) {
            return false;
        }
    }
    return a.faceCount() == b.faceCount();
}

} // namespace trixel::test
