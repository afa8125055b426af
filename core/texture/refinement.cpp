// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/refinement.h"

#include "core/lattice/texel.h"
#include "core/texture/texel_codec.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace trixel {
namespace {

/// The middle child, then those at the corners in the order of `cornersOf`.
using Four = std::array<double, 4>;

struct LatticePoint
{
    std::uint32_t i = 0;
    std::uint32_t j = 0;
};

/// Lattice vertices at the corners of a texel.
std::array<LatticePoint, 3> cornersOf(TexelCoord texel)
{
    const std::uint32_t i = texel.i;
    const std::uint32_t j = texel.j;
    return texel.half == TexelHalf::Lower
               ? std::array<LatticePoint, 3>{{{i, j}, {i + 1, j}, {i, j + 1}}}
               : std::array<LatticePoint, 3>{{{i + 1, j + 1}, {i, j + 1}, {i + 1, j}}};
}

/// The four texels one level finer, in the order of `Four`.
std::array<TexelCoord, 4> childrenOf(TexelCoord texel)
{
    const auto i = static_cast<std::uint16_t>(2 * texel.i);
    const auto j = static_cast<std::uint16_t>(2 * texel.j);
    const auto right = static_cast<std::uint16_t>(i + 1);
    const auto above = static_cast<std::uint16_t>(j + 1);
    if (texel.half == TexelHalf::Lower) {
        return {{{i, j, TexelHalf::Upper},
                 {i, j, TexelHalf::Lower},
                 {right, j, TexelHalf::Lower},
                 {i, above, TexelHalf::Lower}}};
    }
    return {{{right, above, TexelHalf::Lower},
             {right, above, TexelHalf::Upper},
             {i, above, TexelHalf::Upper},
             {right, j, TexelHalf::Upper}}};
}

/// \param averages  at the parent's corners
Four childValues(double parent, const std::array<double, 3>& averages)
{
    Four departure{};
    double mean = 0;
    double low = parent;
    double high = parent;
    for (std::size_t k = 0; k < averages.size(); ++k) {
        departure[k + 1] = (averages[k] - parent) / 2;
        mean += departure[k + 1] / 4;
        low = std::min(low, averages[k]);
        high = std::max(high, averages[k]);
    }
    if (!std::isfinite(mean)) {
        return {parent, parent, parent, parent};
    }
    double contrast = 1;
    for (double& d : departure) {
        d -= mean;
        if (d > 0) {
            contrast = std::min(contrast, (high - parent) / d);
        } else if (d < 0) {
            contrast = std::min(contrast, (low - parent) / d);
        }
    }
    Four values{};
    std::ranges::transform(
        departure, values.begin(), [&](double d) { return parent + contrast * d; });
    return values;
}

/// Whole numbers next to the values, whose sum is four times the parent's.
Four roundedToMean(double parent, const Four& values)
{
    Four rounded{};
    double missing = 4 * parent;
    std::array<std::size_t, 4> byFraction{0, 1, 2, 3};
    for (std::size_t k = 0; k < values.size(); ++k) {
        rounded[k] = std::floor(values[k]);
        missing -= rounded[k];
    }
    std::ranges::stable_sort(byFraction, [&](std::size_t a, std::size_t b) {
        return values[a] - rounded[a] > values[b] - rounded[b];
    });
    for (const std::size_t k : byFraction) {
        if (missing < 0.5) {
            break;
        }
        rounded[k] += 1;
        missing -= 1;
    }
    return rounded;
}

template <TexelType kType>
class Refiner
{
public:
    using Codec = TexelCodec<kType>;
    using T = typename Codec::Stored;
    static constexpr bool kInteger = kType == TexelType::UInt8 || kType == TexelType::UInt16;

    Refiner(const TexelFormat& format,
            const FaceTexels& face,
            std::span<const LevelVertices> vertices,
            std::span<std::byte> target)
        : m_format(format)
        , m_face(face)
        , m_vertices(vertices)
        , m_target(target)
    {
    }

    void refine() const
    {
        const Level level = m_face.level();
        const Level finer(level.log2() + 1);
        for (std::uint32_t t = 0; t < level.texelCount(); ++t) {
            const TexelCoord texel = texelAt(level, static_cast<TexelIndex>(t));
            std::array<std::size_t, 3> corners{};
            std::ranges::transform(cornersOf(texel), corners.begin(), [&](LatticePoint p) {
                return latticeVertex(level, p.i, p.j);
            });
            std::array<std::size_t, 4> children{};
            std::ranges::transform(childrenOf(texel), children.begin(), [&](TexelCoord child) {
                return indexOf(texelIndex(finer, child));
            });
            for (std::size_t c = 0; c < m_format.channels; ++c) {
                refineChannel(t, corners, children, c);
            }
        }
    }

private:
    static constexpr double unit()
    {
        return kInteger ? static_cast<double>(static_cast<T>(~0U)) : 1.0;
    }

    void refineChannel(std::size_t texel,
                       const std::array<std::size_t, 3>& corners,
                       const std::array<std::size_t, 4>& children,
                       std::size_t channel) const
    {
        const T stored = loadStored<T>(m_face.texel(texel).data(), channel);
        const LevelVertices& group = m_vertices[channel / kGroupChannels];
        std::array<double, 3> averages{};
        std::ranges::transform(corners, averages.begin(), [&](std::size_t vertex) {
            return unit() * static_cast<double>(
                                group.values[group.stride * vertex + channel % kGroupChannels]);
        });
        if constexpr (kInteger) {
            const auto parent = static_cast<double>(stored);
            const Four values = roundedToMean(parent, childValues(parent, averages));
            for (std::size_t k = 0; k < children.size(); ++k) {
                save(children[k], channel, static_cast<T>(std::clamp(values[k], 0.0, unit())));
            }
        } else {
            const Four values = childValues(Codec::decoded(stored), averages);
            for (std::size_t k = 0; k < children.size(); ++k) {
                save(children[k], channel, Codec::encoded(static_cast<float>(values[k])));
            }
        }
    }

    void save(std::size_t texel, std::size_t channel, T value) const
    {
        saveStored(m_target.data() + texel * m_format.texelBytes(), channel, value);
    }

    const TexelFormat& m_format;
    const FaceTexels& m_face;
    std::span<const LevelVertices> m_vertices;
    std::span<std::byte> m_target;
};

} // namespace

FaceTexels
refined(const TexelFormat& format, const FaceTexels& face, std::span<const LevelVertices> vertices)
{
    check(face.level().log2() < Level::kMax, "a level below the highest");
    check(face.texelBytes() == format.texelBytes(), "texels in the format");
    check(vertices.size() * kGroupChannels >= format.channels, "averages of every channel");
    const Level finer(face.level().log2() + 1);
    if (face.isConstant()) {
        return face.atLevel(finer);
    }
    std::vector<std::byte> texels(format.texelBytes() * finer.texelCount());
    withTexelType(format.type, [&](auto type) {
        Refiner<decltype(type)::value>(format, face, vertices, texels).refine();
    });
    return FaceTexels::full(finer, format.texelBytes(), texels);
}

} // namespace trixel
