// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/filter_scene.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <unistd.h>
#include <utility>

namespace trixel {

namespace {

std::uint64_t machineBytes()
{
    return static_cast<std::uint64_t>(std::max(0L, ::sysconf(_SC_PHYS_PAGES))) *
           static_cast<std::uint64_t>(std::max(0L, ::sysconf(_SC_PAGESIZE)));
}

/// What is in memory already fits as floats, or nearly; but a file that is read face by face can
/// hold far more texels.
Status checkRoom(const TexelStore& store)
{
    const TexelFormat& format = store.format();
    std::uint64_t texels = 0;
    for (std::uint32_t f = 0; f < store.faceCount(); ++f) {
        const FaceTexels& face = store.face(faceId(f));
        texels += face.isStored() ? face.level().texelCount() : 0;
    }
    const auto groups =
        static_cast<std::uint64_t>((format.channels + kGroupChannels - 1) / kGroupChannels);
    // Four thirds of a texel and about as much again of vertices.
    const std::uint64_t bytes = texels * groups * sizeof(float) * kGroupChannels * 8 / 3;
    if (bytes > machineBytes() / 2) {
        return contentsError("the filters would need " + std::to_string(bytes >> 20U) +
                             " MiB of memory for all these texels, more than half of the " +
                             std::to_string(machineBytes() >> 20U) + " MiB there are");
    }
    return {};
}

} // namespace

Result<FilterScene> FilterScene::build(std::shared_ptr<const FilterSurface> surface,
                                       const TexelStore& store,
                                       Threads threads,
                                       Progress& progress)
{
    check(surface->faceCount() == store.faceCount(), "texels of this surface");
    if (Status status = checkRoom(store); !status) {
        return tl::unexpected(status.error());
    }
    FilterScene scene;
    scene.m_surface = std::move(surface);
    StageProgress mipProgress(progress, 0.0, 0.5);
    auto mips = FloatMips::build(store, threads, mipProgress);
    if (!mips) {
        return tl::unexpected(mips.error());
    }
    scene.m_mips = std::move(*mips);
    StageProgress pyramidProgress(progress, 0.5, 1.0);
    auto pyramid = ConformingPyramid::build(scene.m_mips,
                                            scene.m_surface->adjacency(),
                                            scene.m_surface->rings(),
                                            threads,
                                            pyramidProgress);
    if (!pyramid) {
        return tl::unexpected(pyramid.error());
    }
    scene.m_pyramid = std::move(*pyramid);
    scene.measureTexels();
    return scene;
}

void FilterScene::update(const TexelStore& store, std::span<const TouchedRect> rects)
{
    const bool levelsChange = std::ranges::any_of(rects, [&](const TouchedRect& rect) {
        return store.face(rect.face).level() != level(rect.face);
    });
    m_mips.update(store, rects);
    m_pyramid.update(m_mips, m_surface->adjacency(), m_surface->rings(), rects);
    if (levelsChange) {
        measureTexels();
    }
}

double FilterScene::log2TexelSize(FaceId face, glm::dvec2 uv) const
{
    return (1 - uv.x - uv.y) * log2TexelSize(face, 0) + uv.x * log2TexelSize(face, 1) +
           uv.y * log2TexelSize(face, 2);
}

void FilterScene::measureTexels()
{
    const VertexRings& rings = m_surface->rings();
    m_log2TexelSizes.resize(rings.ringCount());
    for (std::size_t r = 0; r < rings.ringCount(); ++r) {
        const auto corners = rings.corners(static_cast<RingId>(r));
        double levels = 0;
        for (const Corner& corner : corners) {
            levels += level(corner.face).log2();
        }
        m_log2TexelSizes[r] = m_surface->log2Length(corners.front().face, corners.front().index) -
                              levels / static_cast<double>(corners.size());
    }
}

} // namespace trixel
