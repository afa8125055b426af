// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/face_painter.h"

#include "core/base/check.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

namespace trixel::ui {

namespace {

/// Places of the four samples of a pixel about its middle: no two in one row, column or diagonal.
constexpr std::array<glm::dvec2, 4> kSamples{
    {{-0.125, -0.375}, {0.375, -0.125}, {0.125, 0.375}, {-0.375, 0.125}}};

/// Pixels are drawn if their middle is so much beside the face, in texels: faces that meet leave no
/// gap between them.
constexpr double kSlack = 1e-6;

/// Lines of the grid: a light one in the middle of a dark one, of such widths.
constexpr double kDarkLine = 1.6;
constexpr double kLightLine = 0.7;
constexpr double kLineAlpha = 0.35;

/// Pixels of a row in one texel that are worth finding out how many they are.
constexpr double kLeastRun = 4;
constexpr double kCostOfRuns = 0.3;

struct Sample
{
    PackedPixel pixel;
    bool upper = false;

    bool operator==(const Sample&) const = default;
};

/// A signed integer on the way is what processors convert to quickest.
std::uint32_t cellOf(double x, std::uint32_t resolution)
{
    const auto last = static_cast<std::int32_t>(resolution) - 1;
    return static_cast<std::uint32_t>(std::clamp(static_cast<std::int32_t>(x), 0, last));
}

/// Where in its cell a place of the face lies.
glm::dvec2 inCell(glm::dvec2 p)
{
    return {p.x - static_cast<std::int32_t>(p.x), p.y - static_cast<std::int32_t>(p.y)};
}

std::uint16_t narrow(std::uint32_t value)
{
    return static_cast<std::uint16_t>(value);
}

/// The texel at (u,v) R.
Sample triangleSample(glm::dvec2 p, std::uint32_t resolution)
{
    const std::uint32_t last = resolution - 1;
    const std::uint32_t i = cellOf(p.x, resolution);
    const std::uint32_t j = cellOf(p.y, resolution);
    const bool beyond = (p.x - i) + (p.y - j) > 1;
    if (beyond && i + j < last) {
        return {{narrow(last - j), narrow(last - i)}, true};
    }
    return {{narrow(i), narrow(std::min(j, last - i))}, false};
}

/// The pixel at a place of the packed square.
Sample pixelSample(glm::dvec2 p, std::uint32_t resolution)
{
    const std::uint32_t x = cellOf(p.x, resolution);
    const std::uint32_t y = cellOf(p.y, resolution);
    return {{narrow(x), narrow(y)}, x + y >= resolution};
}

QRgb over(QRgb top, QRgb below)
{
    const auto rest = static_cast<std::uint32_t>(255 - qAlpha(top));
    if (rest == 0) {
        return top;
    }
    // Two parts at once; x + 128 + (x >> 8) over 256 is x / 255 rounded.
    const auto scaled = [rest](std::uint32_t parts) {
        const std::uint32_t x = (parts & 0x00FF00FFU) * rest + 0x00800080U;
        return ((x + ((x >> 8U) & 0x00FF00FFU)) >> 8U) & 0x00FF00FFU;
    };
    return top + (scaled(below) | scaled(below >> 8U) << 8U);
}

QRgb mean(const std::array<QRgb, 4>& colors)
{
    std::uint32_t even = 0x00020002U;
    std::uint32_t odd = 0x00020002U;
    for (const QRgb color : colors) {
        even += color & 0x00FF00FFU;
        odd += (color >> 8U) & 0x00FF00FFU;
    }
    return ((even >> 2U) & 0x00FF00FFU) | ((odd >> 2U) & 0x00FF00FFU) << 8U;
}

/// Draws rows of one face.
template <bool kTriangles>
class RowPainter
{
public:
    RowPainter(const FaceLayout& layout,
               const FaceTexels& texels,
               ShadedTexels& shades,
               const TexelPaint& paint)
        : m_texels(texels)
        , m_shades(shades)
        , m_paint(paint)
        , m_resolution(texels.level().resolution())
    {
        const PlaneMap back = layout.map().inverse();
        const auto side = static_cast<double>(m_resolution);
        m_toTexels = {back.origin * side, back.x * side, back.y * side};
        m_reach = (glm::abs(m_toTexels.x) + glm::abs(m_toTexels.y)) * 0.5;
        m_reachAcross = (std::abs(m_toTexels.x.x + m_toTexels.x.y) +
                         std::abs(m_toTexels.y.x + m_toTexels.y.y)) *
                        0.5;
        const glm::dvec2 perX = m_toTexels.x;
        const glm::dvec2 perY = m_toTexels.y;
        m_pixels = {1 / std::hypot(perX.x, perY.x), 1 / std::hypot(perX.y, perY.y)};
        m_pixelsAcross = 1 / std::hypot(perX.x + perX.y, perY.x + perY.y);
        measureRuns();
    }

