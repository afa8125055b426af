// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mapping/distortion.h"

#include "core/footprint/svd2.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

namespace trixel {

namespace {

/// Change of (u,v) for a world unit along two directions of the face's plane that stand upright on
/// each other.
struct PlaneStep
{
    glm::dvec2 along{0};
    glm::dvec2 across{0};
};

std::optional<PlaneStep> planeStep(const std::array<glm::vec3, 3>& corners)
{
    const glm::dvec3 e1 = glm::dvec3(corners[1]) - glm::dvec3(corners[0]);
    const glm::dvec3 e2 = glm::dvec3(corners[2]) - glm::dvec3(corners[0]);
    const double length = glm::length(e1);
    const double area = glm::length(glm::cross(e1, e2));
    constexpr double kFlattest = 1e-12;
    if (!(area > kFlattest * length * glm::length(e2))) {
        return std::nullopt;
    }
    // In the plane e1 = (length, 0), e2 = (foot, height).
    const double height = area / length;
    const double foot = glm::dot(e1, e2) / length;
    return PlaneStep{{1 / length, 0}, {-foot / (length * height), 1 / height}};
}

constexpr MapStretch kNone{std::numeric_limits<float>::quiet_NaN(),
                           std::numeric_limits<float>::quiet_NaN()};

} // namespace

MapStretch stretchAt(const Mapping& mapping,
                     const TriangleMesh& mesh,
                     FaceId face,
                     glm::dvec2 uv,
                     glm::dvec2 imageSize)
{
    const auto step = planeStep(mesh.corners(face));
    // As a texel of a fine level sees it: what limits footprints to a period is far away then.
    constexpr double kFine = 1.0 / 4096;
    const ImagePlace place = step ? mapping.at(face, uv, kFine) : ImagePlace{};
    if (!place.lands) {
        return kNone;
    }
    const glm::dvec2 perU = imageSize * place.footprint.w1 / kFine;
    const glm::dvec2 perV = imageSize * place.footprint.w2 / kFine;
    const Svd2 svd = svd2(step->along.x * perU + step->along.y * perV,
                          step->across.x * perU + step->across.y * perV);
    return {static_cast<float>(svd.major), static_cast<float>(svd.minor)};
}

std::vector<MapStretch> cornerStretch(const Mapping& mapping,
                                      const TriangleMesh& mesh,
                                      glm::dvec2 imageSize,
                                      Threads threads)
{
    constexpr double kIn = 0.01;
    constexpr std::array<glm::dvec2, 3> kCorners = {
        glm::dvec2(kIn / 3, kIn / 3), {1 - 2 * kIn / 3, kIn / 3}, {kIn / 3, 1 - 2 * kIn / 3}};
    std::vector<MapStretch> stretch(3 * mesh.faceCount());
    parallelFor(mesh.faceCount(), 1024, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = 3 * begin; k < 3 * end; ++k) {
            stretch[k] = stretchAt(mapping, mesh, faceId(k / 3), kCorners[k % 3], imageSize);
        }
    });
    return stretch;
}

float medianDensity(const std::vector<MapStretch>& stretch)
{
    std::vector<float> densities;
    for (const MapStretch& one : stretch) {
        if (std::isfinite(one.density())) {
            densities.push_back(one.density());
        }
    }
    if (densities.empty()) {
        return std::numeric_limits<float>::quiet_NaN();
    }
    const auto middle = densities.begin() + static_cast<std::ptrdiff_t>(densities.size() / 2);
    std::nth_element(densities.begin(), middle, densities.end());
    return *middle;
}

} // namespace trixel
