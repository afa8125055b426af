// SPDX-License-Identifier: GPL-3.0-or-later
//
// Placed probes → answers, a few queries at a time so that what is known about them stays in the
// nearest cache. Included once per instruction set (see Highway).
#include "core/filter/probe_place_simd-inl.h"
#include "core/filter/probe_sum_simd-inl.h"
#include "core/filter/probe_texels_simd-inl.h"
#include "core/filter/query_filter.h"

#include <algorithm>
#include <cmath>
#include <hwy/highway.h>
#include <span>

#if defined(TRIXEL_PROBE_ANSWER_SIMD) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIXEL_PROBE_ANSWER_SIMD
#undef TRIXEL_PROBE_ANSWER_SIMD
#else
#define TRIXEL_PROBE_ANSWER_SIMD
#endif

HWY_BEFORE_NAMESPACE();
namespace trixel::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Reads are found for so many probes at a time, or a few more, of so many queries at most.
constexpr std::size_t kReadTogether = 64;
constexpr std::size_t kAnsweredTogether = 16;

/// What consecutive probes of a line, in one face, read.
struct Span
{
    const float* values; ///< of the level, first group
    FaceId face;
    int level;
    std::uint32_t begin, end; ///< places among the reads
    bool isBlended;           ///< with the level below
    bool hasTexels;
};

/// What the probes of some queries read, and room to find it out.
struct Reads
{
    PackedProbes probes;
    LevelReads fine, coarse;
    TexelReads texels; ///< of spans that have some
    Span spans[kReadsRoom];
    std::size_t spansOf[kAnsweredTogether * kMostLines + 1]; ///< first one of each line
    std::size_t taps[kAnsweredTogether];                     ///< of each query
};

/// Packs the probes of a piece, from `at` on.
HWY_INLINE void packProbes(const Pieces& pieces,
                           std::size_t k,
                           int level,
                           const float* bells,
                           std::size_t at,
                           PackedProbes& to)
{
    const hn::ScalableTag<double> d;
    const hn::Rebind<std::int32_t, decltype(d)> di;
    const hn::Rebind<float, decltype(d)> df;
    const std::int32_t resolution = std::int32_t{1} << level;
    const double scale = resolution;
    const auto u = hn::Set(d, pieces.u[k] * scale);
    const auto v = hn::Set(d, pieces.v[k] * scale);
    const auto perU = hn::Set(d, pieces.perU[k] * scale);
    const auto perV = hn::Set(d, pieces.perV[k] * scale);
    const auto share = hn::Set(df, static_cast<float>(pieces.share[k]));
    const float* bell = bells + static_cast<std::size_t>(pieces.begin[k]);
    const std::size_t count = pieces.probes(k);
    for (std::size_t p = 0; p < count; p += hn::Lanes(d)) {
        const auto step = hn::Iota(d, static_cast<double>(p));
        hn::StoreU(hn::MulAdd(step, perU, u), d, to.u + at + p);
        hn::StoreU(hn::MulAdd(step, perV, v), d, to.v + at + p);
        hn::StoreU(hn::Set(di, resolution), di, to.resolution + at + p);
        hn::StoreU(hn::Mul(hn::LoadU(df, bell + p), share), df, to.weight + at + p);
    }
}

/// Packs the probes of a line, from `at` on, and notes its spans; returns where they end.
std::size_t packLine(const ProbeBatch& batch,
                     const PlacedLine& line,
                     std::size_t at,
                     Reads& reads,
                     std::size_t& spans)
{
    for (const std::int32_t first : line.first) {
        for (std::int32_t number = first; number >= 0;) {
            const auto k = static_cast<std::size_t>(number);
            const auto& [level, next] = batch.reads[k];
            const int own = level.level.log2();
            packProbes(batch.pieces, k, own, batch.bells + line.bell, at, reads.probes);
            const std::size_t end = at + batch.pieces.probes(k);
            reads.spans[spans++] = {level.values,
                                    faceId(static_cast<std::size_t>(batch.pieces.face[k])),
                                    own,
                                    static_cast<std::uint32_t>(at),
                                    static_cast<std::uint32_t>(end),
                                    own == line.fine && line.coarse > 0,
                                    own < line.fine && !level.constant};
            at = end;
            number = next;
        }
    }
    return at;
}

