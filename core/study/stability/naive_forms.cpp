// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/stability/naive_forms.h"

#include "core/footprint/screen_derivatives.h"

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace trixel::naive {

namespace {

double cross(glm::dvec2 a, glm::dvec2 b)
{
    return a.x * b.y - a.y * b.x;
}

template <class Number>
TexelCoord texelOf(Number x, Number y)
{
    const Number i = std::floor(x);
    const Number j = std::floor(y);
    const TexelHalf half = (x - i) + (y - j) <= 1 ? TexelHalf::Lower : TexelHalf::Upper;
    const auto narrow = [](Number n) {
        // Wraps, as indices do; what is no number or no index at all becomes the last.
        const bool isIndex = n > Number(-1e9) && n < Number(1e9);
        return static_cast<std::uint16_t>(isIndex ? static_cast<std::int64_t>(n) : -1);
    };
    return {narrow(i), narrow(j), half};
}

struct RowSums
{
    double value = 0;
    double weight = 0;
};

constexpr int kNoNaN = 1000;

/// 128 texels about the middle between two of them.
RowSums rowSums(float value, float sigma, int nanAt)
{
    constexpr int kReach = 64;
    RowSums sums;
    for (int k = -kReach; k < kReach; ++k) {
        const float distance = static_cast<float>(k) + 0.5F;
        const float weight = std::exp(-distance * distance / (2 * sigma * sigma));
        sums.weight += static_cast<double>(weight);
        sums.value += static_cast<double>(
            weight * (k == nanAt ? std::numeric_limits<float>::quiet_NaN() : value));
    }
    return sums;
}

} // namespace

Covariance covarianceOf(glm::dvec2 half1, glm::dvec2 half2, double floor)
{
    Covariance c{half1.x * half1.x + half2.x * half2.x + floor,
                 half1.x * half1.y + half2.x * half2.y,
                 half1.y * half1.y + half2.y * half2.y + floor,
                 0};
    c.determinant = c.xx * c.yy - c.xy * c.xy;
    return c;
}

CovarianceAxes minorBySubtraction(const Covariance& c)
{
    const double trace = c.xx + c.yy;
    const double root = std::sqrt(trace * trace - 4 * c.determinant);
    return {std::sqrt((trace + root) / 2), std::sqrt((trace - root) / 2), {1, 0}};
}

CovarianceAxes directionByOneForm(const Covariance& c)
{
    const double trace = c.xx + c.yy;
    const double root = std::sqrt((c.xx - c.yy) * (c.xx - c.yy) + 4 * c.xy * c.xy);
    const double major = (trace + root) / 2;
    return {std::sqrt(major),
            std::sqrt(c.determinant / major),
            glm::normalize(glm::dvec2(c.xy, major - c.xx))};
}

CovarianceAxes singlePrecisionAxes(glm::vec2 w1, glm::vec2 w2)
{
    const float xx = (w1.x * w1.x + w2.x * w2.x) / 4;
    const float xy = (w1.x * w1.y + w2.x * w2.y) / 4;
    const float yy = (w1.y * w1.y + w2.y * w2.y) / 4;
    const float trace = xx + yy;
    const float root = std::sqrt(trace * trace - 4 * (xx * yy - xy * xy));
    return {std::sqrt((trace + root) / 2), std::sqrt((trace - root) / 2), {1, 0}};
}

std::optional<Footprint> footprintOf(const ProjectedFace& face, glm::dvec2 uv)
{
    return inverseJacobian(screenDerivatives(face, uv));
}

Footprint
sphereDifferences(const glm::dvec3& direction, const glm::dvec3& perA, const glm::dvec3& perB)
{
    const glm::dvec2 here = trixel::sphereUv(direction);
    return {trixel::sphereUv(direction + perA) - here, trixel::sphereUv(direction + perB) - here};
}

glm::dvec2 sphereUv(const glm::dvec3& d)
{
    const double s = std::atan(d.z / d.x) / (std::numbers::pi / 2);
    const double t = std::atan(d.y / d.x) / (std::numbers::pi / 2);
    return {d.x >= 0 ? (1 + s) / 4 : 0.5 + (1 - s) / 4, (t + 1) / 2};
}

Footprint sphereFootprint(const glm::dvec3& d, const glm::dvec3& perA, const glm::dvec3& perB)
{
    const double axis = d.x * d.x + d.z * d.z;
    const double squared = axis + d.y * d.y;
    const auto derivative = [&](const glm::dvec3& c) {
        const double around = (d.x * c.z - d.z * c.x) / axis;
        const double up =
            (axis * c.y - d.y * (d.x * c.x + d.z * c.z)) / (std::sqrt(axis) * squared);
        return glm::dvec2(around / (2 * std::numbers::pi), up / std::numbers::pi);
    };
    return {derivative(perA), derivative(perB)};
}

std::optional<glm::dvec2> inverseBilinear(const Quad& quad, glm::dvec2 point)
{
    const glm::dvec2 b = quad.p10 - quad.p00;
    const glm::dvec2 c = quad.p01 - quad.p00;
    const glm::dvec2 d = quad.p11 - quad.p01 - quad.p10 + quad.p00;
    const glm::dvec2 h = point - quad.p00;
    const double a2 = cross(c, d);
    const double a1 = cross(c, b) - cross(h, d);
    const double a0 = -cross(h, b);
    const double v = (-a1 - std::sqrt(a1 * a1 - 4 * a2 * a0)) / (2 * a2);
    const double u = (h.x - v * c.x) / (b.x + v * d.x);
    return glm::dvec2(u, v);
}

TexelCoord texelInAtlas(Level level, glm::dvec2 uv)
{
    const auto resolution = static_cast<float>(level.resolution());
    const float x = kAtlasOrigin + static_cast<float>(uv.x) * resolution;
    const float y = kAtlasOrigin + static_cast<float>(uv.y) * resolution;
    return texelOf(x - kAtlasOrigin, y - kAtlasOrigin);
}

TexelCoord unclampedTexelAt(Level level, glm::dvec2 uv)
{
    return texelOf(uv.x * level.resolution(), uv.y * level.resolution());
}

FaceShape faceShapeOf(const std::array<glm::vec3, 3>& corners)
{
    const glm::dvec3 e1 = glm::dvec3(corners[1]) - glm::dvec3(corners[0]);
    const glm::dvec3 e2 = glm::dvec3(corners[2]) - glm::dvec3(corners[0]);
    const double length = glm::length(e1);
    return {{length, 0}, {glm::dot(e1, e2) / length, glm::length(glm::cross(e1, e2)) / length}};
}

void gaussianWeights(glm::dvec2 start, glm::dvec2 step, double offset, std::span<double> weights)
{
    const auto squared = static_cast<float>(glm::dot(step, step));
    auto weight = static_cast<float>(std::exp((offset - glm::dot(start, start)) / 2));
    auto ratio = static_cast<float>(std::exp(-(glm::dot(start, step) + squared / 2)));
    const float change = std::exp(-squared);
    for (double& w : weights) {
        w = static_cast<double>(weight);
        weight *= ratio;
        ratio *= change;
    }
}

float rowAverage(float value, float sigma)
{
    const RowSums sums = rowSums(value, sigma, kNoNaN);
    return static_cast<float>(sums.value / sums.weight);
}

float rowAverageUnnormalised(float value, float sigma)
{
    const double whole = static_cast<double>(sigma) * std::sqrt(2 * std::numbers::pi);
    return static_cast<float>(rowSums(value, sigma, kNoNaN).value / whole);
}

float rowAverageWithNaN(int distance, float sigma)
{
    const RowSums sums = rowSums(1, sigma, distance);
    return static_cast<float>(sums.value / sums.weight);
}

float proceduralNoise(float x, float y, bool fused)
{
    const float angle = fused ? std::fma(x, 12.9898F, y * 78.233F) : x * 12.9898F + y * 78.233F;
    const float large = 43758.5453F * std::sin(angle);
    return large - std::floor(large);
}

} // namespace trixel::naive
