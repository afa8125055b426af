// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/image_levels.h"

#include <algorithm>
#include <array>
#include <utility>

namespace trixel {

namespace {

/// Of a row or column of `size` pixels, those that half pixel `k` covers, and how far each.
struct Covered
{
    int first = 0;
    int count = 0;
    std::array<float, 3> weights{};
};

Covered coveredBy(int k, int size, int half)
{
    if (size == 1) {
        return {0, 1, {1, 0, 0}};
    }
    // An odd row of 2 n + 1 pixels in n: each covers 2 + 1/n of them, which is parts of three.
    const double width = static_cast<double>(size) / half;
    const double begin = k * width;
    const double end = (k + 1) * width;
    Covered covered{static_cast<int>(begin), 0, {}};
    for (int x = covered.first; x < size && covered.count < 3; ++x) {
        const double part = std::min<double>(end, x + 1) - std::max<double>(begin, x);
        if (part <= 1e-9) {
            break;
        }
        covered.weights[static_cast<std::size_t>(covered.count++)] =
            static_cast<float>(part / width);
    }
    return covered;
}

class RowHalver
{
public:
    RowHalver(const Image& image, Image& half)
        : m_image(image)
        , m_half(half)
        , m_channels(image.format().channels)
    {
    }

    void halve(int y, std::span<std::byte> target)
    {
        const auto width = static_cast<std::size_t>(m_image.width());
        m_sums.assign(static_cast<std::size_t>(m_half.width()) * m_channels, 0.0F);
        m_weights.assign(static_cast<std::size_t>(m_half.width()), 0.0F);
        m_means.assign(m_image.format().alpha ? m_sums.size() : 0, 0.0F);
        m_row.resize(width * m_channels);
        const Covered rows = coveredBy(y, m_image.height(), m_half.height());
        for (int r = 0; r < rows.count; ++r) {
            decode(m_image.format().type, m_image.row(rows.first + r), m_row);
            linearise();
            add(rows.weights[static_cast<std::size_t>(r)]);
        }
        finish(target);
    }

private:
    void linearise()
    {
        for (std::size_t c = 0; c < m_channels; ++c) {
            if (m_image.colors()[c] == ColorSpace::SRgb) {
                for (std::size_t k = c; k < m_row.size(); k += m_channels) {
                    m_row[k] = toLinear(ColorSpace::SRgb, m_row[k]);
                }
            }
        }
    }

    void add(float rowWeight)
    {
        const auto& alpha = m_image.format().alpha;
        for (int x = 0; x < m_half.width(); ++x) {
            const Covered columns = coveredBy(x, m_image.width(), m_half.width());
            float* sum = &m_sums[static_cast<std::size_t>(x) * m_channels];
            for (int k = 0; k < columns.count; ++k) {
                const float* pixel =
                    &m_row[static_cast<std::size_t>(columns.first + k) * m_channels];
                const float weight = rowWeight * columns.weights[static_cast<std::size_t>(k)];
                const float opacity = alpha ? pixel[*alpha] : 1.0F;
                m_weights[static_cast<std::size_t>(x)] += weight * opacity;
                for (std::size_t c = 0; c < m_channels; ++c) {
                    sum[c] += alpha == c ? weight * pixel[c] : weight * opacity * pixel[c];
                }
                for (std::size_t c = 0; c < m_channels && alpha; ++c) {
                    m_means[static_cast<std::size_t>(x) * m_channels + c] += weight * pixel[c];
                }
            }
        }
    }

    void finish(std::span<std::byte> target)
    {
        const auto& alpha = m_image.format().alpha;
        for (std::size_t k = 0; k < m_sums.size(); ++k) {
            const std::size_t c = k % m_channels;
            const float weight = m_weights[k / m_channels];
            if (alpha && alpha != c) {
                // Where nothing is seen, colours are for programs that look them up on their own.
                m_sums[k] = weight > 0 ? m_sums[k] / weight : m_means[k];
            }
            m_sums[k] = fromLinear(m_image.colors()[c], m_sums[k]);
        }
        encode(m_half.format().type, m_sums, target);
    }

    const Image& m_image;
    const Image& m_half;
    std::size_t m_channels;
    std::vector<float> m_row, m_sums, m_weights;
    std::vector<float> m_means; ///< as if all was opaque; empty where there is no opacity
};

} // namespace

Image halved(const Image& image, Threads threads)
{
    Image half(std::max(1, image.width() / 2),
               std::max(1, image.height() / 2),
               image.format(),
               image.colors());
    const std::span<std::byte> pixels = half.writable();
    const std::size_t rowBytes = pixels.size() / static_cast<std::size_t>(half.height());
    parallelFor(static_cast<std::size_t>(half.height()),
                16,
                threads,
                [&](std::size_t begin, std::size_t end) {
                    RowHalver halver(image, half);
                    for (std::size_t y = begin; y < end; ++y) {
                        halver.halve(static_cast<int>(y), pixels.subspan(y * rowBytes, rowBytes));
                    }
                });
    return half;
}

std::vector<Image> imageLevels(Image image, Threads threads)
{
    std::vector<Image> levels;
    levels.push_back(std::move(image));
    while (levels.back().width() > 1 || levels.back().height() > 1) {
        levels.push_back(halved(levels.back(), threads));
    }
    return levels;
}

} // namespace trixel
