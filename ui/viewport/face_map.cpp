// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/face_map.h"

#include "core/base/parallel.h"
#include "core/texture/face_figures.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace trixel::ui {

namespace {

constexpr std::size_t kGrain = 4096;
constexpr render::Rgb kInNoView{112, 112, 112};

float numberOf(const FaceMapWork& work, FaceId face)
{
    const Level level = work.texels.face(face).level();
    switch (work.map) {
    case ViewMapKind::Level:
        return static_cast<float>(level.log2());
    case ViewMapKind::Density:
        return densityOf(work.surface->mesh(), face, level);
    case ViewMapKind::Difference:
        return (*work.differences.rms)[face];
    default:
        return (*work.errors.rms)[face];
    }
}

/// Of the numbers that are finite and above 0, which a face without extent has none of.
MapScale scaleOf(const FaceMapWork& work, std::span<const float> values)
{
    if (work.map == ViewMapKind::Fit) {
        return MapScale::about(work.errors.tolerance);
    }
    if (work.map == ViewMapKind::Difference) {
        return MapScale::of(work.map);
    }
    if (work.map == ViewMapKind::Level) {
        const auto [low, high] = std::ranges::minmax_element(values);
        return values.empty() ? MapScale::ofLevels(0, 0)
                              : MapScale::ofLevels(static_cast<int>(*low), static_cast<int>(*high));
    }
    float low = std::numeric_limits<float>::infinity();
    float high = 0;
    for (const float value : values) {
        if (value > 0 && std::isfinite(value)) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    return high > 0 ? MapScale::ofDensities(double{low}, double{high})
                    : MapScale::ofDensities(1, 1);
}

std::uint32_t colorOf(const FaceMapWork& work, const MapScale& scale, float value)
{
    const bool isUnseen = work.map == ViewMapKind::Fit && std::isnan(value);
    const render::Rgb color = isUnseen ? kInNoView : scale.color(double{value});
    return std::bit_cast<std::uint32_t>(
        std::array<std::uint8_t, 4>{color[0], color[1], color[2], 255});
}

} // namespace

bool isOfFaces(ViewMapKind map)
{
    return map == ViewMapKind::Level || map == ViewMapKind::Density || map == ViewMapKind::Fit ||
           map == ViewMapKind::Difference;
}

FaceNumbers computeFaceMap(const FaceMapWork& work)
{
    const std::size_t faceCount = work.texels.faceCount();
    std::vector<float> values(faceCount);
    parallelFor(faceCount, kGrain, Threads::all(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            values[k] = numberOf(work, faceId(k));
        }
    });
    const MapScale scale = scaleOf(work, values);
    std::vector<std::uint32_t> colors(faceCount);
    parallelFor(faceCount, kGrain, Threads::all(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            colors[k] = colorOf(work, scale, values[k]);
        }
    });
    return {std::move(values), std::move(colors), scale};
}

} // namespace trixel::ui
