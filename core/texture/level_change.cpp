// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/level_change.h"

#include "core/mesh/vertex_rings.h"
#include "core/texture/mips.h"
#include "core/texture/pinned_face.h"
#include "core/texture/refinement.h"

#include <algorithm>
#include <unordered_map>
#include <utility>
#include <vector>

namespace trixel {
namespace {

/// The faces that grow and all that meet them at a vertex, cut out of the mesh: what their averages
/// are made of. Faces are numbered anew, the growing ones first.
class Cutout
{
public:
    Cutout(const Adjacency& adjacency, std::span<const FaceId> growing)
    {
        for (const FaceId face : growing) {
            add(face);
        }
        // A vertex is shared where faces are connected about it: walk around each corner.
        for (const FaceId face : growing) {
            for (const LocalEdge edge : kLocalEdges) {
                walk(adjacency, face, edge);
            }
        }
        m_adjacency = Adjacency(m_faces.size());
        for (std::uint32_t f = 0; f < m_faces.size(); ++f) {
            connect(adjacency, f);
        }
        m_rings = VertexRings(m_adjacency);
    }

    std::span<const FaceId> faces() const { return m_faces; }
    const Adjacency& adjacency() const { return m_adjacency; }
    const VertexRings& rings() const { return m_rings; }

private:
    void add(FaceId face)
    {
        const auto next = static_cast<std::uint32_t>(m_faces.size());
        if (m_numbers.try_emplace(static_cast<std::uint32_t>(face), next).second) {
            m_faces.push_back(face);
        }
    }

    /// Adds the faces about the start of an edge, first one way round, then the other.
    void walk(const Adjacency& adjacency, FaceId face, LocalEdge edge)
    {
        const LocalEdge before = nextEdge(nextEdge(edge));
        auto across = adjacency.neighbour(face, before);
        while (across && *across != EdgeNeighbour{face, edge}) {
            add(across->face);
            across = adjacency.neighbour(across->face, nextEdge(nextEdge(across->edge)));
        }
        if (across) {
            return; // all the way round
        }
        across = adjacency.neighbour(face, edge);
        while (across) { // to the border
            add(across->face);
            across = adjacency.neighbour(across->face, nextEdge(across->edge));
        }
    }

    void connect(const Adjacency& adjacency, std::uint32_t number)
    {
        for (const LocalEdge edge : kLocalEdges) {
            const auto across = adjacency.neighbour(m_faces[number], edge);
            const auto other =
                across ? m_numbers.find(static_cast<std::uint32_t>(across->face)) : m_numbers.end();
            if (other != m_numbers.end()) {
                m_adjacency.connect(faceId(number), edge, faceId(other->second), across->edge);
            }
        }
    }

    std::vector<FaceId> m_faces;
    std::unordered_map<std::uint32_t, std::uint32_t> m_numbers;
    Adjacency m_adjacency;
    VertexRings m_rings;
};

TexelStore cutOut(const TexelStore& store,
                  std::span<const FaceId> faces,
                  const AveragedAs* averaged,
                  Threads threads)
{
    const TexelFormat& format = averaged != nullptr ? averaged->format : store.format();
    std::vector<FaceTexels> texels(faces.size());
    parallelFor(faces.size(), 64, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const FaceTexels& face = store.face(faces[k]);
            texels[k] = averaged != nullptr ? averaged->into(*PinnedFace(face)) : face;
        }
    });
    TexelStore part(static_cast<std::uint32_t>(faces.size()),
                    format,
                    Level(0),
                    std::vector<std::byte>(format.texelBytes()));
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
        part.exchange(faceId(f), std::move(texels[f]));
    }
    return part;
}

/// The face at its new level, as the store has it. \param there  its texels as averaged
FaceTexels broughtBack(const FaceTexels& before, FaceTexels there, const AveragedAs* averaged)
{
    if (averaged == nullptr) {
        return there;
    }
    return before.isConstant() ? before.atLevel(there.level()) : averaged->outOf(there);
}

