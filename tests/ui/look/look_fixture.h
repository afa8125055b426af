// SPDX-License-Identifier: GPL-3.0-or-later
//
// A square whose texels have all that a look can show.
#pragma once

#include <QCoreApplication>

#include "tests/ui/fixtures.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace trixel::ui {

inline constexpr int kWildLevel = 3;

/// Float RGB and opacity on 2 · cells² faces: red runs from 0 to 2 over each face, green is 0.5,
/// blue 0.25; some texels hold what no colour shows.
inline Project wildProject(int cells = 2)
{
    NoProgress progress;
    const TexelFormat format{TexelType::Float, 4, std::uint16_t{3}};
    Project project;
    project.surface = Surface::build(gridMesh(cells), progress).value();
    const Level level(kWildLevel);
    const auto faces = static_cast<std::uint32_t>(project.surface->mesh().faceCount());
    const std::vector<float> grey{0.5F, 0.5F, 0.25F, 1};
    project.texels = TexelStore(faces, format, level, std::as_bytes(std::span(grey)));
    for (std::uint32_t f = 0; f < faces; ++f) {
        std::vector<float> values;
        for (std::uint32_t t = 0; t < level.texelCount(); ++t) {
            const float red = 2 * static_cast<float>(t) / static_cast<float>(level.texelCount());
            values.insert(values.end(), {red, 0.5F, 0.25F, 1});
        }
        project.texels.exchange(
            faceId(f),
            FaceTexels::full(level, format.texelBytes(), std::as_bytes(std::span(values))));
    }
    const auto set = [&](std::uint32_t face, std::size_t texel, std::size_t channel, float value) {
        std::span<std::byte> bytes = project.texels.writable(FaceId{face});
        std::memcpy(&bytes[(texel * 4 + channel) * sizeof value], &value, sizeof value);
    };
    set(1, 10, 0, std::nanf(""));
    set(5, 3, 2, std::nanf(""));
    set(2, 20, 1, std::numeric_limits<float>::infinity());
    set(3, 30, 1, -0.5F);
    return project;
}

} // namespace trixel::ui
