// SPDX-License-Identifier: GPL-3.0-or-later
//
// Probes → answers, some queries while the caches get what others read. Included once per
// instruction set (see Highway).
#include "core/filter/probe_place_simd-inl.h"
#include "core/filter/probe_sum_simd-inl.h"
#include "core/filter/query_filter.h"
#include "core/filter/texel_detail.h"

#include <algorithm>
#include <cmath>
#include <hwy/cache_control.h>
#include <hwy/highway.h>

#if defined(TRIXEL_PROBE_ANSWER_SIMD) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIXEL_PROBE_ANSWER_SIMD
#undef TRIXEL_PROBE_ANSWER_SIMD
#else
#define TRIXEL_PROBE_ANSWER_SIMD
#endif

HWY_BEFORE_NAMESPACE();
namespace trixel::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Reads are asked for of so many probes at a time, or a few more, of so many queries at most.
constexpr std::size_t kReadTogether = 64;
constexpr std::size_t kAnsweredTogether = 16;

/// Where a probe finds a group of channels.
HWY_INLINE const float*
valuesOf(const FilterScene& scene, const ProbeBatch& batch, int fine, std::size_t probe, int group)
{
    if (group == 0) {
        return batch.probes.values[probe];
    }
    const FaceId face = batch.probes.face[probe];
    return scene.pyramid().vertices(face, std::min(Level(fine), scene.level(face)), group).values;
}

/// Adds the texels that the probes of a line read.
HWY_INLINE void addTexels(const FilterScene& scene,
                          const ProbeBatch& batch,
                          const ProbeRange& range,
                          const Reads& reads,
                          int group,
                          ChannelSum& sum)
{
    const TexelReads& texels = reads.texels;
    for (std::size_t p = range.first; p < range.first + range.count; ++p) {
        const std::size_t k = p - reads.begin;
        if (texels.ownWeight[k] > 0 || texels.otherWeight[k] > 0) {
            const FaceId face = batch.probes.face[p];
            const LevelTexels base = scene.mips().texels(face, scene.level(face), group);
            sum.add(base.texel(TexelIndex{texels.own[k]}), texels.ownWeight[k]);
            sum.add(base.texel(TexelIndex{texels.other[k]}), texels.otherWeight[k]);
        }
    }
}

/// Sums the probes of one query for one group of channels.
HWY_INLINE void sumProbes(const FilterScene& scene,
                          const ProbeBatch& batch,
                          const QueryLines& query,
                          const Reads& reads,
                          int group,
                          float* value)
{
    const ProbeRange& some = batch.ranges[query.first];
    const float* origin = valuesOf(scene, batch, some.fine, some.first, group) +
                          reads.fine.pair[some.first - reads.begin];
    ChannelSum sum(origin);
    for (std::size_t l = query.first; l < query.first + query.count; ++l) {
        const ProbeRange& range = batch.ranges[l];
        ChannelSum fine(origin);
        ChannelSum coarse(origin);
        float weight = 0;
        for (std::size_t p = range.first; p < range.first + range.count; ++p) {
            const float* values = valuesOf(scene, batch, range.fine, p, group);
            const std::size_t k = p - reads.begin;
            weight += reads.weight[k];
            fine.add(values, reads.fine, k);
            // Where the face has but one level, nothing was found out about the other.
            if (batch.probes.coarse[p] > 0) {
                coarse.add(values, reads.coarse, k);
            }
        }
        if (range.beyond) {
            addTexels(scene, batch, range, reads, group, fine);
        }
        const auto share = static_cast<float>(batch.lines[l].share);
        sum.addSums(fine, coarse, share / weight);
    }
    sum.store(value);
}

