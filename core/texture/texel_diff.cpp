// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/texel_diff.h"

#include "core/base/check.h"
#include "core/lattice/texel.h"
#include "core/mesh/shared_progress.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>
#include <span>

namespace trixel {

namespace {

constexpr std::size_t kGrainFaces = 512;

double distance(float a, float b)
{
    if (a == b || (std::isnan(a) && std::isnan(b))) {
        return 0;
    }
    const double difference = std::abs(double{a} - double{b});
    return std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
}

bool isInteger(TexelType type)
{
    return type == TexelType::UInt8 || type == TexelType::UInt16;
}

/// A face as numbers; one texel if it is constant.
struct FaceValues
{
    Level level;
    bool isConstant = false;
    std::vector<float> values;

    FaceValues(TexelType type, const FaceTexels& face)
        : level(face.level())
        , isConstant(face.isConstant())
        , values(face.byteCount() / byteSize(type))
    {
        decode(type, face.bytes(), values);
    }

    /// The texel there, at this face's own level.
    const float* texel(std::size_t index, std::size_t channels) const
    {
        return values.data() + (isConstant ? 0 : index * channels);
    }
};

/// The texel of a coarser level that covers one of a finer: its place in the packed square.
std::size_t coverOf(Level fine, std::size_t index, Level coarse)
{
    const TexelCoord texel = texelAt(fine, TexelIndex(static_cast<std::uint32_t>(index)));
    return indexOf(texelIndex(coarse, texelAt(coarse, centroid(fine, texel))));
}

struct Span
{
    float low = std::numeric_limits<float>::infinity();
    float high = -std::numeric_limits<float>::infinity();

    void add(std::span<const float> values)
    {
        for (const float value : values) {
            if (std::isfinite(value)) {
                low = std::min(low, value);
                high = std::max(high, value);
            }
        }
    }
    void add(const Span& other)
    {
        low = std::min(low, other.low);
        high = std::max(high, other.high);
    }
};

/// Compares one face after the other; one per thread.
class FaceComparer
{
public:
    FaceComparer(const DiffSide& a, const DiffSide& b, const TexelDiffOptions& options)
        : m_a(a)
        , m_b(b)
        , m_options(options)
        , m_sourceOfA(a.makeSource())
        , m_sourceOfB(b.makeSource())
        , m_wantsSpan(!isInteger(a.format.type))
    {
    }

    Result<std::optional<FaceDifference>> compare(FaceId face)
    {
        FaceDifference difference{
            .face = face, .levelOfA = m_a.level(face), .levelOfB = m_b.level(face)};
        const bool sameLevel = difference.levelOfA == difference.levelOfB;
        if (!sameLevel && !m_options.acrossLevels && !m_wantsSpan) {
            return difference;
        }
        const auto a = m_sourceOfA(face);
        const auto b = a ? m_sourceOfB(face) : a;
        if (!a || !b) {
            return tl::unexpected(a ? b.error() : a.error());
        }
        const bool alike = m_a.format.type == m_b.format.type && *a == *b;
        if (alike && !m_wantsSpan) {
            return std::nullopt;
        }
        const FaceValues valuesOfA(m_a.format.type, *a);
        if (m_wantsSpan) {
            m_span.add(valuesOfA.values);
        }
        if (alike) {
            return std::nullopt;
        }
        if (sameLevel || m_options.acrossLevels) {
            measure(valuesOfA, FaceValues(m_b.format.type, *b), difference);
        }
        return !sameLevel || difference.texels > 0 ? std::optional(difference) : std::nullopt;
    }

    const Span& span() const { return m_span; }

private:
    void measure(const FaceValues& a, const FaceValues& b, FaceDifference& difference) const
    {
        const std::size_t channels = m_a.format.channels;
        const Level level = std::max(a.level, b.level);
        const auto placeIn = [level](const FaceValues& values, std::size_t index) {
            return values.level == level || values.isConstant ? index
                                                              : coverOf(level, index, values.level);
        };
        // Two constant faces differ alike everywhere.
        const std::size_t count = a.isConstant && b.isConstant ? 1 : level.texelCount();
        double squares = 0;
        std::uint64_t differing = 0;
        for (std::size_t t = 0; t < count; ++t) {
            const float* valuesOfA = a.texel(placeIn(a, t), channels);
            const float* valuesOfB = b.texel(placeIn(b, t), channels);
            double largest = 0;
            for (std::size_t c = 0; c < channels; ++c) {
                const double d = distance(valuesOfA[c], valuesOfB[c]);
                largest = std::max(largest, d);
                squares += d * d;
            }
            differing += largest > 0 ? 1 : 0;
            difference.maxAbs = std::max(difference.maxAbs, largest);
        }
        difference.rms = std::sqrt(squares / static_cast<double>(count * channels));
        if (a.level == b.level) {
            difference.texels = differing * (level.texelCount() / count);
        }
    }