/// Finds out what the probes of queries from `first` on read, as many as fit together; returns how
/// many.
std::size_t readSome(const ProbeBatch& batch, std::size_t first, std::size_t end, Reads& reads)
{
    std::size_t count = 0;
    std::size_t lines = 0;
    std::size_t spans = 0;
    std::size_t probes = 0;
    reads.spansOf[0] = 0;
    for (; count < kAnsweredTogether && first + count < end && probes < kReadTogether; ++count) {
        const QueryLines& query = batch.queries[first + count];
        for (std::size_t l = query.first; l < query.first + query.count; ++l) {
            probes = packLine(batch, batch.lines[l], probes, reads, spans);
            reads.spansOf[++lines] = spans;
        }
    }
    findReads(reads.probes, probes, reads.fine, reads.coarse);
    const std::size_t* spansOf = reads.spansOf;
    for (std::size_t q = 0; q < count; ++q) {
        const QueryLines& query = batch.queries[first + q];
        std::size_t taps = 0;
        for (std::size_t l = query.first; l < query.first + query.count; ++l, ++spansOf) {
            for (std::size_t s = spansOf[0]; s < spansOf[1]; ++s) {
                const Span& span = reads.spans[s];
                taps += (span.end - span.begin) * (span.isBlended ? 6 : 3);
                if (span.hasTexels) {
                    const PlacedLine& line = batch.lines[l];
                    const float share = span.level + 1 < line.fine ? 1.0F : 1.0F - line.coarse;
                    taps += findTexels(
                        reads.probes, share, span.begin, span.end, reads.fine, reads.texels);
                }
            }
        }
        reads.taps[q] = taps;
    }
    return count;
}

/// Where the probes of a span find a group of channels.
HWY_INLINE const float* valuesOf(const FilterScene& scene, const Span& span, int group)
{
    return group == 0 ? span.values
                      : scene.pyramid().vertices(span.face, Level(span.level), group).values;
}

/// Adds the probes of the spans of one line, from `first` to `end`, for one group of channels.
/// \param none  a sum of the same origin, without values
HWY_INLINE void addLine(const FilterScene& scene,
                        const PlacedLine& line,
                        const Reads& reads,
                        std::size_t first,
                        std::size_t end,
                        int group,
                        const ChannelSum& none,
                        ChannelSum& mean)
{
    ChannelSum single = none;
    ChannelSum fine = none;
    ChannelSum coarse = none;
    float weight = 0;
    for (std::size_t s = first; s < end; ++s) {
        const Span& span = reads.spans[s];
        const float* values = valuesOf(scene, span, group);
        if (span.isBlended) {
            for (std::size_t k = span.begin; k < span.end; ++k) {
                weight += reads.probes.weight[k];
                fine.add(values, reads.fine, k);
                coarse.add(values, reads.coarse, k);
            }
        } else {
            for (std::size_t k = span.begin; k < span.end; ++k) {
                weight += reads.probes.weight[k];
                single.add(values, reads.fine, k);
            }
        }
        if (span.hasTexels) {
            const LevelTexels base = scene.mips().texels(span.face, Level(span.level), group);
            for (std::size_t k = span.begin; k < span.end; ++k) {
                single.add(base, reads.texels, k);
            }
        }
    }
    const float share = line.share / weight;
    mean.addSum(single, share);
    mean.addSum(fine, share - share * line.coarse);
    mean.addSum(coarse, share * line.coarse);
}

/// Answers the query number q, whose lines are `lines` and have the spans from `spans[0]` on, each
/// to the next of `spans`.
void finishQuery(const FilterScene& scene,
                 const FilterQueries& queries,
                 std::size_t q,
                 std::span<const PlacedLine> lines,
                 const std::size_t* spans,
                 const Reads& reads,
                 std::size_t taps,
                 const FilterResults& results)
{
    const FaceId face = queries.face[q];
    const bool hasCentre = std::isfinite(queries.u[q]) && std::isfinite(queries.v[q]);
    for (int group = 0; group < scene.mips().groups(); ++group) {
        GroupValue value;
        if (hasCentre) {
            const Span& first = reads.spans[spans[0]];
            const ChannelSum none(valuesOf(scene, first, group) + reads.fine.pair[first.begin]);
            ChannelSum mean = none;
            for (std::size_t l = 0; l < lines.size(); ++l) {
                addLine(scene, lines[l], reads, spans[l], spans[l + 1], group, none, mean);
            }
            mean.store(value.data());
        } else {
            std::copy_n(scene.mips().average(face, group), kGroupChannels, value.begin());
        }
        storeAnswer(results, q, group, scene.channels(), value);
    }
    const int level = std::min(lines[0].fine, scene.level(face).log2());
    storeCost(results,
              q,
              hasCentre ? QueryCost{static_cast<float>(level), static_cast<std::uint32_t>(taps)}
                        : QueryCost{0, 1});
}

/// Answers `count` queries whose probes are placed, the first of them number `begin`.
void finishSome(const FilterScene& scene,
                const FilterQueries& queries,
                std::size_t begin,
                std::size_t count,
                const FilterResults& results,
                const ProbeBatch& batch,
                Reads& reads)
{
    for (std::size_t first = 0; first < count;) {
        const std::size_t some = readSome(batch, first, count, reads);
        const std::size_t* spans = reads.spansOf;
        for (std::size_t q = 0; q < some; ++q, ++first) {
            const QueryLines& query = batch.queries[first];
            const std::span lines(batch.lines + query.first, query.count);
            finishQuery(scene, queries, begin + first, lines, spans, reads, reads.taps[q], results);
            spans += query.count;
        }
    }
}

} // namespace trixel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
