// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/difference_colors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace trixel::ui {

namespace {

using Parts = std::array<double, 3>;

// Ends: M. Okabe and K. Ito, "Color Universal Design" (2002).
constexpr Parts kBelow{0, 114, 178};
constexpr Parts kEqual{244, 244, 244};
constexpr Parts kAbove{213, 94, 0};
constexpr QRgb kNoNumber = qRgb(70, 70, 70);

std::vector<float> decoded(const TexelFormat& format, std::span<const std::byte> bytes)
{
    std::vector<float> values(bytes.size() / byteSize(format.type));
    decode(format.type, bytes, values);
    return values;
}

} // namespace

QRgb differenceColor(double position)
{
    if (std::isnan(position)) {
        return kNoNumber;
    }
    const Parts& end = position < 0 ? kBelow : kAbove;
    const double part = std::min(std::abs(position), 1.0);
    const auto mixed = [&](std::size_t k) {
        return static_cast<int>(std::lround(kEqual[k] + part * (end[k] - kEqual[k])));
    };
    return qRgb(mixed(0), mixed(1), mixed(2));
}

double signedDifference(std::span<const float> right,
                        std::span<const float> box,
                        std::optional<std::uint16_t> channel)
{
    const auto of = [&](std::size_t c) {
        return static_cast<double>(box[c]) - static_cast<double>(right[c]);
    };
    if (channel && *channel < right.size()) {
        return of(*channel);
    }
    double most = 0;
    for (std::size_t c = 0; c < right.size(); ++c) {
        const double apart = of(c);
        if (std::isnan(apart) || std::abs(apart) > std::abs(most)) {
            most = apart;
        }
        if (std::isnan(most)) {
            break;
        }
    }
    return most;
}

FaceTexels differenceTexels(const MipComparison& levels,
                            Level level,
                            std::optional<std::uint16_t> channel,
                            double range)
{
    const FaceTexels& right = levels.drawn(level, ReductionRule::Triangles);
    const FaceTexels& box = levels.drawn(level, ReductionRule::Box);
    const auto bytesOf = [](double position) {
        const QRgb color = differenceColor(position);
        return std::array{static_cast<std::byte>(qRed(color)),
                          static_cast<std::byte>(qGreen(color)),
                          static_cast<std::byte>(qBlue(color))};
    };
    if (right.sharesBytesWith(box)) {
        return FaceTexels::constant(right.level(), bytesOf(0));
    }
    const std::size_t channels = levels.format().channels;
    const std::vector<float> rightValues = decoded(levels.format(), right.bytes());
    const std::vector<float> boxValues = decoded(levels.format(), box.bytes());
    std::vector<std::byte> colors;
    colors.reserve(3 * std::size_t{right.level().texelCount()});
    const auto texel = [channels](const std::vector<float>& values, bool constant, std::size_t t) {
        return std::span(values).subspan(constant ? 0 : t * channels, channels);
    };
    for (std::size_t t = 0; t < right.level().texelCount(); ++t) {
        const double apart = signedDifference(texel(rightValues, right.isConstant(), t),
                                              texel(boxValues, box.isConstant(), t),
                                              channel);
        const auto color = bytesOf(apart == 0 ? 0 : apart / range);
        colors.insert(colors.end(), color.begin(), color.end());
    }
    return FaceTexels::full(right.level(), colors.size() / right.level().texelCount(), colors);
}

} // namespace trixel::ui
