// SPDX-License-Identifier: GPL-3.0-or-later
//
// Looking up an image between its pixels, in linear light.
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/footprint/footprint.h"
#include "core/image/image.h"

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace trixel {

/// How values between pixels come about.
enum class ImageLookup : std::uint8_t {
    Nearest,  ///< the pixel that the point lies in
    Bilinear, ///< between four pixels, whatever the footprint
    Mip,      ///< between four pixels each of the two halvings that fit the footprint's longer side
    Footprint ///< the Gaussian of the footprint's own area, however long and narrow
};

/// Which point of the image (s,t) = (0,0) and (1,1) are; n pixels in a row.
enum class TableIndex : std::uint8_t {
    Centres, ///< the image's corners, as GPUs have it: pixel centres at s n - 1/2
    Corners  ///< the centres of its corner pixels, as textbooks have it: pixels at s (n - 1)
};

enum class ImageWrap : std::uint8_t { Clamp, Repeat };

struct SamplerOptions
{
    ImageLookup lookup = ImageLookup::Footprint;
    TableIndex index = TableIndex::Centres;
    ImageWrap wrapS = ImageWrap::Clamp;
    ImageWrap wrapT = ImageWrap::Clamp;
};

/// Longest side of a footprint over its shorter one that is filtered as it is; beyond, the shorter
/// is widened.
inline constexpr double kMostSamplerAnisotropy = 32;

/// Three channels of an image, and its opacity. Const calls may come from several threads.
///
/// Lookups of a point (s,t), s to the right and t upwards over the image's unit square, answer the
/// channels in linear light times the opacity, and the opacity (1 where the image has none).
class ImageSampler
{
public:
    /// \param channels  of the image, for the first three numbers (checked)
    ImageSampler(Image image,
                 const std::array<std::uint16_t, 3>& channels,
                 const SamplerOptions& options,
                 Threads threads);

    /// The same for long work: large images take seconds and memory. Fails when cancelled and when
    /// the image does not fit into memory.
    static Result<ImageSampler> make(Image image,
                                     const std::array<std::uint16_t, 3>& channels,
                                     const SamplerOptions& options,
                                     Threads threads,
                                     Progress& progress);

    /// \param footprint  in (s,t): W1 and W2 to the next texels along two edges of a texel, whose
    ///                   third edge is W1 - W2
    glm::vec4 at(glm::dvec2 st, const Footprint& footprint) const;

    int width() const { return m_levels.front().width; }
    int height() const { return m_levels.front().height; }
    std::size_t memoryBytes() const;

private:
    struct LevelPixels
    {
        int width = 0, height = 0;
        std::vector<glm::vec4> pixels; ///< empty for the first of an image of bytes
    };
    /// A symmetric matrix, square pixels.
    struct Moments
    {
        double xx = 0, xy = 0, yy = 0;
    };

    ImageSampler(const std::array<std::uint16_t, 3>& channels, const SamplerOptions& options);
    // False when cancelled.
    bool build(Image image, Threads threads, Progress& progress);
    bool fillLevel(const Image& image, Threads threads, Progress& progress);
    bool halve(Threads threads, Progress& progress);

    /// Position in pixels of a level, pixel centres at whole numbers.
    glm::dvec2 position(glm::dvec2 st, std::size_t level) const;
    Moments moments(const Footprint& footprint) const;
    glm::vec4 pixel(const LevelPixels& level, std::int64_t x, std::int64_t y) const;
    glm::vec4 nearest(glm::dvec2 st) const;
    glm::vec4 bilinear(glm::dvec2 st, std::size_t level) const;
    glm::vec4 trilinear(glm::dvec2 st, const Moments& moments) const;
    glm::vec4 gaussian(glm::dvec2 st, const Moments& moments) const;

    SamplerOptions m_options;
    std::vector<LevelPixels> m_levels;
    /// An image of bytes keeps them as they are for its first level, and what they mean beside.
    Image m_bytes;
    std::array<std::uint16_t, 3> m_channels{};
    std::array<std::array<float, 256>, 3> m_light{};
};

} // namespace trixel
