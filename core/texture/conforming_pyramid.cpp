// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/conforming_pyramid.h"

#include "core/texture/pyramid_sharing.h"
#include "core/texture/pyramid_update.h"

#include <algorithm>
#include <unordered_set>

namespace trixel {

/// Fills blocks from nothing. Faces do not depend on each other's averages, so that several threads
/// may fill several of them.
class ConformingPyramid::Builder
{
public:
    Builder(const FloatMips& mips, const Adjacency& adjacency, const VertexRings& rings)
        : m_mips(mips)
        , m_adjacency(adjacency)
        , m_rings(rings)
    {
    }

    /// A row of vertices of one level, inside the face.
    void fillRow(FaceId face, Level level, std::uint32_t j, float* block) const
    {
        for (int group = 0; group < m_mips.groups(); ++group) {
            float* values = levelOf(block, face, level, group);
            averages(group).row(face, level, j, 0, level.resolution(), values);
        }
    }

    void fillInside(FaceId face, Level level, float* block) const
    {
        for (std::uint32_t j = 1; j + 1 < level.resolution(); ++j) {
            fillRow(face, level, j, block);
        }
    }

    void fillBoundary(FaceId face, float* block) const
    {
        for (int group = 0; group < m_mips.groups(); ++group) {
            for (const LocalEdge edge : kLocalEdges) {
                fillEdge(face, edge, group, block);
            }
        }
    }

private:
    VertexAverages averages(int group) const { return {m_mips, m_adjacency, m_rings, group}; }

    float* levelOf(float* block, FaceId face, Level level, int group) const
    {
        return block + static_cast<std::size_t>(group) * groupSize(m_mips.level(face)) +
               levelBegin(level);
    }

    /// An edge and the corner it starts at. The corner it ends at is needed for what is derived.
    void fillEdge(FaceId face, LocalEdge edge, int group, float* block) const
    {
        const VertexAverages rules = averages(group);
        const Level own = m_mips.level(face);
        const Level base = rules.edgeBase(face, edge);
        for (const LocalEdge at : {edge, nextEdge(edge)}) {
            const auto corner = static_cast<std::uint8_t>(at);
            const Level ringBase = rules.ringBase(face, corner);
            for (int n = 0; n <= own.log2(); ++n) {
                float* values = levelOf(block, face, Level(n), group);
                rules.atCorner(face, corner, ringBase, Level(n), values);
            }
        }
        const float* baseValues = levelOf(block, face, base, group);
        for (int n = 0; n <= own.log2(); ++n) {
            const Level level(n);
            float* values = levelOf(block, face, level, group);
            for (std::uint32_t k = 1; k < level.resolution(); ++k) {
                if (level <= base) {
                    rules.onEdgeOf(face, edge, level, k, values);
                } else {
                    VertexAverages::derive(edge, base, baseValues, level, k, values);
                }
            }
        }
    }

