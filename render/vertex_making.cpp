// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/vertex_making.h"

#include "core/base/check.h"
#include "core/texture/convert.h"
#include "core/texture/face_vertices.h"
#include "core/texture/pinned_face.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace trixel::render {

namespace {

constexpr std::size_t kGrain = 1U << 12U;
/// Of mips that a thread keeps.
constexpr std::size_t kChainBytes = 32U << 20U;

using Mean = std::array<float, kGroupChannels>;

/// Of every face: its texel of level 0.
std::vector<Mean> meansOf(const TexelStore& store, const CardChannels& channels, Threads threads)
{
    std::vector<Mean> means(store.faceCount());
    parallelFor(means.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
        std::vector<float> chain;
        for (std::size_t f = begin; f < end; ++f) {
            const FaceTexels& face = store.face(faceId(f));
            const auto mean = face.mean();
            const FaceTexels one = mean ? FaceTexels::constant(Level(), *mean) : FaceTexels();
            const FaceTexels& read = mean ? one : face;
            chain.resize(chainSize(read.level(), read.isConstant()));
            fillChain(store.format(), channels, read, chain.data());
            std::copy_n(chain.end() - kGroupChannels, kGroupChannels, means[f].begin());
        }
    });
    return means;
}

/// Of every ring: the vertex where its faces meet.
std::vector<Mean>
cornersOf(const VertexRings& rings, const std::vector<Mean>& means, Threads threads)
{
    std::vector<Mean> corners(rings.ringCount());
    parallelFor(corners.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t r = begin; r < end; ++r) {
            std::array<double, kGroupChannels> sum{};
            const auto about = rings.corners(static_cast<RingId>(r));
            for (const Corner& corner : about) {
                for (std::size_t c = 0; c < sum.size(); ++c) {
                    sum[c] += means[indexOf(corner.face)][c];
                }
            }
            for (std::size_t c = 0; c < sum.size(); ++c) {
                corners[r][c] = static_cast<float>(sum[c] / static_cast<double>(about.size()));
            }
        }
    });
    return corners;
}

} // namespace

std::unique_ptr<ChainCache> SharedChains::take()
{
    const std::lock_guard lock(m_mutex);
    if (m_spare.empty()) {
        return std::make_unique<ChainCache>(m_channels, kChainBytes);
    }
    std::unique_ptr<ChainCache> chains = std::move(m_spare.back());
    m_spare.pop_back();
    return chains;
}

void SharedChains::giveBack(std::unique_ptr<ChainCache> chains)
{
    const std::lock_guard lock(m_mutex);
    m_spare.push_back(std::move(chains));
}

CardOpening
openVertices(const TexelStore& store, const CardForm& form, const FilterMesh& mesh, Threads threads)
{
    check(mesh.faceCount() == store.faceCount(), "texels of this mesh");
    const std::vector<Mean> corners =
        cornersOf(mesh.rings(), meansOf(store, form.channels, threads), threads);
    constexpr std::size_t kCorners = 3;
    const std::size_t baseBytes = kCorners * form.elementBytes();
    ChainCache none(form.channels, 0);
    const FaceMips mips(store, none, form.mipDrop);
    const FaceVertices about(mips, mesh.adjacency(), mesh.rings());
    CardOpening opening;
    opening.form = form;
    opening.faces.resize(store.faceCount());
    opening.bases.resize(store.faceCount() * baseBytes);
    parallelFor(store.faceCount(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
        std::vector<float> values;
        values.reserve((end - begin) * kCorners * kGroupChannels);
        for (std::size_t f = begin; f < end; ++f) {
            const int level = form.shownLevel(store.face(faceId(f))).log2();
            opening.faces[f] = static_cast<std::uint8_t>(
                level | CardOpening::kMean |
                (about.isConstant(faceId(f)) ? CardOpening::kConstant : 0));
            for (const std::uint8_t corner : {std::uint8_t{0}, std::uint8_t{1}, std::uint8_t{2}}) {
                const Mean& value = corners[indexOf(mesh.rings().ring({faceId(f), corner}))];
                values.insert(values.end(), value.begin(), value.end());
            }
        }
        encode(form.format.type,
               values,
               std::span(opening.bases).subspan(begin * baseBytes, (end - begin) * baseBytes));
    });
    return opening;
}

MadeBlocks makeVertexBlocks(const TexelStore& store,
                            const CardForm& form,
                            const FilterMesh& mesh,
                            std::span<const BlockJob> jobs,
                            SharedChains& shared)
{
    MadeBlocks made;
    made.jobs.assign(jobs.begin(), jobs.end());
    made.ends.reserve(jobs.size());
    std::unique_ptr<ChainCache> chains = shared.take();
    {
        const FaceMips mips(store, *chains, form.mipDrop);
        const FaceVertices vertices(mips, mesh.adjacency(), mesh.rings());
        for (const BlockJob& job : jobs) {
            const Level level(job.level);
            if (level <= vertices.level(job.face) &&
                (job.level == 0 || !vertices.isConstant(job.face))) {
                chains->readAt(level);
                vertices.appendBlock(job.face, level, made.bytes);
            }
            made.ends.push_back(made.bytes.size());
            chains->trim();
        }
    }
    shared.giveBack(std::move(chains));
    return made;
}

FaceExtents vertexExtents(const TriangleMesh& mesh, const FilterMesh& filterMesh, Threads threads)
{
    // `levelFor` of resources/shaders/filter_vertices.glsl: what is averaged is a quarter of a
    // pixel's square at least, and so a texel's edge 0.866 of a pixel.
    constexpr float kFiner = 1.1548F;
    FaceExtents faces = FaceExtents::of(mesh, threads);
    parallelFor(faces.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
            float most = -1e30F;
            for (const std::uint32_t vertex : mesh.triangles[f]) {
                most = std::max(most, filterMesh.scales()[vertex].log2Length);
            }
            faces.edge[f] = kFiner * std::exp2(most);
        }
    });
    return faces;
}

} // namespace trixel::render
