// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/filter/filter_surface.h"
#include "core/texture/conforming_pyramid.h"
#include "core/texture/float_mips.h"
#include "core/texture/texel_store.h"
#include "core/texture/touched_rect.h"

#include <memory>
#include <span>
#include <vector>

namespace trixel {

/// Everything that filters read: a cache of the texel store on a surface.
class FilterScene
{
public:
    /// \param store  as many faces as the surface (checked). Fails when cancelled, and before any
    ///               work when texels that still lie in a file would take more than half of the
    ///               machine's memory.
    static Result<FilterScene> build(std::shared_ptr<const FilterSurface> surface,
                                     const TexelStore& store,
                                     Threads threads,
                                     Progress& progress);

    /// Takes over what changed; levels may have changed where a rect says `wholeFace`.
    void update(const TexelStore& store, std::span<const TouchedRect> rects);

    const FilterSurface& surface() const { return *m_surface; }
    const FloatMips& mips() const { return m_mips; }
    const ConformingPyramid& pyramid() const { return m_pyramid; }
    std::size_t faceCount() const { return m_mips.faceCount(); }
    int channels() const { return m_mips.channels(); }
    Level level(FaceId face) const { return m_mips.level(face); }

    /// log2 of the edge of a base-level texel at a point, in the surface's units: continuous over
    /// the mesh, because it interpolates one number a vertex (`FilterSurface::log2Length` less the
    /// mean level of the ring's faces). On equal equilateral faces it is -level.
    double log2TexelSize(FaceId face, glm::dvec2 uv) const;
    double log2TexelSize(FaceId face, int corner) const
    {
        return m_log2TexelSizes[indexOf(
            m_surface->rings().ring({face, static_cast<std::uint8_t>(corner)}))];
    }

private:
    void measureTexels();

    std::shared_ptr<const FilterSurface> m_surface;
    FloatMips m_mips;
    ConformingPyramid m_pyramid;
    std::vector<double> m_log2TexelSizes; // of each ring
};

} // namespace trixel
