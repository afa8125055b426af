// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/fit/fit_points.h"

#include "core/lattice/texel.h"

#include <algorithm>
#include <cmath>

namespace trixel {
namespace {

/// See `fitPoints`.
Level pointLevel(const FitSource& source, FaceId face, Level level)
{
    int points = std::min(level.log2() + 1, source.texels.face(face).level().log2());
    while (points > 1 && std::exp2(2 * (points - 1)) >= 4 * source.weight(face)) {
        --points;
    }
    return Level(std::max(points, 1));
}

/// The part of each channel that belongs to one face's points, joined.
std::vector<float>
partOf(std::span<const float> values, std::size_t queries, std::size_t first, std::size_t count)
{
    std::vector<float> part;
    for (std::size_t channel = 0; channel < values.size(); channel += queries) {
        const auto from = values.subspan(channel + first, count);
        part.insert(part.end(), from.begin(), from.end());
    }
    return part;
}

} // namespace

FitPoints
fitPoints(const FitSource& source, const FaceMap<Level>& levels, const FaceMap<char>& isMoved)
{
    const FilterSurface& shapes = *source.shapes;
    // What moves is seen from the faces about it too.
    FaceMap<char> isLooked = isMoved;
    for (std::size_t r = 0; r < shapes.rings().ringCount(); ++r) {
        const auto corners = shapes.rings().corners(static_cast<RingId>(r));
        if (std::ranges::any_of(corners, [&](const Corner& c) { return isMoved[c.face] != 0; })) {
            for (const Corner& corner : corners) {
                isLooked[corner.face] = 1;
            }
        }
    }
    FitPoints points;
    for (std::uint32_t f = 0; f < levels.size(); ++f) {
        const FaceId face = faceId(f);
        if (isLooked[face] == 0 || !(source.weight(face) > 0)) {
            continue;
        }
        const Level level = pointLevel(source, face, levels[face]);
        const auto [w1, w2] = roundFootprint(shapes.shape(face), source.spacing(face));
        for (std::uint32_t t = 0; t < level.texelCount(); ++t) {
            const glm::dvec2 uv = centroid(level, texelAt(level, static_cast<TexelIndex>(t)));
            points.queries.add(face, glm::vec2(uv), w1, w2);
        }
        points.levels.push_back(level);
        points.ranges.push_back({face,
                                 level.texelCount(),
                                 static_cast<float>(source.weight(face) / level.texelCount())});
    }
    return points;
}

FitWanted::FitWanted(const FitSource& source)
    : m_source(source)
    , m_seen(Level::kMax + 1)
{
}

Status FitWanted::look(const FitPoints& points, Threads threads, Progress& progress)
{
    QueryArrays queries;
    std::vector<std::size_t> fresh;
    std::size_t first = 0;
    for (std::size_t r = 0; r < points.ranges.size(); ++r) {
        const PointRange& range = points.ranges[r];
        auto& known = m_seen[static_cast<std::size_t>(points.levels[r].log2())];
        if (known.size() == 0) {
            known = FaceMap<std::vector<float>>(m_source.texels.faceCount());
        }
        if (known[range.face].empty()) {
            fresh.push_back(r);
            const QueryArrays& all = points.queries;
            for (std::size_t k = first; k < first + range.count; ++k) {
                queries.add(range.face,
                            {all.u[k], all.v[k]},
                            {all.uw1[k], all.vw1[k]},
                            {all.uw2[k], all.vw2[k]});
            }
        }
        first += range.count;
    }
    const auto values = seenThroughExact(m_source.scene, queries, threads, progress);
    if (!values) {
        return tl::unexpected(values.error());
    }
    first = 0;
    for (const std::size_t r : fresh) {
        const PointRange& range = points.ranges[r];
        m_seen[static_cast<std::size_t>(points.levels[r].log2())][range.face] =
            partOf(*values, queries.size(), first, range.count);
        first += range.count;
    }
    return {};
}

std::vector<Quad> FitWanted::group(const FitPoints& points, int group) const
{
    const auto channels = static_cast<std::size_t>(m_source.texels.format().channels);
    const std::size_t from = static_cast<std::size_t>(group) * 4;
    std::vector<Quad> wanted;
    wanted.reserve(points.queries.size());
    for (std::size_t r = 0; r < points.ranges.size(); ++r) {
        const std::size_t count = points.ranges[r].count;
        const auto& values =
            m_seen[static_cast<std::size_t>(points.levels[r].log2())][points.ranges[r].face];
        for (std::size_t p = 0; p < count; ++p) {
            Quad value(0);
            for (std::size_t c = from; c < std::min(from + 4, channels); ++c) {
                value[static_cast<int>(c - from)] = values[c * count + p];
            }
            wanted.push_back(value);
        }
    }
    return wanted;
}

} // namespace trixel
