// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/fit/fitted_texels.h"

#include "core/lattice/texel.h"
#include "core/study/fit/fit_equations.h"
#include "core/study/fit/fit_parallel.h"
#include "core/texture/convert.h"
#include "core/texture/mips.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace trixel {
namespace {

/// Pixels this much wider than a coarse texel do not notice its floor.
constexpr double kWidePixel = 4;

/// Queries between two reports.
constexpr std::size_t kBatch = 512;

/// Where a face is looked at: at the centroids of the texels of this level. Up to four points a
/// texel, but no more than the face has at its own level, nor than four a pixel.
Level pointLevel(const FitSource& source, FaceId face, Level level)
{
    int points = std::min(level.log2() + 1, source.texels.face(face).level().log2());
    while (points > 1 && std::exp2(2 * (points - 1)) >= 4 * source.samples.pixels[face]) {
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

/// Four channels, or those there are, of every texel that the equations know.
class TexelGroup
{
public:
    TexelGroup(const FitEquations& equations, TexelStore& store, int group)
        : m_equations(equations)
        , m_store(store)
        , m_channels(static_cast<std::size_t>(store.format().channels))
        , m_from(static_cast<std::size_t>(group) * 4)
        , m_count(std::min<std::size_t>(4, m_channels - m_from))
    {
    }

    std::vector<Quad> read() const
    {
        std::vector<Quad> texels(m_equations.texelCount(), Quad(0));
        for (const FaceId face : m_equations.faces()) {
            const FaceTexels& from = m_store.face(face);
            Quad* to = texels.data() + *m_equations.firstTexel(face);
            for (std::uint32_t t = 0; t < from.level().texelCount(); ++t) {
                std::memcpy(
                    to + t, from.texel(t).data() + m_from * sizeof(float), m_count * sizeof(float));
            }
        }
        return texels;
    }

    void write(std::span<const Quad> texels, const FaceMap<char>& isMoved)
    {
        for (const FaceId face : m_equations.faces()) {
            if (isMoved[face] == 0) {
                continue;
            }
            const auto to = m_store.writable(face);
            const Quad* from = texels.data() + *m_equations.firstTexel(face);
            for (std::size_t t = 0; t < m_store.face(face).level().texelCount(); ++t) {
                std::memcpy(to.data() + (t * m_channels + m_from) * sizeof(float),
                            from + t,
                            m_count * sizeof(float));
            }
        }
    }

    std::size_t channels() const { return m_count; }

private:
    const FitEquations& m_equations;
    TexelStore& m_store;
    std::size_t m_channels;
    std::size_t m_from;
    std::size_t m_count;
};

/// Faces that were left alone take their bytes back; so do constant ones, at their level.
TexelStore inFormat(const FitSource& source, const TexelStore& coarse, const FaceMap<char>& isMoved)
{
    const TexelFormat& format = source.texels.format();
    TexelStore result = source.texels;
    std::vector<std::byte> bytes;
    for (std::uint32_t f = 0; f < coarse.faceCount(); ++f) {
        const FaceTexels& face = coarse.face(faceId(f));
        const FaceTexels& original = source.texels.face(faceId(f));
        if (face.level() == original.level() && isMoved[faceId(f)] == 0) {
            continue;
        }
        if (original.isConstant()) {
            result.exchange(faceId(f), original.atLevel(face.level()));
            continue;
        }
        std::vector<float> values(face.bytes().size() / sizeof(float));
        std::memcpy(values.data(), face.bytes().data(), face.bytes().size());
        bytes.resize(values.size() * byteSize(format.type));
        encode(format.type, values, bytes);
        result.exchange(faceId(f),
                        face.isConstant()
                            ? FaceTexels::constant(face.level(), bytes)
                            : FaceTexels::full(face.level(), format.texelBytes(), bytes));
    }
    return result;
}

std::pair<float, float> spanOf(const TexelStore& floats)
{
    float least = std::numeric_limits<float>::max();
    float most = std::numeric_limits<float>::lowest();
    for (std::uint32_t f = 0; f < floats.faceCount(); ++f) {
        const auto bytes = floats.face(faceId(f)).bytes();
        for (std::size_t at = 0; at < bytes.size(); at += sizeof(float)) {
            float value = 0;
            std::memcpy(&value, bytes.data() + at, sizeof(float));
            if (std::isfinite(value)) {
                least = std::min(least, value);
                most = std::max(most, value);
            }
        }
    }
    return least <= most ? std::pair(least, most) : std::pair(0.0F, 0.0F);
}

} // namespace

Result<std::vector<float>> seenThroughExact(const FilterScene& scene,
                                            const QueryArrays& queries,
                                            Threads threads,
                                            Progress& progress)
{
    ResultArrays results(queries.size(), scene.channels());
    const auto exact = makeMethod({"exact", std::nullopt});
    const std::size_t batches = (queries.size() + kBatch - 1) / kBatch;
    const Status status = forEachInParallel(batches, threads, progress, [&](std::size_t b) {
        const std::size_t first = b * kBatch;
        const std::size_t count = std::min(kBatch, queries.size() - first);
        FilterResults part = results.results();
        part.values = part.values.subspan(first);
        part.levels = part.levels.subspan(first, count);
        part.taps = part.taps.subspan(first, count);
        exact->filter(scene, queries.queries().subspan(first, count), part);
    });
    if (!status) {
        return tl::unexpected(status.error());
    }
    return std::move(results.values);
}

Result<FitSource> FitSource::make(const Surface& surface,
                                  const TexelStore& texels,
                                  const SceneViews& views,
                                  Threads threads,
                                  Progress& progress)
{
    FitSource source;
    source.texels = texels;
    StageProgress converting(progress, 0, 0.3);
    auto floats = converted(texels, TexelType::Float, threads, converting);
    if (!floats) {
        return tl::unexpected(floats.error());
    }
    source.floats = std::move(*floats);
    source.shapes = std::make_shared<FilterSurface>(
        FilterSurface::fromMesh(surface.mesh(), surface.adjacency()));
    StageProgress building(progress, 0.3, 0.9);
    auto scene = FilterScene::build(source.shapes, texels, threads, building);
    if (!scene) {
        return tl::unexpected(scene.error());
    }
    source.scene = std::move(*scene);
    FaceMap<Level> levels(texels.faceCount());
    for (std::uint32_t f = 0; f < texels.faceCount(); ++f) {
        levels[faceId(f)] = texels.face(faceId(f)).level();
    }
    source.samples = fitSamples(surface, *source.shapes, levels, views, threads);
    const TexelType type = texels.format().type;
    if (type == TexelType::Half || type == TexelType::Float) {
        std::tie(source.least, source.most) = spanOf(source.floats);
    }
    return source;
}

/// Where the surface is looked at.
struct Coarsener::Points
{
    QueryArrays queries;
    std::vector<PointRange> ranges;
    std::vector<Level> levels; ///< of each range, see `pointLevel`
};

Coarsener::Coarsener(const FitSource& source)
    : m_source(source)
    , m_wanted(Level::kMax + 1)
    , m_found(Level::kMax + 1)
{
}

TexelStore Coarsener::begin(const FaceMap<Level>& levels) const
{
    TexelStore coarse = m_source.floats;
    for (std::uint32_t f = 0; f < coarse.faceCount(); ++f) {
        const FaceId face = faceId(f);
        const FaceTexels& original = m_source.floats.face(face);
        const int steps = original.level().log2() - levels[face].log2();
        check(steps >= 0, "levels that only become coarser");
        if (steps > 0) {
            coarse.exchange(face, reduced(coarse.format(), original, steps));
        }
    }
    return coarse;
}

/// Faces whose texels or floor changed and that are seen closely enough for it to matter.
FaceMap<char> Coarsener::movable(const TexelStore& coarse) const
{
    const FilterSurface& shapes = *m_source.shapes;
    FaceMap<char> near(coarse.faceCount(), 0);
    for (std::size_t r = 0; r < shapes.rings().ringCount(); ++r) {
        const auto corners = shapes.rings().corners(static_cast<RingId>(r));
        const bool changed = std::ranges::any_of(corners, [&](const Corner& corner) {
            return coarse.face(corner.face).level() != m_source.texels.face(corner.face).level();
        });
        for (const Corner& corner : corners) {
            near[corner.face] = near[corner.face] != 0 || changed ? 1 : 0;
        }
    }
    for (std::uint32_t f = 0; f < coarse.faceCount(); ++f) {
        const FaceId face = faceId(f);
        const double edge = std::exp2(shapes.log2Length(face, glm::dvec2(1.0 / 3.0)) -
                                      coarse.face(face).level().log2());
        if (m_source.texels.face(face).isConstant() || !m_source.samples.isSeen(face) ||
            m_source.samples.spacing[face] >= kWidePixel * edge) {
            near[face] = 0;
        }
    }
    return near;
}

Coarsener::Points Coarsener::pointsFor(const TexelStore& coarse, const FaceMap<char>& isMoved) const
{
    const FilterSurface& shapes = *m_source.shapes;
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
    Points points;
    for (std::uint32_t f = 0; f < coarse.faceCount(); ++f) {
        const FaceId face = faceId(f);
        if (isLooked[face] == 0 || !m_source.samples.isSeen(face)) {
            continue;
        }
        const Level level = pointLevel(m_source, face, coarse.face(face).level());
        const auto [w1, w2] = roundFootprint(shapes.shape(face), m_source.samples.spacing[face]);
        for (std::uint32_t t = 0; t < level.texelCount(); ++t) {
            const glm::dvec2 uv = centroid(level, texelAt(level, static_cast<TexelIndex>(t)));
            points.queries.add(face, glm::vec2(uv), w1, w2);
        }
        points.levels.push_back(level);
        points.ranges.push_back(
            {face,
             level.texelCount(),
             static_cast<float>(m_source.samples.pixels[face] / level.texelCount())});
    }
    return points;
}

Status Coarsener::remember(const Points& points, Threads threads, Progress& progress)
{
    QueryArrays queries;
    std::vector<std::size_t> fresh;
    std::size_t first = 0;
    for (std::size_t r = 0; r < points.ranges.size(); ++r) {
        const PointRange& range = points.ranges[r];
        auto& known = m_wanted[static_cast<std::size_t>(points.levels[r].log2())];
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
        m_wanted[static_cast<std::size_t>(points.levels[r].log2())][range.face] =
            partOf(*values, queries.size(), first, range.count);
        first += range.count;
    }
    return {};
}

std::vector<Quad> Coarsener::wanted(const Points& points, int group) const
{
    const auto channels = static_cast<std::size_t>(m_source.texels.format().channels);
    const std::size_t from = static_cast<std::size_t>(group) * 4;
    std::vector<Quad> wanted;
    wanted.reserve(points.queries.size());
    for (std::size_t r = 0; r < points.ranges.size(); ++r) {
        const std::size_t count = points.ranges[r].count;
        const auto& values =
            m_wanted[static_cast<std::size_t>(points.levels[r].log2())][points.ranges[r].face];
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

Status Coarsener::move(TexelStore& coarse,
                       const Points& points,
                       int steps,
                       FittedTexels& fitted,
                       Threads threads,
                       Progress& progress)
{
    StageProgress looking(progress, 0, 0.3);
    if (const Status status = remember(points, threads, looking); !status) {
        return status;
    }
    StageProgress weighing(progress, 0.3, 0.6);
    NoProgress unseen;
    const auto scene = FilterScene::build(m_source.shapes, coarse, threads, unseen);
    const auto equations =
        FitEquations::make(*scene, points.queries, points.ranges, threads, weighing);
    if (!equations) {
        return tl::unexpected(equations.error());
    }
    const int groups = scene->mips().groups();
    FaceMap<double> counted(coarse.faceCount(), 0);
    for (int group = 0; group < groups; ++group) {
        StageProgress solving(
            progress, 0.6 + 0.4 * group / groups, 0.6 + 0.4 * (group + 1) / groups);
        TexelGroup texels(*equations, coarse, group);
        std::vector<Quad> values = texels.read();
        const auto missing = equations->solve(wanted(points, group),
                                              fitted.isMoved,
                                              {m_source.least, m_source.most},
                                              steps,
                                              values,
                                              threads,
                                              solving);
        if (!missing) {
            return tl::unexpected(missing.error());
        }
        texels.write(values, fitted.isMoved);
        std::size_t at = 0;
        for (const PointRange& range : points.ranges) {
            for (std::uint32_t p = 0; p < range.count; ++p, ++at) {
                for (std::size_t c = 0; c < texels.channels(); ++c) {
                    const double square = (*missing)[at][static_cast<int>(c)];
                    if (std::isfinite(square)) {
                        fitted.squares[range.face] += square * square;
                        counted[range.face] += 1;
                    }
                }
            }
        }
    }
    for (const PointRange& range : points.ranges) {
        fitted.squares[range.face] /= std::max(counted[range.face], 1.0);
    }
    return {};
}

Result<FittedTexels>
Coarsener::fitted(const FaceMap<Level>& levels, int steps, Threads threads, Progress& progress)
{
    TexelStore coarse = begin(levels);
    FittedTexels fitted;
    fitted.isMoved = movable(coarse);
    fitted.squares = FaceMap<double>(coarse.faceCount(), 0);
    for (std::uint32_t f = 0; f < coarse.faceCount(); ++f) {
        const auto& found = m_found[static_cast<std::size_t>(levels[faceId(f)].log2())];
        if (fitted.isMoved[faceId(f)] != 0 && found.size() > 0 && found[faceId(f)]) {
            coarse.exchange(faceId(f), *found[faceId(f)]);
        }
    }
    const Points points = pointsFor(coarse, fitted.isMoved);
    if (points.queries.size() > 0) {
        if (const Status status = move(coarse, points, steps, fitted, threads, progress); !status) {
            return tl::unexpected(status.error());
        }
    }
    for (std::uint32_t f = 0; f < coarse.faceCount(); ++f) {
        const FaceTexels& face = coarse.face(faceId(f));
        if (fitted.isMoved[faceId(f)] != 0) {
            auto& found = m_found[static_cast<std::size_t>(face.level().log2())];
            if (found.size() == 0) {
                found = FaceMap<std::optional<FaceTexels>>(coarse.faceCount());
            }
            found[faceId(f)] = face;
        }
    }
    fitted.texels = inFormat(m_source, coarse, fitted.isMoved);
    return fitted;
}

} // namespace trixel
