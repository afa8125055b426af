// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/views/view_map.h"

#include "core/footprint/ellipse_report.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace trixel {

namespace {

float conditionOf(const FilterQueries& queries,
                  std::size_t i,
                  const std::array<glm::vec3, 3>& flatFace)
{
    const Footprint footprint{{queries.uw1[i], queries.vw1[i]}, {queries.uw2[i], queries.vw2[i]}};
    return static_cast<float>(describe(footprint, flatFace, Level(0)).condition);
}

constexpr std::size_t kGrain = 256; // queries

} // namespace

void footprintConditions(const Surface& surface,
                         const FilterQueries& queries,
                         Threads threads,
                         std::span<float> conditions)
{
    check(conditions.size() == queries.size(), "room for every condition");
    parallelFor(queries.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            conditions[i] = conditionOf(queries, i, surface.mesh().corners(queries.face[i]));
        }
    });
}

void footprintConditions(const LimitSurface& limit,
                         const FilterQueries& queries,
                         Threads threads,
                         std::span<float> conditions)
{
    check(conditions.size() == queries.size(), "room for every condition");
    parallelFor(queries.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
        LimitSurface::Evaluator evaluator(limit);
        for (std::size_t i = begin; i < end; ++i) {
            const glm::dvec2 uv(queries.u[i], queries.v[i]);
            evaluator.moveTo(queries.face[i]);
            conditions[i] = conditionOf(queries, i, evaluator.at(uv).tangentFace(uv));
        }
    });
}

float differenceOf(std::span<const float> values, std::span<const float> reference, double range)
{
    check(values.size() == reference.size(), "the same channels");
    double largest = 0;
    for (std::size_t c = 0; c < values.size(); ++c) {
        const double a = values[c];
        const double b = reference[c];
        if (std::isnan(a) != std::isnan(b)) {
            return std::numeric_limits<float>::infinity();
        }
        if (a != b && !std::isnan(a)) { // equal infinities do not differ
            largest = std::max(largest, std::abs(a - b));
        }
    }
    return static_cast<float>(range > 0 ? largest / range : 0);
}

void filterDifferences(const FilterScene& scene,
                       const FilterMethod& method,
                       const FilterMethod& reference,
                       double range,
                       const FilterQueries& queries,
                       Threads threads,
                       std::span<float> errors)
{
    check(errors.size() == queries.size(), "room for every error");
    const auto channels = static_cast<std::size_t>(scene.channels());
    ResultArrays own(queries.size(), scene.channels());
    ResultArrays exact(queries.size(), scene.channels());
    filterParallel(method, scene, queries, own.results(), threads);
    filterParallel(reference, scene, queries, exact.results(), threads);
    std::vector<float> a(channels);
    std::vector<float> b(channels);
    for (std::size_t i = 0; i < queries.size(); ++i) {
        for (std::size_t c = 0; c < channels; ++c) {
            a[c] = own.values[c * queries.size() + i];
            b[c] = exact.values[c * queries.size() + i];
        }
        const bool refused = own.taps[i] == kRefusedTaps || exact.taps[i] == kRefusedTaps;
        errors[i] = refused ? std::numeric_limits<float>::quiet_NaN() : differenceOf(a, b, range);
    }
}

} // namespace trixel
