// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the ways of filtering on the card fare in one view: time, and error against `exact`.
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/filter/filter_scene.h"
#include "core/mesh/surface.h"
#include "core/study/views/view_queries.h"
#include "render/renderer.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace trixel::render {

inline constexpr std::array<Filtering, 5> kFilterings{Filtering::Texels,
                                                      Filtering::LowerHalf,
                                                      Filtering::PackedAtlas,
                                                      Filtering::Seamless,
                                                      Filtering::Anisotropic};

/// A picture as numbers: four a pixel, rows from the top.
struct DrawnPicture
{
    int width = 0;
    int height = 0;
    std::vector<float> values;

    const float* pixel(std::uint32_t index) const { return values.data() + 4 * std::size_t{index}; }
};

/// Draws into a picture of floats of the camera's size and reads it back. The scene's way of
/// filtering must be ready (`prepareFilterings`).
DrawnPicture drawNumbers(Gl& gl, Renderer& renderer, const Scene& scene);

/// Draws so many frames of the camera's size and waits for each. \return milliseconds of the card's
/// own clock, the median; nothing where it has none. By our clock where the processor draws.
std::optional<double> cardTime(Gl& gl, Renderer& renderer, const Scene& scene, int frames);

/// Sends texels and everything that the ways of filtering need, and waits until all is there.
void prepareFilterings(Renderer& renderer,
                       const TexelStore& store,
                       std::span<const Filtering> filterings = kFilterings);

/// What `exact` answers for pixels of a view.
struct ExactPicture
{
    ViewQueries queries;
    /// Three a query: the channels that the usual look shows, in [0, 1].
    std::vector<float> colors;
};

/// \param scene  of the surface. Fails only when cancelled.
Result<ExactPicture> exactPicture(const Surface& surface,
                                  const FilterScene& scene,
                                  const TexelFormat& format,
                                  const Camera& camera,
                                  PixelSubset subset,
                                  Threads threads,
                                  Progress& progress);

/// Over the pixels of the exact picture and its three channels, in parts of the value range [0, 1].
struct PictureDifference
{
    double rms = 0;
    double p99 = 0; ///< 99th percentile of |error|
    double worst = 0;
    std::size_t pixels = 0;
};
PictureDifference differenceOf(const DrawnPicture& drawn, const ExactPicture& exact);

} // namespace trixel::render
