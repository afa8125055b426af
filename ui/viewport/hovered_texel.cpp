// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/hovered_texel.h"

#include "core/texture/mips.h"
#include "core/texture/reduced_texel.h"

#include <algorithm>
#include <cmath>

namespace trixel::ui {

namespace {

/// Up to here the texels below one are fewer than a glance costs; from here on it is cheaper to
/// reduce the face once.
constexpr int kFewLevels = 6;
/// Texels of a face that are reduced here and now.
constexpr std::uint32_t kFewTexels = 1U << 14U;

bool isConstantOrNear(const FaceTexels& texels, int levelsDropped)
{
    return texels.isConstant() || levelsDropped <= kFewLevels;
}

} // namespace

bool ShownTexels::has(const TexelStore& store, FaceId face, int levelsDropped) const
{
    const FaceTexels& texels = store.face(face);
    return keeps(face, levelsDropped) ||
           (texels.isLoaded() &&
            (isConstantOrNear(texels, levelsDropped) || texels.level().texelCount() <= kFewTexels));
}

std::optional<ShownTexels::Reduced> ShownTexels::prepare(const TexelFormat& format,
                                                         FaceId face,
                                                         const FaceTexels& texels,
                                                         int levelsDropped)
{
    (void)texels.bytes();
    return isConstantOrNear(texels, levelsDropped)
               ? std::nullopt
               : std::optional(
                     Reduced{face, levelsDropped, reduced(format, texels, levelsDropped)});
}

std::vector<float>
ShownTexels::values(const TexelStore& store, FaceId face, int levelsDropped, TexelIndex index)
{
    std::vector<float> result(store.format().channels);
    decode(store.format().type, stored(store, face, levelsDropped, index), result);
    return result;
}

std::vector<std::byte>
ShownTexels::stored(const TexelStore& store, FaceId face, int levelsDropped, TexelIndex index)
{
    const TexelFormat& format = store.format();
    const FaceTexels& texels = store.face(face);
    std::vector<std::byte> result(format.texelBytes());
    if (isConstantOrNear(texels, levelsDropped)) {
        reducedTexel(format, texels, levelsDropped, index, result);
        return result;
    }
    if (!keeps(face, levelsDropped)) {
        keep({face, levelsDropped, reduced(format, texels, levelsDropped)});
    }
    std::ranges::copy(m_reduced->texels.texel(indexOf(index)), result.begin());
    return result;
}

HoveredTexel describeTexel(const Surface& surface,
                           const TexelStore& store,
                           ShownTexels& shown,
                           const SurfacePoint& point,
                           int levelsDropped)
{
    const WalkedSurface walked{surface.adjacency(), store, levelsDropped};
    const Level level = walked.level(point.face);
    const glm::dvec2 uv(point.uv);
    const TexelPlace place{point.face, texelAt(level, uv)};
    HoveredTexel hovered;
    hovered.point = point;
    hovered.report =
        shown.has(store, point.face, levelsDropped)
            ? describe(
                  walked,
                  place,
                  uv,
                  shown.stored(store, point.face, levelsDropped, texelIndex(level, place.texel)))
            : describePlace(walked, place, uv);
    hovered.report.position = point.position;
    if (const std::uint32_t source = surface.mesh().sourceFace(point.face);
        source != indexOf(point.face)) {
        hovered.report.polygon = source;
    }
    hovered.level = level;
    hovered.texel = place.texel;
    hovered.index = hovered.report.index;
    hovered.pixel = hovered.report.pixel;
    hovered.values = hovered.report.values;
    return hovered;
}

TexelDisplay
displayOf(const TexelFormat& format, std::span<const float> values, const render::Look& look)
{
    const float gain = std::exp2(look.exposure);
    TexelDisplay display;
    display.values.reserve(values.size());
    for (const float value : values) {
        display.values.push_back((value * gain - look.low) / (look.high - look.low));
    }
    display.color = render::shade(format, values, look);
    return display;
}

void addFootprint(HoveredTexel& texel, const std::array<glm::vec3, 3>& corners, const PixelRay& ray)
{
    texel.hasFootprint = true;
    texel.footprint = screenFootprint(ray, corners);
    texel.ellipse = ellipseOf(texel.footprint, corners);
}

} // namespace trixel::ui
