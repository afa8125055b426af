// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/speed/peers/atlas.h"

#include "core/filter/query_ellipse.h"

namespace trixel {

AtlasSamples Atlas::samples(const FilterScene& scene, const FilterQueries& queries) const
{
    AtlasSamples out;
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const QueryEllipse ellipse = queryEllipse(scene, queries, i);
        const FaceId face = queries.face[i];
        const FaceShape& shape = scene.surface().shape(face);
        const glm::dvec2 at = position(face, ellipse.uv);
        const glm::dvec2 major =
            vector(face, shape.toUv(2 * ellipse.majorSigma * ellipse.majorAxis));
        const glm::dvec2 minor =
            vector(face, shape.toUv(2 * ellipse.minorSigma * ellipse.minorAxis()));
        out.s.push_back(static_cast<float>(at.x));
        out.t.push_back(static_cast<float>(at.y));
        out.dsdx.push_back(static_cast<float>(major.x));
        out.dtdx.push_back(static_cast<float>(major.y));
        out.dsdy.push_back(static_cast<float>(minor.x));
        out.dtdy.push_back(static_cast<float>(minor.y));
    }
    return out;
}

} // namespace trixel
