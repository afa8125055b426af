// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/mips.h"

#include "core/base/check.h"
#include "core/lattice/reduction.h"
#include "core/texture/pinned_face.h"
#include "core/texture/texel_codec.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace trixel {

namespace {

/// A quarter of the sum, rounded to nearest with ties to even.
template <class T>
T quarter(std::uint32_t sum)
{
    return static_cast<T>((sum + 1 + ((sum >> 2) & 1)) >> 2);
}

template <TexelType kType>
auto meanOfFour(const std::array<const std::byte*, 4>& from, std::size_t channel)
{
    using Codec = TexelCodec<kType>;
    using T = typename Codec::Stored;
    if constexpr (kType == TexelType::UInt8 || kType == TexelType::UInt16) {
        std::uint32_t sum = 0;
        for (const std::byte* texel : from) {
            sum += loadStored<T>(texel, channel);
        }
        return quarter<T>(sum);
    } else {
        float sum = 0;
        for (const std::byte* texel : from) {
            sum += Codec::decoded(loadStored<T>(texel, channel));
        }
        return Codec::encoded(sum * 0.25F);
    }
}

/// Where the four texels below a coarser one lie, in bytes, and how far on they are for the next
/// one of its row.
template <ReductionRule kRule>
struct Below
{
    std::array<std::ptrdiff_t, 4> first{};
    std::array<std::ptrdiff_t, 4> step{};

    Below(Level fine, PackedPixel coarse, std::size_t texelBytes)
    {
        const auto offsets = [&](PackedPixel pixel) {
            const auto below =
                kRule == ReductionRule::Box ? boxPixels(pixel) : finerPixels(fine, pixel);
            std::array<std::ptrdiff_t, 4> result{};
            std::ranges::transform(below, result.begin(), [&](PackedPixel finer) {
                return static_cast<std::ptrdiff_t>(
                    (std::size_t{finer.y} * fine.resolution() + finer.x) * texelBytes);
            });
            return result;
        };
        first = offsets(coarse);
        if (coarse.x + 1U < fine.coarser().resolution()) {
            const auto next = offsets({static_cast<std::uint16_t>(coarse.x + 1), coarse.y});
            std::ranges::transform(next, first, step.begin(), std::minus<>());
        }
    }
};

/// \tparam kChannels  of a texel, or 0 where that is known only when it runs
template <TexelType kType, ReductionRule kRule, std::size_t kChannels>
void reduceRows(const TexelFormat& format,
                Level fine,
                std::span<const std::byte> source,
                std::span<std::byte> target)
{
    // The fourth texel walks down a column as x grows: small squares keep those rows in cache.
    constexpr std::uint32_t kTile = 32;
    const std::uint32_t resolution = fine.coarser().resolution();
    const std::size_t channels = kChannels > 0 ? kChannels : format.channels;
    const std::size_t texelBytes = format.texelBytes();
    const auto reduceRow = [&](std::uint32_t left, std::uint32_t y, std::uint32_t right) {
        const PackedPixel pixel{static_cast<std::uint16_t>(left), static_cast<std::uint16_t>(y)};
        Below<kRule> below(fine, pixel, texelBytes);
        std::byte* to = target.data() + (std::size_t{y} * resolution + left) * texelBytes;
        for (std::uint32_t x = left; x < right; ++x, to += texelBytes) {
            std::array<const std::byte*, 4> from{};
            for (std::size_t k = 0; k < from.size(); ++k) {
                from[k] = source.data() + below.first[k];
                below.first[k] += below.step[k];
            }
            for (std::size_t channel = 0; channel < channels; ++channel) {
                saveStored(to, channel, meanOfFour<kType>(from, channel));
            }
        }
    };
    for (std::uint32_t tileY = 0; tileY < resolution; tileY += kTile) {
        for (std::uint32_t tileX = 0; tileX < resolution; tileX += kTile) {
            for (std::uint32_t y = tileY; y < std::min(tileY + kTile, resolution); ++y) {
                reduceRow(tileX, y, std::min(tileX + kTile, resolution));
            }
        }
    }
}

template <TexelType kType, ReductionRule kRule>
void reduceFull(const TexelFormat& format,
                Level fine,
                std::span<const std::byte> source,
                std::span<std::byte> target)
{
    switch (format.channels) {
    case 1:
        return reduceRows<kType, kRule, 1>(format, fine, source, target);
    case 3:
        return reduceRows<kType, kRule, 3>(format, fine, source, target);
    case 4:
        return reduceRows<kType, kRule, 4>(format, fine, source, target);
    default:
        return reduceRows<kType, kRule, 0>(format, fine, source, target);
    }
}

} // namespace

void reduceTexels(const TexelFormat& format,
                  Level fine,
                  std::span<const std::byte> source,
                  std::span<std::byte> target,
                  ReductionRule rule)
{
    check(fine.log2() >= 1, "a level to reduce");
    check(source.size() == format.texelBytes() * fine.texelCount() &&
              target.size() == format.texelBytes() * fine.coarser().texelCount(),
          "all texels of both levels");
    withTexelType(format.type, [&](auto type) {
        constexpr TexelType kType = decltype(type)::value;
        if (rule == ReductionRule::Box) {
            reduceFull<kType, ReductionRule::Box>(format, fine, source, target);
        } else {
            reduceFull<kType, ReductionRule::Triangles>(format, fine, source, target);
        }
    });
}

FaceTexels reduced(const TexelFormat& format, const FaceTexels& face, ReductionRule rule)
{
    check(face.level().log2() >= 1, "a level to reduce");
    check(face.texelBytes() == format.texelBytes(), "texels in the format");
    const PinnedFace pin(face);
    const Level coarse = face.level().coarser();
    if (face.isConstant()) {
        return face.atLevel(coarse);
    }
    std::vector<std::byte> texels(format.texelBytes() * coarse.texelCount());
    reduceTexels(format, face.level(), pin->bytes(), texels, rule);
    return FaceTexels::full(coarse, format.texelBytes(), texels);
}

FaceTexels reduced(const TexelFormat& format, const FaceTexels& face, int steps)
{
    FaceTexels result = face;
    for (int k = 0; k < steps && result.level().log2() > 0; ++k) {
        result = reduced(format, result);
    }
    return result;
}

} // namespace trixel
