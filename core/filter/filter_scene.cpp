// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/filter_scene.h"

#include <algorithm>
#include <utility>

namespace trixel {

Result<FilterScene> FilterScene::build(std::shared_ptr<const FilterSurface> surface,
                                       const TexelStore& store,
                                       Threads threads,
                                       Progress& progress)
{
    check(surface->faceCount() == store.faceCount(), "texels of this surface");
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
