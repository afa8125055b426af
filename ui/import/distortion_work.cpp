// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/distortion_work.h"

#include "ui/import/distortion_scale.h"

#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace trixel::ui {

namespace {

/// Where the image does not reach: of no colour of the scale, and quiet.
constexpr std::array<std::uint8_t, 4> kUnreached = {0x6a, 0x6a, 0x6e, 0xff};

double areaOf(const std::array<glm::vec3, 3>& corners)
{
    return 0.5 * glm::length(glm::cross(glm::dvec3(corners[1] - corners[0]),
                                        glm::dvec3(corners[2] - corners[0])));
}

double numberOf(DistortionMeasure measure, const MapStretch& stretch, double area, Level level)
{
    if (measure == DistortionMeasure::Stretch) {
        return double{stretch.anisotropy()};
    }
    return std::sqrt(level.texelCount() / (area * double{stretch.density()}));
}

std::uint32_t colorOf(DistortionMeasure measure, double number)
{
    if (std::isnan(number)) {
        return std::bit_cast<std::uint32_t>(kUnreached);
    }
    const render::Rgb color = distortionScale(measure).color(number);
    return std::bit_cast<std::uint32_t>(
        std::array<std::uint8_t, 4>{color[0], color[1], color[2], 255});
}

} // namespace

Result<DistortionColors> distortionColors(const ImportInput& input, DistortionMeasure measure)
{
    auto mapping = makeImportMapping(input.settings, input.project.surface);
    if (!mapping) {
        return tl::unexpected(mapping.error());
    }
    const TriangleMesh& mesh = input.project.surface->mesh();
    const Image& image = input.images->first();
    DistortionColors made{
        std::move(*mapping), input.project.texels, {image.width(), image.height()}, measure, {}};
    const auto stretch = cornerStretch(*made.mapping.mapping, mesh, made.imageSize, Threads::all());
    made.colors.resize(stretch.size());
    for (std::size_t k = 0; k < stretch.size(); ++k) {
        const FaceId face = faceId(k / 3);
        const double number = numberOf(measure,
                                       stretch[k],
                                       areaOf(mesh.corners(face)),
                                       input.project.texels.face(face).level());
        made.colors[k] = colorOf(measure, number);
    }
    return made;
}

double distortionAt(const DistortionColors& of, FaceId face, glm::dvec2 uv)
{
    const TriangleMesh& mesh = of.mapping.surface->mesh();
    const MapStretch stretch = stretchAt(*of.mapping.mapping, mesh, face, uv, of.imageSize);
    return numberOf(of.measure, stretch, areaOf(mesh.corners(face)), of.texels.face(face).level());
}

} // namespace trixel::ui