    const DiffSide& m_a;
    const DiffSide& m_b;
    const TexelDiffOptions& m_options;
    FaceSource m_sourceOfA;
    FaceSource m_sourceOfB;
    bool m_wantsSpan;
    Span m_span;
};

struct Comparison
{
    std::mutex mutex;
    std::vector<FaceDifference> faces;
    Span span;
    std::optional<Error> error;
};

void compareRange(FaceComparer& comparer, std::size_t begin, std::size_t end, Comparison& all)
{
    for (std::size_t face = begin; face < end; ++face) {
        const auto difference = comparer.compare(faceId(face));
        if (difference && !*difference) {
            continue;
        }
        const std::scoped_lock lock(all.mutex);
        if (!difference) {
            all.error = difference.error();
            return;
        }
        all.faces.push_back(**difference);
    }
}

void sumUp(const DiffSide& a, const TexelDiffOptions& options, TexelDiff& diff)
{
    std::uint64_t texels = 0; // of faces measured, each at the finer of its levels
    for (std::size_t face = 0; face < a.faceCount; ++face) {
        texels += a.level(faceId(face)).texelCount();
    }
    double squares = 0; // over texels, a mean over channels each
    for (const FaceDifference& face : diff.faces) {
        const std::uint64_t finer = std::max(face.levelOfA, face.levelOfB).texelCount();
        if (face.levelOfA != face.levelOfB) {
            ++diff.levelDifferences;
            texels -= face.levelOfA.texelCount();
            if (!options.acrossLevels) {
                continue;
            }
            texels += finer;
        }
        diff.texels += face.texels;
        diff.maxAbs = std::max(diff.maxAbs, face.maxAbs);
        squares += face.rms * face.rms * static_cast<double>(finer);
    }
    diff.rms = texels > 0 ? std::sqrt(squares / static_cast<double>(texels)) : 0;
}

} // namespace

double TexelDiff::psnr() const
{
    return rms > 0 ? 20 * std::log10(peak / rms) : std::numeric_limits<double>::infinity();
}

DiffSide DiffSide::of(const TexelStore& texels)
{
    return {texels.format(),
            texels.faceCount(),
            [&texels](FaceId face) { return texels.face(face).level(); },
            [&texels] {
                return [&texels](FaceId face) -> Result<FaceTexels> {
                    FaceTexels pinned = texels.face(face).pinned();
                    if (pinned.isDamaged()) {
                        return contentsError("face " + std::to_string(indexOf(face)) +
                                             ": could not be read");
                    }
                    return pinned;
                };
            }};
}

std::string incomparable(const DiffSide& a, const DiffSide& b)
{
    if (a.faceCount != b.faceCount) {
        return "the first has " + std::to_string(a.faceCount) + " faces, the second " +
               std::to_string(b.faceCount);
    }
    if (a.format.channels != b.format.channels) {
        return "the first has " + std::to_string(a.format.channels) + " channels, the second " +
               std::to_string(b.format.channels);
    }
    return {};
}

Result<TexelDiff> diffTexels(const DiffSide& a,
                             const DiffSide& b,
                             const TexelDiffOptions& options,
                             Progress& progress)
{
    check(incomparable(a, b).empty(), "as many faces and channels");
    const std::size_t count = a.faceCount;
    const std::size_t grain =
        std::clamp<std::size_t>(count / (std::size_t{16} * options.threads.count), 1, kGrainFaces);
    Comparison all;
    SharedProgress shared(progress, (count + grain - 1) / grain);
    std::atomic<std::size_t> next{0};
    parallelFor(options.threads.count, 1, options.threads, [&](std::size_t, std::size_t) {
        FaceComparer comparer(a, b, options);
        for (std::size_t begin = next.fetch_add(grain); begin < count && shared.goesOn();
             begin = next.fetch_add(grain)) {
            compareRange(comparer, begin, std::min(begin + grain, count), all);
            shared.step();
        }
        const std::scoped_lock lock(all.mutex);
        all.span.add(comparer.span());
    });
    if (!shared.goesOn()) {
        return cancelled();
    }
    if (all.error) {
        return tl::unexpected(*all.error);
    }
    TexelDiff diff;
    diff.faces = std::move(all.faces);
    std::ranges::sort(diff.faces, {}, &FaceDifference::face);
    sumUp(a, options, diff);
    if (!isInteger(a.format.type) && all.span.high > all.span.low) {
        diff.peak = double{all.span.high} - double{all.span.low};
    }
    return diff;
}

} // namespace trixel
