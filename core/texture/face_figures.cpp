// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/face_figures.h"

#include "core/mesh/triangle_geometry.h"
#include "core/texture/pinned_face.h"
#include "core/texture/texel_codec.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trixel {

namespace {

constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();

/// Lowest, highest and sum of integers as stored; their order is that of the numbers.
template <class T>
struct IntegerSums
{
    void add(T value)
    {
        low = std::min(low, value);
        high = std::max(high, value);
        sum += value;
    }

    T low = std::numeric_limits<T>::max();
    T high = 0;
    std::uint64_t sum = 0;
};

struct FloatSums
{
    void add(float value)
    {
        if (std::isnan(value)) {
            ++nans;
            return;
        }
        low = std::min(low, value);
        high = std::max(high, value);
        sum += static_cast<double>(value);
    }

    float low = std::numeric_limits<float>::infinity();
    float high = -std::numeric_limits<float>::infinity();
    double sum = 0;
    std::uint64_t nans = 0;
};

/// Channels of each texel that are looked at.
struct ChannelRange
{
    std::size_t first = 0;
    std::size_t end = 0;
    std::size_t left = 0; ///< out among them; `end` for none

    std::size_t count() const { return end - first - (left < end ? 1 : 0); }
};

ChannelRange rangeOf(const TexelFormat& format, const ChannelChoice& channel)
{
    if (channel) {
        check(*channel < format.channels, "a channel of the format");
        return {*channel, *channel + std::size_t{1}, *channel + std::size_t{1}};
    }
    const std::size_t all = format.channels;
    return {0, all, format.alpha && all > 1 ? *format.alpha : all};
}

template <class T, class Take>
void visitValues(std::span<const std::byte> bytes,
                 std::size_t channels,
                 const ChannelRange& range,
                 const Take& take)
{
    const std::size_t values = bytes.size() / sizeof(T);
    if (range.count() == channels) { // one after the other
        for (std::size_t k = 0; k < values; ++k) {
            take(loadStored<T>(bytes.data(), k));
        }
        return;
    }
    for (std::size_t texel = 0; texel < values; texel += channels) {
        for (std::size_t c = range.first; c < range.end; ++c) {
            if (c != range.left) {
                take(loadStored<T>(bytes.data(), texel + c));
            }
        }
    }
}

FaceValues fromFloats(const FloatSums& sums, std::uint64_t count)
{
    if (sums.nans == count) {
        return {kNothing, kNothing, kNothing, true};
    }
    return {sums.low,
            sums.high,
            static_cast<float>(sums.sum / static_cast<double>(count - sums.nans)),
            sums.nans > 0};
}

} // namespace

FaceValues
valuesOf(const FaceTexels& texels, const TexelFormat& format, const ChannelChoice& channel)
{
    const ChannelRange range = rangeOf(format, channel);
    const PinnedFace pin(texels);
    const std::span<const std::byte> bytes = pin->bytes();
    const std::uint64_t count = bytes.size() / format.texelBytes() * range.count();
    return withTexelType(format.type, [&](auto type) -> FaceValues {
        using Codec = TexelCodec<type()>;
        using Stored = typename Codec::Stored;
        if constexpr (type() == TexelType::UInt8 || type() == TexelType::UInt16) {
            IntegerSums<Stored> sums;
            visitValues<Stored>(
                bytes, format.channels, range, [&](Stored value) { sums.add(value); });
            constexpr double kTop = std::numeric_limits<Stored>::max();
            const double mean = static_cast<double>(sums.sum) / (kTop * static_cast<double>(count));
            return {Codec::decoded(sums.low),
                    Codec::decoded(sums.high),
                    static_cast<float>(mean),
                    false};
        } else {
            FloatSums sums;
            visitValues<Stored>(bytes, format.channels, range, [&](Stored value) {
                sums.add(Codec::decoded(value));
            });
            return fromFloats(sums, count);
        }
    });
}

float densityOf(const TriangleMesh& mesh, FaceId face, Level level)
{
    const double edge = std::sqrt(meanSquareEdge(mesh.corners(face)));
    return edge > 0 ? static_cast<float>(level.resolution() / edge) : kNothing;
}

FaceFigure figureOf(const TriangleMesh& mesh,
                    FaceId face,
                    const FaceTexels& texels,
                    const TexelFormat& format,
                    const ChannelChoice& channel)
{
    return {texels.level(),
            texels.isConstant(),
            densityOf(mesh, face, texels.level()),
            valuesOf(texels, format, channel)};
}

void FaceFigures::resize(std::size_t faceCount)
{
    m_levels.resize(faceCount);
    m_marks.resize(faceCount);
    for (std::vector<float>* figures : {&m_density, &m_lowest, &m_highest, &m_mean}) {
        figures->resize(faceCount);
    }
}

void FaceFigures::put(std::size_t index, const FaceFigure& figure)
{
    m_levels[index] = figure.level;
    m_marks[index] = static_cast<std::uint8_t>((figure.isConstant ? kConstant : 0) |
                                               (figure.values.holdsNan ? kNan : 0));
    m_density[index] = figure.density;
    m_lowest[index] = figure.values.lowest;
    m_highest[index] = figure.values.highest;
    m_mean[index] = figure.values.mean;
}

void FaceFigures::set(FaceId face, const FaceFigure& figure)
{
    check(indexOf(face) < faceCount(), "face exists");
    put(indexOf(face), figure);
}

void FaceFigures::measureRange(const TriangleMesh& mesh,
                               const TexelStore& texels,
                               std::size_t begin,
                               std::size_t end)
{
    const FaceTexels* before = nullptr;
    FaceValues values;
    for (std::size_t k = begin; k < end; ++k) {
        const FaceTexels& face = texels.face(faceId(k));
        if (before == nullptr || !face.sharesBytesWith(*before)) {
            values = valuesOf(face, m_format, m_channel);
        }
        before = &face;
        put(k, {face.level(), face.isConstant(), densityOf(mesh, faceId(k), face.level()), values});
    }
}

Result<FaceFigures> FaceFigures::measure(const TriangleMesh& mesh,
                                         const TexelStore& texels,
                                         const ChannelChoice& channel,
                                         Threads threads,
                                         Progress& progress)
{
    // Between two looks at the progress: so many faces, or so many bytes.
    constexpr std::size_t kMostFaces = 1U << 16U;
    constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 26U;
    constexpr std::size_t kMostGrain = 256;
    FaceFigures figures;
    figures.m_format = texels.format();
    figures.m_channel = channel;
    static_cast<void>(rangeOf(figures.m_format, channel));
    const std::size_t faces = texels.faceCount();
    check(mesh.faceCount() == faces, "texels of the mesh");
    figures.resize(faces);
    for (std::size_t begin = 0; begin < faces;) {
        if (!progress.report(static_cast<double>(begin) / static_cast<double>(faces))) {
            return cancelled();
        }
        std::size_t end = begin;
        std::uint64_t bytes = 0;
        while (end < faces && end - begin < kMostFaces && bytes < kMostBytes) {
            bytes += texels.face(faceId(end)).byteCount();
            ++end;
        }
        const std::size_t grain = std::clamp<std::size_t>((end - begin) / 64, 1, kMostGrain);
        parallelFor(end - begin, grain, threads, [&](std::size_t from, std::size_t to) {
            figures.measureRange(mesh, texels, begin + from, begin + to);
        });
        begin = end;
    }
    return figures;
}

} // namespace trixel
