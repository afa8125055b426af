// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/conforming_pyramid.h"

#include <algorithm>
#include <array>
#include <unordered_set>
#include <vector>

namespace trixel {
namespace {

using Sum = std::array<double, kGroupChannels>;

/// Position on a face's lattice.
struct Vertex
{
    std::uint32_t i = 0;
    std::uint32_t j = 0;
};

/// Vertex number k along an edge, from its start.
Vertex onEdge(Level level, LocalEdge edge, std::uint32_t k)
{
    const std::uint32_t r = level.resolution();
    switch (edge) {
    case LocalEdge::E0:
        return {k, 0};
    case LocalEdge::E1:
        return {r - k, k};
    case LocalEdge::E2:
        break;
    }
    return {0, r - k};
}

/// Adds the face's texels around a lattice vertex and returns how many there are: 6 inside, 3 on
/// an edge, 1 at a corner.
int addTexels(const FloatMips& mips, FaceId face, Level level, int group, Vertex at, Sum& sum)
{
    struct Offset
    {
        int i, j;
        TexelHalf half;
    };
    constexpr std::array<Offset, 6> kAround = {{{0, 0, TexelHalf::Lower},
                                                {-1, 0, TexelHalf::Lower},
                                                {0, -1, TexelHalf::Lower},
                                                {-1, -1, TexelHalf::Upper},
                                                {-1, 0, TexelHalf::Upper},
                                                {0, -1, TexelHalf::Upper}}};
    const LevelTexels texels = mips.texels(face, level, group);
    int count = 0;
    for (const Offset& offset : kAround) {
        const int i = static_cast<int>(at.i) + offset.i;
        const int j = static_cast<int>(at.j) + offset.j;
        if (i < 0 || j < 0) {
            continue;
        }
        const TexelCoord coord{
            static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j), offset.half};
        if (!isValid(level, coord)) {
            continue;
        }
        const float* texel = texels.texel(texelIndex(level, coord));
        for (std::size_t c = 0; c < sum.size(); ++c) {
            sum[c] += texel[c];
        }
        ++count;
    }
    return count;
}

void store(const Sum& sum, int count, float* value)
{
    for (std::size_t c = 0; c < sum.size(); ++c) {
        value[c] = static_cast<float>(sum[c] / count);
    }
}

/// Floats of the levels below.
std::size_t levelBegin(Level level)
{
    std::size_t vertices = 0;
    for (int n = 0; n < level.log2(); ++n) {
        vertices += latticeVertexCount(Level(n));
    }
    return vertices * kGroupChannels;
}

/// Fills one group of one face, coarse levels first because finer ones interpolate them.
class FaceAverager
{
public:
    FaceAverager(const FloatMips& mips,
                 const Adjacency& adjacency,
                 const VertexRings& rings,
                 FaceId face,
                 int group,
                 float* values)
        : m_mips(mips)
        , m_adjacency(adjacency)
        , m_rings(rings)
        , m_face(face)
        , m_group(group)
        , m_values(values)
    {
    }

    void fill()
    {
        for (int n = 0; n <= m_mips.level(m_face).log2(); ++n) {
            const Level level(n);
            fillInterior(level);
            for (const LocalEdge edge : kLocalEdges) {
                fillEdge(level, edge);
            }
            for (std::uint8_t corner = 0; corner < 3; ++corner) {
                fillCorner(level, corner);
            }
        }
    }

private:
    float* value(Level level, Vertex at)
    {
        return m_values + levelBegin(level) + kGroupChannels * latticeVertex(level, at.i, at.j);
    }

    void fillInterior(Level level)
    {
        const std::uint32_t r = level.resolution();
        for (std::uint32_t j = 1; j + 1 < r; ++j) {
            for (std::uint32_t i = 1; i + j < r; ++i) {
                Sum sum{};
                const int count = addTexels(m_mips, m_face, level, m_group, {i, j}, sum);
                store(sum, count, value(level, {i, j}));
            }
        }
    }

    void fillEdge(Level level, LocalEdge edge)
    {
        const auto across = m_adjacency.neighbour(m_face, edge);
        if (across && m_mips.level(across->face) < level) {
            interpolateEdge(level, edge, m_mips.level(across->face));
            return;
        }
        const std::uint32_t r = level.resolution();
        for (std::uint32_t k = 1; k < r; ++k) {
            const Vertex at = onEdge(level, edge, k);
            Sum sum{};
            int count = addTexels(m_mips, m_face, level, m_group, at, sum);
            if (across) {
                const Vertex there = onEdge(level, across->edge, r - k);
                count += addTexels(m_mips, across->face, level, m_group, there, sum);
            }
            store(sum, count, value(level, at));
        }
    }

