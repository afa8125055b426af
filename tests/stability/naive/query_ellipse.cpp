// SPDX-License-Identifier: GPL-3.0-or-later
//
// Neither limits W nor asks whether it is a number; in single precision.
#include "core/filter/query_ellipse.h"

#include "core/study/stability/naive_forms.h"

#include <cmath>

namespace trixel {

glm::dvec2 broughtInside(glm::dvec2 uv)
{
    return uv;
}

QueryEllipse
queryEllipse(const FilterScene& scene, FaceId face, glm::dvec2 uv, glm::dvec2 w1, glm::dvec2 w2)
{
    const FaceShape& shape = scene.surface().shape(face);
    const CovarianceAxes axes =
        naive::singlePrecisionAxes(glm::vec2(shape.toPlane(w1)), glm::vec2(shape.toPlane(w2)));
    QueryEllipse ellipse;
    ellipse.uv = uv;
    ellipse.centre = shape.toPlane(uv);
    ellipse.majorSigma = axes.majorSigma;
    ellipse.minorSigma = axes.minorSigma;
    ellipse.majorAxis = axes.majorAxis;
    ellipse.determinant = axes.majorSigma * axes.majorSigma * axes.minorSigma * axes.minorSigma;
    return ellipse;
}

QueryEllipse queryEllipse(const FilterScene& scene, const FilterQueries& queries, std::size_t index)
{
    return queryEllipse(scene,
                        queries.face[index],
                        {queries.u[index], queries.v[index]},
                        {queries.uw1[index], queries.vw1[index]},
                        {queries.uw2[index], queries.vw2[index]});
}

} // namespace trixel