/// Finds out what the probes of queries read, and asks the caches for it.
void prepareReads(ProbeBatch& batch, QueryLines* queries, std::size_t count, double c, Reads& reads)
{
    const std::size_t firstLine = queries[0].first;
    const std::size_t endLine = queries[count - 1].first + queries[count - 1].count;
    reads.begin = batch.ranges[firstLine].first;
    reads.end = batch.ranges[endLine - 1].first + batch.ranges[endLine - 1].count;
    const ProbeArrays& probes = batch.probes;
    findReads(probes, c, reads);
    for (std::size_t q = 0; q < count; ++q) {
        QueryLines& query = queries[q];
        query.texels = 0;
        for (std::size_t l = query.first; l < query.first + query.count; ++l) {
            const ProbeRange& range = batch.ranges[l];
            const std::size_t at = range.first - reads.begin;
            if (range.beyond) {
                LevelReads& fine = reads.fine;
                const VertexWeights weights = {fine.first + at, fine.second + at, fine.third + at};
                query.texels += findTexels(probes, range, weights, at, reads.texels);
            }
            for (std::size_t k = at; k < at + range.count; ++k) {
                const float* values = probes.values[reads.begin + k];
                hwy::Prefetch(values + reads.fine.pair[k]);
                hwy::Prefetch(values + reads.fine.single[k]);
                if (range.coarse > 0) {
                    hwy::Prefetch(values + reads.coarse.pair[k]);
                    hwy::Prefetch(values + reads.coarse.single[k]);
                }
            }
        }
    }
}

void finishQuery(const FilterScene& scene,
                 const FilterQueries& queries,
                 std::size_t q,
                 const ProbeBatch& batch,
                 const QueryLines& query,
                 const Reads& reads,
                 const FilterResults& results)
{
    const FaceId face = queries.face[q];
    const bool hasCentre = std::isfinite(queries.u[q]) && std::isfinite(queries.v[q]);
    for (int group = 0; group < scene.mips().groups(); ++group) {
        GroupValue value;
        if (hasCentre) {
            sumProbes(scene, batch, query, reads, group, value.data());
        } else {
            std::copy_n(scene.mips().average(face, group), kGroupChannels, value.begin());
        }
        storeAnswer(results, q, group, scene.channels(), value);
    }
    const int level = std::min(batch.ranges[query.first].fine, scene.level(face).log2());
    std::size_t taps = query.texels;
    for (std::size_t l = query.first; l < query.first + query.count; ++l) {
        taps += batch.ranges[l].count * (batch.ranges[l].coarse > 0 ? 6 : 3);
    }
    storeCost(results,
              q,
              hasCentre ? QueryCost{static_cast<float>(level), static_cast<std::uint32_t>(taps)}
                        : QueryCost{0, 1});
}

/// Of queries whose probes are placed, how many to answer at a time: their places take little more
/// than kReadTogether and the room of one query.
std::size_t countTogether(const ProbeBatch& batch, std::size_t first, std::size_t end)
{
    const auto placeOf = [&](std::size_t query) {
        return batch.ranges[batch.queries[query].first].first;
    };
    std::size_t next = first;
    while (next < end && next < first + kAnsweredTogether &&
           placeOf(next) < placeOf(first) + kReadTogether) {
        ++next;
    }
    return next - first;
}

/// Answers `count` queries whose probes are placed, the first of them number `begin`, some while
/// the caches get what others read.
void finishSome(const FilterScene& scene,
                const FilterQueries& queries,
                std::size_t begin,
                std::size_t count,
                double falloff,
                const FilterResults& results,
                ProbeBatch& batch,
                Reads (&reads)[2])
{
    const auto prepared = [&](std::size_t first, Reads& to) {
        const std::size_t some = countTogether(batch, first, count);
        if (some > 0) {
            prepareReads(batch, batch.queries + first, some, falloff, to);
        }
        return first + some;
    };
    std::size_t end = prepared(0, reads[0]);
    for (std::size_t first = 0, turn = 0; first < count; turn = 1 - turn) {
        const std::size_t next = prepared(end, reads[1 - turn]);
        for (; first < end; ++first) {
            finishQuery(
                scene, queries, begin + first, batch, batch.queries[first], reads[turn], results);
        }
        end = next;
    }
}

} // namespace trixel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