    const FloatMips& m_mips;
    const Adjacency& m_adjacency;
    const VertexRings& m_rings;
};

namespace {

/// Levels from here on are filled row by row, so that one large face keeps all threads busy.
constexpr int kLarge = 8;

/// Part of the building that one thread does.
struct Task
{
    FaceId face{};
    float* block = nullptr;
    int level = -1; ///< of the rows; -1: all that is not done row by row
    std::uint32_t row = 0;
};

constexpr std::uint32_t kRowsPerTask = 32;

void addTasks(FaceId face, Level level, float* block, std::vector<Task>& tasks)
{
    tasks.push_back({face, block, -1, 0});
    for (int n = kLarge; n <= level.log2(); ++n) {
        for (std::uint32_t row = 1; row + 1 < Level(n).resolution(); row += kRowsPerTask) {
            tasks.push_back({face, block, n, row});
        }
    }
}

template <class Builder>
void run(const Task& task, Level base, const Builder& builder)
{
    if (task.level < 0) {
        for (int n = 0; n <= std::min(base.log2(), kLarge - 1); ++n) {
            builder.fillInside(task.face, Level(n), task.block);
        }
        builder.fillBoundary(task.face, task.block);
        return;
    }
    const Level level(task.level);
    const std::uint32_t end = std::min(task.row + kRowsPerTask, level.resolution() - 1);
    for (std::uint32_t j = task.row; j < end; ++j) {
        builder.fillRow(task.face, level, j, task.block);
    }
}

} // namespace

Result<ConformingPyramid> ConformingPyramid::build(const FloatMips& mips,
                                                   const Adjacency& adjacency,
                                                   const VertexRings& rings,
                                                   Threads threads,
                                                   Progress& progress)
{
    ConformingPyramid pyramid;
    pyramid.m_groups = mips.groups();
    pyramid.m_blocks = SharedBlocks(mips.faceCount());
    const PyramidSharing sharing(mips, adjacency, rings);
    const std::vector<FaceId> first = sharing.firstAlike(threads);
    std::vector<Task> tasks;
    for (std::size_t f = 0; f < mips.faceCount(); ++f) {
        const FaceId face = faceId(f);
        if (first[f] != face) {
            pyramid.m_blocks.share(face, first[f]);
        } else if (sharing.isConstant(face)) {
            const auto groups = static_cast<std::size_t>(mips.groups());
            float* values =
                pyramid.m_blocks.renew(face, mips.level(face), true, kConstantSize * groups);
            for (std::size_t group = 0; group < groups; ++group) {
                const float* value = mips.average(face, static_cast<int>(group));
                float* to = values + group * kConstantSize;
                for (std::size_t k = 0; k < kConstantSize; k += kGroupChannels) {
                    std::copy_n(value, kGroupChannels, to + k);
                }
            }
        } else {
            const std::size_t size = groupSize(mips.level(face));
            float* block = pyramid.m_blocks.renew(
                face, mips.level(face), false, size * static_cast<std::size_t>(mips.groups()));
            addTasks(face, mips.level(face), block, tasks);
        }
    }
    const Builder builder(mips, adjacency, rings);
    constexpr std::size_t kTasksBetweenReports = 4096;
    for (std::size_t begin = 0; begin < tasks.size(); begin += kTasksBetweenReports) {
        if (!progress.report(static_cast<double>(begin) / static_cast<double>(tasks.size()))) {
            return cancelled();
        }
        const std::size_t count = std::min(kTasksBetweenReports, tasks.size() - begin);
        parallelFor(count, 4, threads, [&](std::size_t from, std::size_t to) {
            for (std::size_t t = begin + from; t < begin + to; ++t) {
                run(tasks[t], mips.level(tasks[t].face), builder);
            }
        });
    }
    return pyramid;
}

float* ConformingPyramid::spreadOut(FaceId face)
{
    if (!m_blocks.block(face).constant) {
        return m_blocks.writable(face);
    }
    const SharedBlocks::Block shared = m_blocks.block(face);
    const std::size_t size = groupSize(shared.level);
    float* values =
        m_blocks.renew(face, shared.level, false, size * static_cast<std::size_t>(m_groups));
    for (std::size_t group = 0; group < static_cast<std::size_t>(m_groups); ++group) {
        const float* value = shared.values.get() + group * kConstantSize;
        for (std::size_t k = 0; k < size; ++k) {
            values[group * size + k] = value[k % kGroupChannels];
        }
    }
    return values;
}

std::size_t ConformingPyramid::update(const FloatMips& mips,
                                      const Adjacency& adjacency,
                                      const VertexRings& rings,
                                      std::span<const TouchedRect> rects)
{
    // Another level changes the rules for all about it.
    std::unordered_set<std::uint32_t> renewed;
    for (const TouchedRect& rect : rects) {
        if (mips.level(rect.face) == level(rect.face)) {
            continue;
        }
        for (std::uint8_t corner = 0; corner < 3; ++corner) {
            for (const Corner& other : rings.corners(rings.ring({rect.face, corner}))) {
                renewed.insert(static_cast<std::uint32_t>(other.face));
            }
        }
    }
    std::size_t count = 0;
    const Builder builder(mips, adjacency, rings);
    const auto groups = static_cast<std::size_t>(m_groups);
    for (const std::uint32_t number : renewed) {
        const FaceId face = faceId(number);
        const Level base = mips.level(face);
        float* block = m_blocks.renew(face, base, false, groupSize(base) * groups);
        for (int n = 0; n <= base.log2(); ++n) {
            builder.fillInside(face, Level(n), block);
        }
        builder.fillBoundary(face, block);
        count += groupSize(base) / kGroupChannels * groups;
    }
    for (std::size_t group = 0; group < groups; ++group) {
        const auto writable = [&](FaceId face, Level level) {
            return spreadOut(face) + group * groupSize(this->level(face)) + levelBegin(level);
        };
        PyramidUpdate update(mips, adjacency, rings, static_cast<int>(group), writable);
        for (const TouchedRect& rect : rects) {
            update.touch(rect.face, rect);
        }
        update.derive();
        count += update.count();
    }
    return count;
}

std::uint64_t ConformingPyramid::valueCount() const
{
    std::uint64_t count = 0;
    for (std::size_t f = 0; f < faceCount(); ++f) {
        count += groupSize(level(faceId(f))) / kGroupChannels * static_cast<std::size_t>(m_groups);
    }
    return count;
}

} // namespace trixel