    void paint(QRgb* line, int y, int left, int right) const
    {
        const glm::dvec2 start = m_toTexels.point({0.5, y + 0.5});
        narrowDown(start, left, right);
        for (int x = left; x <= right; ++x) {
            if (m_hasRuns) {
                x += paintRun(line + x, start + static_cast<double>(x) * m_toTexels.x, x, y, right);
                if (x > right) {
                    break;
                }
            }
            const glm::dvec2 p = start + static_cast<double>(x) * m_toTexels.x;
            const QRgb color = over(colorOf(p, x, y), line[x]);
            line[x] = m_paint.grid > 0 ? lined(color, p) : color;
        }
    }

    /// Parts of the time that pixels take where they are drawn one by one.
    double cost() const { return m_hasRuns ? kCostOfRuns : 1; }

private:
    /// How much of a texel is neither drawn with another nor with a line.
    void measureRuns()
    {
        const double line = m_paint.grid > 0 ? 0.5 * kDarkLine * m_paint.unit + 0.5 + kSlack : 0;
        m_margin = glm::max(m_reach, line / m_pixels);
        m_marginAcross = std::max(m_reachAcross, line / m_pixelsAcross);
        // Rows through the middle of what is left are so many pixels long.
        const double left = 1 - 2 * std::max({m_margin.x, m_margin.y, m_marginAcross});
        m_hasRuns = left / std::max(m_reach.x, m_reach.y) > kLeastRun;
    }

    /// Draws pixels that are all of one texel, from the first on. \return  how many
    int paintRun(QRgb* pixels, glm::dvec2 p, int x, int y, int right) const
    {
        const glm::dvec2 in = inCell(p);
        double length = right - x;
        // value >= margin for so many steps
        const auto keep = [&length](double value, double step, double margin) {
            if (value < margin) {
                length = -1;
            } else if (step < 0) {
                length = std::min(length, (margin - value) / step);
            }
        };
        const glm::dvec2 step = m_toTexels.x;
        keep(in.x, step.x, m_margin.x);
        keep(1 - in.x, -step.x, m_margin.x);
        keep(in.y, step.y, m_margin.y);
        keep(1 - in.y, -step.y, m_margin.y);
        if constexpr (kTriangles) {
            const double across = in.x + in.y - 1;
            const double sign = across < 0 ? -1 : 1;
            keep(sign * across, sign * (step.x + step.y), m_marginAcross);
        }
        if (length < 1) {
            return 0;
        }
        const Sample sample = sampleAt(p);
        if (isMark(m_shades.at(m_texels, sample.pixel))) [[unlikely]] {
            return 0; // no two pixels alike
        }
        const QRgb color = colorOf(sample, x, y);
        const int count = static_cast<int>(length) + 1;
        if (qAlpha(color) == 255) {
            std::fill_n(pixels, count, color);
        } else {
            std::transform(
                pixels, pixels + count, pixels, [color](QRgb below) { return over(color, below); });
        }
        return count;
    }

    /// Leaves of the columns those whose middle is in the face.
    void narrowDown(glm::dvec2 start, int& left, int& right) const
    {
        double low = left;
        double high = right;
        const glm::dvec2 step = m_toTexels.x;
        const auto side = static_cast<double>(m_resolution);
        // value + x slope >= 0
        const auto keep = [&](double value, double slope) {
            const double slack = value + kSlack;
            if (slope > 0) {
                low = std::max(low, -slack / slope);
            } else if (slope < 0) {
                high = std::min(high, -slack / slope);
            } else if (!(slack >= 0)) {
                high = -std::numeric_limits<double>::infinity();
            }
        };
        keep(start.x, step.x);
        keep(start.y, step.y);
        if constexpr (kTriangles) {
            keep(side - start.x - start.y, -step.x - step.y);
        } else {
            keep(side - start.x, -step.x);
            keep(side - start.y, -step.y);
        }
        if (!(low <= high)) {
            right = left - 1;
            return;
        }
        left = static_cast<int>(std::ceil(low));
        right = static_cast<int>(std::floor(high));
    }

    Sample sampleAt(glm::dvec2 p) const
    {
        return kTriangles ? triangleSample(p, m_resolution) : pixelSample(p, m_resolution);
    }

    /// Whether the whole pixel about a place lies in one texel.
    bool isInside(glm::dvec2 p) const
    {
        const glm::dvec2 in = inCell(p);
        if (in.x < m_reach.x || in.y < m_reach.y || in.x > 1 - m_reach.x || in.y > 1 - m_reach.y) {
            return false;
        }
        return !kTriangles || std::abs(in.x + in.y - 1) > m_reachAcross;
    }

    QRgb colorOf(const Sample& sample, int x, int y) const
    {
        const QRgb tint = sample.upper ? m_paint.upperTint : m_paint.lowerTint;
        const QRgb shaded = m_shades.at(m_texels, sample.pixel);
        if (isMark(shaded)) [[unlikely]] {
            return over(tint, colorAt(shaded, inUnits(x), inUnits(y)));
        }
        return over(tint, shaded);
    }

    int inUnits(int pixel) const { return static_cast<int>(pixel / m_paint.unit); }