/// What stands in for a face that could not be read is not to be taken for paint.
Status checkRead(const TexelStore& store, std::span<const FaceId> faces)
{
    for (const FaceId face : faces) {
        if (store.face(face).isDamaged()) {
            return contentsError("face " + std::to_string(indexOf(face)) +
                                 " could not be read from its file; fill it before levels change "
                                 "there");
        }
    }
    return {};
}

Result<ConformingPyramid> pyramidOf(const Cutout& cutout, const TexelStore& part, Threads threads)
{
    NoProgress unseen; // the rounds report
    const auto mips = FloatMips::build(part, threads, unseen);
    if (!mips) {
        return tl::unexpected(mips.error());
    }
    return ConformingPyramid::build(*mips, cutout.adjacency(), cutout.rings(), threads, unseen);
}

FaceTexels refinedBy(const ConformingPyramid& pyramid,
                     const TexelFormat& format,
                     const FaceTexels& texels,
                     FaceId face)
{
    std::vector<LevelVertices> groups;
    for (int group = 0; group * kGroupChannels < format.channels; ++group) {
        groups.push_back(pyramid.vertices(face, texels.level(), group));
    }
    return refined(format, texels, groups);
}

/// The faces at their finer levels, in the order given.
Result<std::vector<FaceTexels>> grown(const TexelStore& store,
                                      const Adjacency& adjacency,
                                      std::span<const FaceId> faces,
                                      const FaceMap<Level>& levels,
                                      const AveragedAs* averaged,
                                      Threads threads,
                                      Progress& progress)
{
    if (faces.empty()) {
        return std::vector<FaceTexels>();
    }
    const Cutout cutout(adjacency, faces);
    TexelStore part = cutOut(store, cutout.faces(), averaged, threads);
    std::vector<std::uint32_t> left(faces.size());
    for (std::uint32_t k = 0; k < faces.size(); ++k) {
        left[k] = k;
    }
    const auto isReached = [&](std::uint32_t k) {
        return part.face(faceId(k)).level() == levels[faces[k]];
    };
    for (int round = 0; !left.empty(); ++round) {
        if (!progress.report(round / double{Level::kMax})) {
            return cancelled();
        }
        const auto pyramid = pyramidOf(cutout, part, threads);
        if (!pyramid) {
            return tl::unexpected(pyramid.error());
        }
        std::vector<FaceTexels> finer(left.size());
        parallelFor(left.size(), 8, threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                const PinnedFace pin(part.face(faceId(left[k])));
                finer[k] = refinedBy(*pyramid, part.format(), *pin, faceId(left[k]));
            }
        });
        for (std::size_t k = 0; k < left.size(); ++k) {
            part.exchange(faceId(left[k]), std::move(finer[k]));
        }
        std::erase_if(left, isReached);
    }
    if (Status status = checkRead(store, cutout.faces()); !status) {
        return tl::unexpected(status.error());
    }
    std::vector<FaceTexels> result(faces.size());
    parallelFor(faces.size(), 64, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            result[k] = broughtBack(store.face(faces[k]), part.face(faceId(k)), averaged);
        }
    });
    return result;
}

Result<std::vector<FaceTexels>> shrunk(const TexelStore& store,
                                       std::span<const FaceId> faces,
                                       const FaceMap<Level>& levels,
                                       const AveragedAs* averaged,
                                       Threads threads,
                                       Progress& progress)
{
    constexpr std::size_t kFacesBetweenReports = 4096;
    std::vector<FaceTexels> result(faces.size());
    for (std::size_t begin = 0; begin < faces.size(); begin += kFacesBetweenReports) {
        if (!progress.report(static_cast<double>(begin) / static_cast<double>(faces.size()))) {
            return cancelled();
        }
        const std::size_t count = std::min(kFacesBetweenReports, faces.size() - begin);
        parallelFor(count, 16, threads, [&](std::size_t from, std::size_t to) {
            for (std::size_t k = begin + from; k < begin + to; ++k) {
                const FaceTexels& face = store.face(faces[k]);
                const int steps = face.level().log2() - levels[faces[k]].log2();
                result[k] = averaged == nullptr || face.isConstant()
                                ? reduced(store.format(), face, steps)
                                : averaged->outOf(reduced(
                                      averaged->format, averaged->into(*PinnedFace(face)), steps));
            }
        });
    }
    if (Status status = checkRead(store, faces); !status) {
        return tl::unexpected(status.error());
    }
    return result;
}

