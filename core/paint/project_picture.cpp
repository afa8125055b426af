// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/paint/project_picture.h"

#include "core/base/check.h"
#include "core/lattice/texel.h"
#include "core/texture/texel_codec.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace trixel {

namespace {

glm::vec4 pixelAt(const PictureProjection& picture, int x, int y)
{
    const int column = std::clamp(x, 0, picture.width - 1);
    const int row = std::clamp(y, 0, picture.height - 1);
    const float* pixel = picture.pixels.data() + 4 * (static_cast<std::size_t>(row) *
                                                          static_cast<std::size_t>(picture.width) +
                                                      static_cast<std::size_t>(column));
    return {pixel[0], pixel[1], pixel[2], pixel[3]};
}

/// A pixel with its colour multiplied by its opacity.
glm::vec4 weighed(const PictureProjection& picture, int x, int y)
{
    const glm::vec4 pixel = pixelAt(picture, x, y);
    return {glm::vec3(pixel) * pixel.a, pixel.a};
}

/// The texels of a face with the picture on it; nothing where none of them changes.
std::vector<std::byte> painted(const FaceTexels& before,
                               const TexelFormat& format,
                               const std::array<glm::vec3, 3>& corners,
                               const PictureProjection& picture)
{
    const Level level = before.level();
    const glm::dvec3 corner(corners[0]);
    const glm::dvec3 e1 = glm::dvec3(corners[1]) - corner;
    const glm::dvec3 e2 = glm::dvec3(corners[2]) - corner;
    const std::size_t bytes = format.texelBytes();
    std::vector<std::byte> texels;
    std::vector<float> values(format.channels);
    for (std::uint32_t k = 0; k < level.texelCount(); ++k) {
        const glm::dvec2 uv = centroid(level, texelAt(level, TexelIndex{k}));
        const glm::vec4 lands = projectedAt(picture, corner + uv.x * e1 + uv.y * e2);
        if (!(lands.a > 0)) {
            continue;
        }
        decode(format.type, before.texel(k), values);
        for (std::size_t c = 0; c < values.size(); ++c) {
            const bool isOpacity = format.alpha == c;
            const float target =
                isOpacity ? 1.0F : lands[static_cast<int>(std::min<std::size_t>(c, 2))];
            values[c] = lands.a < 1 ? values[c] + lands.a * (target - values[c]) : target;
        }
        if (texels.empty()) {
            texels.reserve(level.texelCount() * bytes);
            for (std::uint32_t t = 0; t < level.texelCount(); ++t) {
                const auto texel = before.texel(t);
                texels.insert(texels.end(), texel.begin(), texel.end());
            }
        }
        encode(format.type, values, std::span(texels).subspan(k * bytes, bytes));
    }
    return texels;
}

} // namespace

glm::vec4 projectedAt(const PictureProjection& picture, glm::dvec3 point)
{
    const glm::dvec4 clip = picture.toClip * glm::dvec4(point, 1);
    if (!(clip.w > 0)) {
        return glm::vec4(0);
    }
    const double across = 0.5 * (clip.x / clip.w + 1);
    const double down = 0.5 * (1 - clip.y / clip.w);
    if (!(across >= 0 && across <= 1 && down >= 0 && down <= 1)) {
        return glm::vec4(0);
    }
    const double s = across * picture.width - 0.5;
    const double t = down * picture.height - 0.5;
    const int x = static_cast<int>(std::floor(s));
    const int y = static_cast<int>(std::floor(t));
    const auto right = static_cast<float>(s - x);
    const auto lower = static_cast<float>(t - y);
    const glm::vec4 upperRow =
        weighed(picture, x, y) * (1 - right) + weighed(picture, x + 1, y) * right;
    const glm::vec4 lowerRow =
        weighed(picture, x, y + 1) * (1 - right) + weighed(picture, x + 1, y + 1) * right;
    const glm::vec4 mixed = upperRow * (1 - lower) + lowerRow * lower;
    return mixed.a > 0 ? glm::vec4(glm::vec3(mixed) / mixed.a, mixed.a * picture.opacity)
                       : glm::vec4(0);
}

TexelPatch projectPicture(TexelStore& store,
                          const TriangleMesh& mesh,
                          std::span<const FaceId> faces,
                          const PictureProjection& picture,
                          Threads threads)
{
    const auto pixels =
        static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    check(picture.width > 0 && picture.height > 0 && picture.pixels.size() == 4 * pixels,
          "as many pixels as the picture has");
    check(store.faceCount() == mesh.faceCount(), "a store of the mesh's faces");
    const TexelFormat& format = store.format();
    std::vector<std::vector<std::byte>> made(faces.size());
    parallelFor(faces.size(), 4, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            made[k] = painted(store.face(faces[k]), format, mesh.corners(faces[k]), picture);
        }
    });
    TexelPatch patch;
    for (std::size_t k = 0; k < faces.size(); ++k) {
        if (made[k].empty()) {
            continue;
        }
        const FaceTexels& before = store.face(faces[k]);
        const FaceTexels after = FaceTexels::full(before.level(), format.texelBytes(), made[k]);
        if (!(after == before)) {
            patch.addFace(faces[k], store.exchange(faces[k], after.collapsed()));
        }
    }
    return patch;
}

} // namespace trixel