    void interpolateEdge(Level level, LocalEdge edge, Level base)
    {
        const int steps = level.log2() - base.log2();
        const std::uint32_t span = 1U << steps;
        for (std::uint32_t k = 1; k < level.resolution(); ++k) {
            const float* from = value(base, onEdge(base, edge, k >> steps));
            const std::uint32_t next = std::min((k >> steps) + 1, base.resolution());
            const float* to = value(base, onEdge(base, edge, next));
            const float t = static_cast<float>(k & (span - 1)) / static_cast<float>(span);
            float* result = value(level, onEdge(level, edge, k));
            for (int c = 0; c < kGroupChannels; ++c) {
                result[c] = (1 - t) * from[c] + t * to[c];
            }
        }
    }

    void fillCorner(Level level, std::uint8_t corner)
    {
        const auto ring = m_rings.corners(m_rings.ring({m_face, corner}));
        Level coarsest = level;
        for (const Corner& other : ring) {
            coarsest = std::min(coarsest, m_mips.level(other.face));
        }
        Sum sum{};
        int count = 0;
        for (const Corner& other : ring) {
            const Vertex at = onEdge(coarsest, static_cast<LocalEdge>(other.index), 0);
            count += addTexels(m_mips, other.face, coarsest, m_group, at, sum);
        }
        store(sum, count, value(level, onEdge(level, static_cast<LocalEdge>(corner), 0)));
    }

    const FloatMips& m_mips;
    const Adjacency& m_adjacency;
    const VertexRings& m_rings;
    FaceId m_face;
    int m_group;
    float* m_values;
};

} // namespace

std::shared_ptr<const ConformingPyramid::Face> ConformingPyramid::makeFace(
    const FloatMips& mips, const Adjacency& adjacency, const VertexRings& rings, FaceId id)
{
    auto face = std::make_shared<Face>();
    face->level = mips.level(id);
    face->groupSize = levelBegin(face->level) + kGroupChannels * latticeVertexCount(face->level);
    const auto groups = static_cast<std::size_t>(mips.groups());
    face->values = std::make_unique<float[]>(face->groupSize * groups);
    for (std::size_t group = 0; group < groups; ++group) {
        float* values = face->values.get() + group * face->groupSize;
        FaceAverager(mips, adjacency, rings, id, static_cast<int>(group), values).fill();
    }
    return face;
}

Result<ConformingPyramid> ConformingPyramid::build(const FloatMips& mips,
                                                   const Adjacency& adjacency,
                                                   const VertexRings& rings,
                                                   Threads threads,
                                                   Progress& progress)
{
    constexpr std::size_t kFacesBetweenReports = 4096;
    ConformingPyramid pyramid;
    pyramid.m_groups = mips.groups();
    pyramid.m_faces = FaceMap<std::shared_ptr<const Face>>(mips.faceCount());
    for (std::size_t begin = 0; begin < mips.faceCount(); begin += kFacesBetweenReports) {
        if (!progress.report(static_cast<double>(begin) / static_cast<double>(mips.faceCount()))) {
            return cancelled();
        }
        const std::size_t count = std::min(kFacesBetweenReports, mips.faceCount() - begin);
        parallelFor(count, 16, threads, [&](std::size_t from, std::size_t to) {
            for (std::size_t f = begin + from; f < begin + to; ++f) {
                pyramid.m_faces[faceId(f)] = makeFace(mips, adjacency, rings, faceId(f));
            }
        });
    }
    return pyramid;
}

void ConformingPyramid::update(const FloatMips& mips,
                               const Adjacency& adjacency,
                               const VertexRings& rings,
                               std::span<const TouchedRect> rects)
{
    std::unordered_set<std::uint32_t> touched;
    for (const TouchedRect& rect : rects) {
        for (std::uint8_t corner = 0; corner < 3; ++corner) {
            for (const Corner& other : rings.corners(rings.ring({rect.face, corner}))) {
                touched.insert(static_cast<std::uint32_t>(other.face));
            }
        }
    }
    for (const std::uint32_t face : touched) {
        m_faces[faceId(face)] = makeFace(mips, adjacency, rings, faceId(face));
    }
}

LevelVertices ConformingPyramid::vertices(FaceId face, Level level, int group) const
{
    const Face& own = *m_faces[face];
    check(level <= own.level, "a level that the face has");
    return {own.values.get() + static_cast<std::size_t>(group) * own.groupSize + levelBegin(level)};
}

std::uint64_t ConformingPyramid::valueCount() const
{
    std::uint64_t count = 0;
    for (const auto& face : m_faces.values()) {
        count += face->groupSize / kGroupChannels * static_cast<std::size_t>(m_groups);
    }
    return count;
}

std::size_t ConformingPyramid::memoryBytes() const
{
    std::unordered_set<const Face*> counted;
    std::size_t bytes = m_faces.size() * sizeof(std::shared_ptr<const Face>);
    for (const auto& face : m_faces.values()) {
        if (counted.insert(face.get()).second) {
            bytes +=
                sizeof(Face) + face->groupSize * static_cast<std::size_t>(m_groups) * sizeof(float);
        }
    }
    return bytes;
}

} // namespace trixel