void exchangeAll(TexelStore& store,
                 std::span<const FaceId> faces,
                 std::vector<FaceTexels>& texels,
                 TexelPatch& patch)
{
    for (std::size_t k = 0; k < faces.size(); ++k) {
        patch.addFace(faces[k], store.exchange(faces[k], std::move(texels[k])));
    }
}

} // namespace

Level LevelChange::appliedTo(Level before) const
{
    switch (kind) {
    case Kind::Halve:
        return before.coarser();
    case Kind::Double:
        return Level(std::min(before.log2() + 1, Level::kMax));
    case Kind::Set:
        break;
    }
    return level;
}

FaceMap<Level> levelsOf(const TexelStore& store)
{
    FaceMap<Level> levels(store.faceCount());
    for (std::uint32_t f = 0; f < store.faceCount(); ++f) {
        levels[faceId(f)] = store.face(faceId(f)).level();
    }
    return levels;
}

FaceMap<Level>
changedLevels(const TexelStore& store, std::span<const FaceId> faces, LevelChange change)
{
    FaceMap<Level> levels = levelsOf(store);
    for (const FaceId face : faces) {
        levels[face] = change.appliedTo(levels[face]);
    }
    return levels;
}

LevelCost levelCost(const TexelStore& store, const FaceMap<Level>& levels)
{
    check(levels.size() == store.faceCount(), "a level for every face");
    LevelCost cost;
    for (std::uint32_t f = 0; f < store.faceCount(); ++f) {
        const Level before = store.face(faceId(f)).level();
        cost.texelsBefore += before.texelCount();
        cost.texelsAfter += levels[faceId(f)].texelCount();
        cost.changedFaces += before == levels[faceId(f)] ? 0 : 1;
    }
    cost.bytesBefore = cost.texelsBefore * store.format().texelBytes();
    cost.bytesAfter = cost.texelsAfter * store.format().texelBytes();
    return cost;
}

Result<TexelPatch> changeLevels(TexelStore& store,
                                const Adjacency& adjacency,
                                const FaceMap<Level>& levels,
                                Threads threads,
                                Progress& progress,
                                const AveragedAs* averaged)
{
    check(levels.size() == store.faceCount() && adjacency.faceCount() == store.faceCount(),
          "a level for every face");
    std::vector<FaceId> coarser;
    std::vector<FaceId> finer;
    for (std::uint32_t f = 0; f < store.faceCount(); ++f) {
        const Level before = store.face(faceId(f)).level();
        if (levels[faceId(f)] != before) {
            (levels[faceId(f)] < before ? coarser : finer).push_back(faceId(f));
        }
    }
    StageProgress growing(progress, 0, 0.7);
    auto grownTexels = grown(store, adjacency, finer, levels, averaged, threads, growing);
    if (!grownTexels) {
        return tl::unexpected(grownTexels.error());
    }
    StageProgress shrinking(progress, 0.7, 1);
    auto shrunkTexels = shrunk(store, coarser, levels, averaged, threads, shrinking);
    if (!shrunkTexels) {
        return tl::unexpected(shrunkTexels.error());
    }
    TexelPatch patch;
    exchangeAll(store, finer, *grownTexels, patch);
    exchangeAll(store, coarser, *shrunkTexels, patch);
    return patch;
}

} // namespace trixel
