// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lattice/texel.h"

#include "core/base/check.h"

namespace trixel {

namespace {

std::uint16_t narrow(std::uint32_t value)
{
    return static_cast<std::uint16_t>(value);
}

} // namespace

bool isValid(Level level, TexelCoord texel)
{
    const std::uint32_t sum = std::uint32_t{texel.i} + texel.j;
    return sum + (texel.half == TexelHalf::Upper ? 1U : 0U) < level.resolution();
}

PackedPixel packedPixel(Level level, TexelCoord texel)
{
    check(isValid(level, texel), "texel inside the face");
    if (texel.half == TexelHalf::Lower) {
        return {texel.i, texel.j};
    }
    const std::uint32_t last = level.resolution() - 1;
    return {narrow(last - texel.j), narrow(last - texel.i)};
}

TexelCoord texelAt(Level level, PackedPixel pixel)
{
    const std::uint32_t last = level.resolution() - 1;
    check(pixel.x <= last && pixel.y <= last, "pixel inside the packed square");
    if (std::uint32_t{pixel.x} + pixel.y <= last) {
        return {pixel.x, pixel.y, TexelHalf::Lower};
    }
    return {narrow(last - pixel.y), narrow(last - pixel.x), TexelHalf::Upper};
}

TexelIndex texelIndex(Level level, PackedPixel pixel)
{
    return static_cast<TexelIndex>(pixel.x + pixel.y * level.resolution());
}

TexelIndex texelIndex(Level level, TexelCoord texel)
{
    return texelIndex(level, packedPixel(level, texel));
}

PackedPixel packedPixel(Level level, TexelIndex index)
{
    check(indexOf(index) < level.texelCount(), "texel index inside the face");
    const auto linear = static_cast<std::uint32_t>(index);
    return {narrow(linear & (level.resolution() - 1)),
            narrow(linear >> static_cast<unsigned>(level.log2()))};
}

TexelCoord texelAt(Level level, TexelIndex index)
{
    return texelAt(level, packedPixel(level, index));
}

glm::dvec2 centroid(Level level, TexelCoord texel)
{
    const double third = texel.half == TexelHalf::Lower ? 1.0 / 3.0 : 2.0 / 3.0;
    return glm::dvec2(texel.i + third, texel.j + third) / static_cast<double>(level.resolution());
}

std::array<glm::dvec2, 3> corners(Level level, TexelCoord texel)
{
    const double scale = 1.0 / level.resolution();
    const glm::dvec2 origin(texel.i, texel.j);
    if (texel.half == TexelHalf::Lower) {
        return {origin * scale,
                (origin + glm::dvec2(1, 0)) * scale,
                (origin + glm::dvec2(0, 1)) * scale};
    }
    return {(origin + glm::dvec2(1, 1)) * scale,
            (origin + glm::dvec2(0, 1)) * scale,
            (origin + glm::dvec2(1, 0)) * scale};
}

} // namespace trixel
