// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/image_sampler.h"

#include "core/base/check.h"
#include "core/footprint/limit.h"
#include "core/mesh/shared_progress.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <new>
#include <utility>

namespace trixel {

namespace {

/// Variance of the tent that bilinear interpolation is, in square pixels.
constexpr double kTentVariance = 1.0 / 6;

std::int64_t wrapped(std::int64_t k, int size, ImageWrap wrap)
{
    if (k >= 0 && k < size) {
        return k;
    }
    if (wrap == ImageWrap::Clamp) {
        return k < 0 ? 0 : size - 1;
    }
    const std::int64_t rest = k % size;
    return rest < 0 ? rest + size : rest;
}

/// Calls work(begin, end) for a few rows at a time. False when cancelled, or when there is no
/// memory in a thread, where it must not be thrown; it is thrown here then.
bool forRows(int height,
             Threads threads,
             Progress& progress,
             const std::function<void(std::size_t begin, std::size_t end)>& work)
{
    constexpr std::size_t kRows = 8;
    const auto rows = static_cast<std::size_t>(height);
    const std::size_t bands = (rows + kRows - 1) / kRows;
    SharedProgress shared(progress, bands);
    std::atomic<bool> outOfMemory{false};
    parallelFor(bands, 1, threads, [&](std::size_t begin, std::size_t end) {
        try {
            for (std::size_t band = begin; band < end && shared.goesOn(); ++band) {
                work(band * kRows, std::min(rows, (band + 1) * kRows));
                shared.step();
            }
        } catch (const std::bad_alloc&) {
            outOfMemory = true;
        }
    });
    if (outOfMemory) {
        throw std::bad_alloc();
    }
    return shared.goesOn();
}

} // namespace

ImageSampler::ImageSampler(const std::array<std::uint16_t, 3>& channels,
                           const SamplerOptions& options)
    : m_options(options)
    , m_channels(channels)
{
}

ImageSampler::ImageSampler(Image image,
                           const std::array<std::uint16_t, 3>& channels,
                           const SamplerOptions& options,
                           Threads threads)
    : ImageSampler(channels, options)
{
    NoProgress progress;
    (void)build(std::move(image), threads, progress);
}

Result<ImageSampler> ImageSampler::make(Image image,
                                        const std::array<std::uint16_t, 3>& channels,
                                        const SamplerOptions& options,
                                        Threads threads,
                                        Progress& progress)
{
    try {
        ImageSampler sampler(channels, options);
        const bool isDone = sampler.build(std::move(image), threads, progress);
        return isDone ? Result<ImageSampler>(std::move(sampler)) : cancelled();
    } catch (const std::bad_alloc&) {
        return contentsError("the image does not fit into memory");
    }
}

bool ImageSampler::build(Image image, Threads threads, Progress& progress)
{
    check(!image.isEmpty(), "an image to look up");
    for (const std::uint16_t channel : m_channels) {
        check(channel < image.format().channels, "a channel of the image");
    }
    m_levels.push_back({image.width(), image.height(), {}});
    double done = 0;
    if (image.format().type == TexelType::UInt8) {
        for (std::size_t c = 0; c < 3; ++c) {
            for (std::size_t k = 0; k < 256; ++k) {
                m_light[c][k] =
                    toLinear(image.colors()[m_channels[c]], static_cast<float>(k) / 255.0F);
            }
        }
        m_bytes = std::move(image);
    } else {
        done = 0.6;
        StageProgress filling(progress, 0, done);
        if (!fillLevel(image, threads, filling)) {
            return false;
        }
    }
    const bool needsLevels =
        m_options.lookup == ImageLookup::Mip || m_options.lookup == ImageLookup::Footprint;
    while (needsLevels && (m_levels.back().width > 1 || m_levels.back().height > 1)) {
        // A quarter of the work of the one before.
        StageProgress halving(progress, done, done + 0.75 * (1 - done));
        done += 0.75 * (1 - done);
        if (!halve(threads, halving)) {
            return false;
        }
    }
    return progress.report(1);
}

bool ImageSampler::fillLevel(const Image& image, Threads threads, Progress& progress)
{
    LevelPixels& level = m_levels.front();
    const auto width = static_cast<std::size_t>(level.width);
    level.pixels.resize(width * static_cast<std::size_t>(level.height));
    const std::size_t count = image.format().channels;
    const auto& alpha = image.format().alpha;
    return forRows(level.height, threads, progress, [&](std::size_t begin, std::size_t end) {
        std::vector<float> row(width * count);
        for (std::size_t y = begin; y < end; ++y) {
            decode(image.format().type, image.row(static_cast<int>(y)), row);
            for (std::size_t x = 0; x < width; ++x) {
                const float* from = &row[x * count];
                const float opacity = alpha ? from[*alpha] : 1.0F;
                glm::vec4& to = level.pixels[y * width + x];
                to.a = opacity;
                for (int c = 0; c < 3; ++c) {
                    const auto channel = m_channels[static_cast<std::size_t>(c)];
                    to[c] = opacity * toLinear(image.colors()[channel], from[channel]);
                }
            }
        }
    });
}

bool ImageSampler::halve(Threads threads, Progress& progress)
{
    const LevelPixels& fine = m_levels.back();
    LevelPixels coarse{std::max(1, fine.width / 2), std::max(1, fine.height / 2), {}};
    const auto width = static_cast<std::size_t>(coarse.width);
    coarse.pixels.resize(width * static_cast<std::size_t>(coarse.height));
    // Areas of the finer level, as wide as they must be where a side is odd.
    const double across = static_cast<double>(fine.width) / coarse.width;
    const double down = static_cast<double>(fine.height) / coarse.height;
    const auto cover = [](std::size_t k, double size, std::int64_t at) {
        const double begin = static_cast<double>(k) * size;
        return static_cast<float>(std::clamp(std::min(begin + size, static_cast<double>(at) + 1) -
                                                 std::max(begin, static_cast<double>(at)),
                                             0.0,
                                             1.0) /
                                  size);
    };
    const bool isDone =
        forRows(coarse.height, threads, progress, [&](std::size_t begin, std::size_t end) {
            for (std::size_t y = begin; y < end; ++y) {
                const auto y0 = static_cast<std::int64_t>(static_cast<double>(y) * down);
                for (std::size_t x = 0; x < width; ++x) {
                    const auto x0 = static_cast<std::int64_t>(static_cast<double>(x) * across);
                    glm::vec4 sum(0);
                    for (std::int64_t j = y0; j < std::min<std::int64_t>(y0 + 3, fine.height);
                         ++j) {
                        const float inRow = cover(y, down, j);
                        for (std::int64_t i = x0; i < std::min<std::int64_t>(x0 + 3, fine.width);
                             ++i) {
                            sum += inRow * cover(x, across, i) * pixel(fine, i, j);
                        }
                    }
                    coarse.pixels[y * width + x] = sum;
                }
            }
        });
    m_levels.push_back(std::move(coarse));
    return isDone;
}

std::size_t ImageSampler::memoryBytes() const
{
    std::size_t bytes = m_bytes.isEmpty() ? 0 : m_bytes.byteCount();
    for (const LevelPixels& level : m_levels) {
        bytes += level.pixels.size() * sizeof(glm::vec4);
    }
    return bytes;
}

glm::dvec2 ImageSampler::position(glm::dvec2 st, std::size_t level) const
{
    const LevelPixels& pixels = m_levels[level];
    const glm::dvec2 down(st.x, 1 - st.y);
    if (m_options.index == TableIndex::Centres) {
        return {down.x * pixels.width - 0.5, down.y * pixels.height - 0.5};
    }
    // Coarser levels cover the area of the first, whose border is half a pixel further out.
    const LevelPixels& first = m_levels.front();
    const glm::dvec2 fine(down.x * (first.width - 1), down.y * (first.height - 1));
    return {(fine.x + 0.5) * pixels.width / first.width - 0.5,
            (fine.y + 0.5) * pixels.height / first.height - 0.5};
}

ImageSampler::Moments ImageSampler::moments(const Footprint& footprint) const
{
    const LevelPixels& first = m_levels.front();
    const bool centres = m_options.index == TableIndex::Centres;
    const glm::dvec2 size(centres ? first.width : first.width - 1,
                          centres ? first.height : first.height - 1);
    const double longest = 2.0 * std::max(first.width, first.height);
    const glm::dvec2 w1 = limitedVector(footprint.w1 * size, longest);
    const glm::dvec2 w2 = limitedVector(footprint.w2 * size, longest);
    if (!std::isfinite(w1.x + w1.y + w2.x + w2.y)) {
        return {};
    }
    // Second moments of a triangle's area: the sum over its edges of e eᵀ, over 36.
    const glm::dvec2 w3 = w1 - w2;
    return {(w1.x * w1.x + w2.x * w2.x + w3.x * w3.x) / 36,
            -(w1.x * w1.y + w2.x * w2.y + w3.x * w3.y) / 36, // t upwards, rows downwards
            (w1.y * w1.y + w2.y * w2.y + w3.y * w3.y) / 36};
}

glm::vec4 ImageSampler::pixel(const LevelPixels& level, std::int64_t x, std::int64_t y) const
{
    const auto column = static_cast<std::size_t>(wrapped(x, level.width, m_options.wrapS));
    const auto row = static_cast<std::size_t>(wrapped(y, level.height, m_options.wrapT));
    const std::size_t at = row * static_cast<std::size_t>(level.width) + column;
    if (!level.pixels.empty()) {
        return level.pixels[at];
    }
    const TexelFormat& format = m_bytes.format();
    const std::byte* bytes = m_bytes.pixels().data() + at * format.channels;
    const auto value = [&](std::size_t c) {
        return m_light[c][std::to_integer<std::size_t>(bytes[m_channels[c]])];
    };
    const float alpha =
        format.alpha ? static_cast<float>(std::to_integer<int>(bytes[*format.alpha])) / 255.0F
                     : 1.0F;
    return {alpha * value(0), alpha * value(1), alpha * value(2), alpha};
}

glm::vec4 ImageSampler::nearest(glm::dvec2 st) const
{
    const glm::dvec2 at = position(st, 0);
    return pixel(m_levels.front(),
                 static_cast<std::int64_t>(std::floor(at.x + 0.5)),
                 static_cast<std::int64_t>(std::floor(at.y + 0.5)));
}

glm::vec4 ImageSampler::bilinear(glm::dvec2 st, std::size_t level) const
{
    const LevelPixels& pixels = m_levels[level];
    const glm::dvec2 at = position(st, level);
    const auto x = static_cast<std::int64_t>(std::floor(at.x));
    const auto y = static_cast<std::int64_t>(std::floor(at.y));
    const auto right = static_cast<float>(at.x - static_cast<double>(x));
    const auto lower = static_cast<float>(at.y - static_cast<double>(y));
    // Two steps along s, one along t; a weight of 0 keeps what is not finite out.
    const auto between = [](const glm::vec4& a, const glm::vec4& b, float part) {
        return part > 0 ? a + part * (b - a) : a;
    };
    const auto row = [&](std::int64_t line) {
        return between(pixel(pixels, x, line), pixel(pixels, x + 1, line), right);
    };
    return lower > 0 ? between(row(y), row(y + 1), lower) : row(y);
}

glm::vec4 ImageSampler::trilinear(glm::dvec2 st, const Moments& m) const
{
    const double middle = 0.5 * (m.xx + m.yy);
    const double major = middle + std::hypot(0.5 * (m.xx - m.yy), m.xy);
    // A box of this variance is √(12 σ²) pixels wide.
    const double finest = 0.5 * std::log2(std::max(12 * major, 1.0));
    const double level = std::min(finest, static_cast<double>(m_levels.size() - 1));
    const auto below = static_cast<std::size_t>(level);
    const auto part = static_cast<float>(level - static_cast<double>(below));
    const glm::vec4 fine = bilinear(st, below);
    return part > 0 ? fine + part * (bilinear(st, below + 1) - fine) : fine;
}

glm::vec4 ImageSampler::gaussian(glm::dvec2 st, const Moments& m) const
{
    const double middle = 0.5 * (m.xx + m.yy);
    const double spread = std::hypot(0.5 * (m.xx - m.yy), m.xy);
    const double major = middle + spread;
    const double minor = std::max({(m.xx * m.yy - m.xy * m.xy) / std::max(major, 1e-300),
                                   major / (kMostSamplerAnisotropy * kMostSamplerAnisotropy),
                                   0.0});
    // The coarsest level whose own pixels (boxes) still leave something to average.
    std::size_t level = 0;
    double scale = 1;
    while (level + 1 < m_levels.size() &&
           (minor - (4 * scale * scale - 1) / 12) / (4 * scale * scale) >= 0.25) {
        ++level;
        scale *= 2;
    }
    const double widened =
        std::max(0.0, minor - (m.xx * m.yy - m.xy * m.xy) / std::max(major, 1e-300));
    const double box = (scale * scale - 1) / 12;
    const auto inLevel = [&](double variance) {
        return std::max(variance + widened - box, 0.0) / (scale * scale) + kTentVariance;
    };
    const double xx = inLevel(m.xx);
    const double yy = inLevel(m.yy);
    const double xy = m.xy / (scale * scale);
    const double det = xx * yy - xy * xy;
    if (!(det > 1e-6)) {
        return bilinear(st, level);
    }
    const LevelPixels& pixels = m_levels[level];
    const glm::dvec2 at = position(st, level);
    constexpr double kCut = 3; // in σ
    const double reachY = kCut * std::sqrt(yy);
    const auto first = static_cast<std::int64_t>(std::ceil(at.y - reachY));
    const auto last = static_cast<std::int64_t>(std::floor(at.y + reachY));
    glm::vec4 sum(0);
    float weights = 0;
    for (std::int64_t y = first; y <= last; ++y) {
        // Of each row only what the ellipse of 3 σ crosses.
        const double dy = static_cast<double>(y) - at.y;
        const double centre = at.x + dy * xy / yy;
        const double inside = kCut * kCut - dy * dy / yy;
        if (inside <= 0) {
            continue;
        }
        const double half = std::sqrt(inside * det / yy);
        const auto begin = static_cast<std::int64_t>(std::ceil(centre - half));
        const auto end = static_cast<std::int64_t>(std::floor(centre + half));
        const auto rowWeight = static_cast<float>(-0.5 * dy * dy / yy);
        const auto perSquare = static_cast<float>(-0.5 * yy / det);
        for (std::int64_t x = begin; x <= end; ++x) {
            const auto dx = static_cast<float>(static_cast<double>(x) - centre);
            const float weight = std::exp(rowWeight + perSquare * dx * dx);
            sum += weight * pixel(pixels, x, y);
            weights += weight;
        }
    }
    return weights > 0 ? sum / weights : bilinear(st, level);
}

glm::vec4 ImageSampler::at(glm::dvec2 st, const Footprint& footprint) const
{
    if (!std::isfinite(st.x) || !std::isfinite(st.y)) {
        return glm::vec4(0);
    }
    constexpr double kFarthest = 1e9; // whole numbers of pixels stay whole
    st = glm::clamp(st, glm::dvec2(-kFarthest), glm::dvec2(kFarthest));
    switch (m_options.lookup) {
    case ImageLookup::Nearest:
        return nearest(st);
    case ImageLookup::Bilinear:
        return bilinear(st, 0);
    case ImageLookup::Mip:
        return trilinear(st, moments(footprint));
    case ImageLookup::Footprint:
        break;
    }
    return gaussian(st, moments(footprint));
}

} // namespace trixel