    QRgb colorOf(glm::dvec2 p, int x, int y) const
    {
        const Sample middle = sampleAt(p);
        if (!m_paint.smooth || isInside(p)) {
            return colorOf(middle, x, y);
        }
        std::array<QRgb, 4> colors{};
        for (std::size_t k = 0; k < kSamples.size(); ++k) {
            colors[k] = colorOf(sampleAt(p + m_toTexels.vector(kSamples[k])), x, y);
        }
        return mean(colors);
    }

    /// The pixel with what it has of a line between texels: light beside dark.
    QRgb lined(QRgb color, glm::dvec2 p) const
    {
        const glm::dvec2 in = inCell(p);
        double distance =
            std::min(std::min(in.x, 1 - in.x) * m_pixels.x, std::min(in.y, 1 - in.y) * m_pixels.y);
        if constexpr (kTriangles) {
            distance = std::min(distance, std::abs(in.x + in.y - 1) * m_pixelsAcross);
        }
        const auto cover = [&](double width) {
            const double part = 0.5 * width * m_paint.unit + 0.5 - distance;
            return static_cast<int>(255 * kLineAlpha * m_paint.grid * std::clamp(part, 0.0, 1.0));
        };
        const int dark = cover(kDarkLine);
        if (dark <= 0) {
            return color;
        }
        const int light = cover(kLightLine);
        return over(qRgba(light, light, light, light), over(qRgba(0, 0, 0, dark), color));
    }

    const FaceTexels& m_texels;
    ShadedTexels& m_shades;
    const TexelPaint& m_paint;
    std::uint32_t m_resolution;
    PlaneMap m_toTexels;       ///< from the picture's pixels
    glm::dvec2 m_reach;        ///< of a pixel from its middle, in texels
    double m_reachAcross = 0;  ///< the same of x + y
    glm::dvec2 m_pixels;       ///< between lines of the grid
    double m_pixelsAcross = 0; ///< the same of those along x + y
    glm::dvec2 m_margin;       ///< of a texel that is not drawn in runs
    double m_marginAcross = 0; ///< the same of x + y
    bool m_hasRuns = false;
};

template <bool kTriangles>
void paintRows(QImage& image,
               const QRect& area,
               const RowPainter<kTriangles>& painter,
               Threads threads)
{
    // Once, here: it may detach.
    uchar* const bits = image.bits();
    const qsizetype bytesPerLine = image.bytesPerLine();
    constexpr std::size_t kGrain = 16;
    constexpr double kWorthAThread = 40000;
    const double work = painter.cost() * area.width() * area.height();
    const Threads used = work < kWorthAThread ? Threads{1} : threads;
    parallelFor(static_cast<std::size_t>(area.height()),
                kGrain,
                used,
                [&](std::size_t begin, std::size_t end) {
                    for (std::size_t row = begin; row < end; ++row) {
                        const int y = area.top() + static_cast<int>(row);
                        auto* line = reinterpret_cast<QRgb*>(bits + y * bytesPerLine);
                        painter.paint(line, y, area.left(), area.right());
                    }
                });
}

/// The pixels that the face may touch.
QRect boundsOf(const FaceLayout& layout)
{
    const TexelOutline outline = layout.outline();
    glm::dvec2 low = outline.corners()[0];
    glm::dvec2 high = low;
    for (const glm::dvec2 corner : outline.corners()) {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
    }
    constexpr double kFar = 1e6; // beyond any picture, and an int
    low = glm::clamp(glm::floor(low), -kFar, kFar);
    high = glm::clamp(glm::ceil(high), -kFar, kFar);
    return {QPoint(static_cast<int>(low.x), static_cast<int>(low.y)),
            QPoint(static_cast<int>(high.x), static_cast<int>(high.y))};
}

} // namespace

void paintTexels(QImage& image,
                 const QRect& clip,
                 const FaceLayout& layout,
                 const FaceTexels& texels,
                 ShadedTexels& shades,
                 const TexelPaint& paint)
{
    check(image.format() == QImage::Format_RGB32 ||
              image.format() == QImage::Format_ARGB32_Premultiplied,
          "a picture of 32 bits a pixel");
    check(texels.level() == shades.level(), "shades of the same level");
    const QRect area = clip & image.rect() & boundsOf(layout);
    if (area.isEmpty()) {
        return;
    }
    if (layout.texels() == FaceLayout::Texels::Triangles) {
        paintRows(image, area, RowPainter<true>(layout, texels, shades, paint), paint.threads);
    } else {
        paintRows(image, area, RowPainter<false>(layout, texels, shades, paint), paint.threads);
    }
}

double texelSide(const FaceLayout& layout, Level level)
{
    return std::sqrt(std::abs(layout.map().area())) / level.resolution();
}

Level levelToDraw(const FaceLayout& layout, Level finest)
{
    // A face has as many texels as its square has pixels, on the area of half the square.
    const bool triangles = layout.texels() == FaceLayout::Texels::Triangles;
    const double side = texelSide(layout, Level(0)) * (triangles ? std::sqrt(0.5) : 1.0);
    const double fits = side > 1 ? std::round(std::log2(side)) : 0;
    return Level(static_cast<int>(std::min(fits, static_cast<double>(finest.log2()))));
}

} // namespace trixel::ui
