// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/image_thumbnail.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace trixel::ui {

namespace {

/// Looks a pixel takes along each side: enough that photographs do not shimmer.
constexpr int kSamples = 3;

/// Colours as a screen shows them, and opacity.
class PixelReader
{
public:
    explicit PixelReader(const Image& image)
        : m_image(image)
        , m_values(image.format().channels)
    {
        for (std::uint16_t c = 0; c < image.format().channels; ++c) {
            if (image.format().alpha != c) {
                m_colors.push_back(c);
            }
        }
        if (m_colors.empty()) {
            m_colors.push_back(0);
        }
    }

    std::array<float, 4> at(int x, int y)
    {
        const std::size_t bytes = m_image.format().texelBytes();
        decode(m_image.format().type,
               m_image.row(y).subspan(static_cast<std::size_t>(x) * bytes, bytes),
               m_values);
        std::array<float, 4> pixel{0, 0, 0, 1};
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint16_t channel = m_colors[m_colors.size() >= 3 ? c : 0];
            const float stored = m_values[channel];
            const bool isLinear = m_image.colors()[channel] == ColorSpace::Linear;
            const float shown = isLinear ? fromLinear(ColorSpace::SRgb, stored) : stored;
            pixel[c] = std::isfinite(shown) ? std::clamp(shown, 0.0F, 1.0F) : 0.0F;
        }
        if (m_image.format().alpha) {
            pixel[3] = std::clamp(m_values[*m_image.format().alpha], 0.0F, 1.0F);
        }
        return pixel;
    }

private:
    const Image& m_image;
    std::vector<float> m_values;
    std::vector<std::uint16_t> m_colors;
};

} // namespace

QImage thumbnailOf(const Image& image, int mostAcross)
{
    if (image.isEmpty()) {
        return {};
    }
    const double scale =
        std::min(1.0, static_cast<double>(mostAcross) / std::max(image.width(), image.height()));
    const int width = std::max(1, static_cast<int>(std::lround(scale * image.width())));
    const int height = std::max(1, static_cast<int>(std::lround(scale * image.height())));
    QImage small(width, height, QImage::Format_ARGB32);
    uchar* const first = small.bits();
    const auto stride = static_cast<std::size_t>(small.bytesPerLine());
    const auto place = [](int pixel, int sample, int pixels, int all) {
        const double at = (pixel + (sample + 0.5) / kSamples) / pixels;
        return std::clamp(static_cast<int>(at * all), 0, all - 1);
    };
    parallelFor(static_cast<std::size_t>(height), 8, Threads::all(), [&](auto begin, auto end) {
        PixelReader read(image);
        for (std::size_t row = begin; row < end; ++row) {
            const int y = static_cast<int>(row);
            auto* line = reinterpret_cast<QRgb*>(first + row * stride);
            for (int x = 0; x < width; ++x) {
                std::array<float, 4> sum{};
                for (int k = 0; k < kSamples * kSamples; ++k) {
                    const auto pixel = read.at(place(x, k % kSamples, width, image.width()),
                                               place(y, k / kSamples, height, image.height()));
                    for (std::size_t c = 0; c < 4; ++c) {
                        sum[c] += pixel[c];
                    }
                }
                const auto byte = [&](std::size_t c) {
                    return static_cast<int>(std::lround(255 * sum[c] / (kSamples * kSamples)));
                };
                line[x] = qRgba(byte(0), byte(1), byte(2), byte(3));
            }
        }
    });
    return small;
}

} // namespace trixel::ui
