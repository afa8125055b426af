// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/query_ellipse.h"

#include "core/footprint/covariance.h"
#include "core/footprint/limit.h"

#include <cmath>

namespace trixel {
namespace {

bool isFinite(glm::dvec2 v)
{
    return std::isfinite(v.x) && std::isfinite(v.y);
}

} // namespace

glm::dvec2 broughtInside(glm::dvec2 uv)
{
    uv.x = uv.x < 0 ? 0 : uv.x;
    uv.y = uv.y < 0 ? 0 : uv.y;
    const double sum = uv.x + uv.y;
    return sum > 1 ? uv / sum : uv;
}

QueryEllipse
queryEllipse(const FilterScene& scene, FaceId face, glm::dvec2 uv, glm::dvec2 w1, glm::dvec2 w2)
{
    QueryEllipse ellipse;
    ellipse.hasCentre = isFinite(uv);
    ellipse.uv = ellipse.hasCentre ? broughtInside(uv) : glm::dvec2(1.0 / 3.0);
    const FaceShape& shape = scene.surface().shape(face);
    ellipse.centre = shape.toPlane(ellipse.uv);
    ellipse.log2Texel = scene.log2TexelSize(face, ellipse.uv);
    ellipse.log2Edge = scene.surface().log2Length(face, ellipse.uv);

    // Half of each W: conjugate half axes of the ellipse.
    glm::dvec2 a;
    glm::dvec2 b;
    if (isFinite(w1) && isFinite(w2)) {
        a = shape.toPlane(limitedVector(w1, kWidestFootprint)) / 2.0;
        b = shape.toPlane(limitedVector(w2, kWidestFootprint)) / 2.0;
    } else {
        const double widest = kWidestFootprint * std::exp2(ellipse.log2Edge) / 2;
        a = {widest, 0};
        b = {0, widest};
    }
    const double floor = std::exp2(2 * ellipse.log2Texel) / 4;
    const Covariance covariance = covarianceOf(a, b, floor);
    ellipse.xx = covariance.xx;
    ellipse.xy = covariance.xy;
    ellipse.yy = covariance.yy;
    ellipse.determinant = covariance.determinant;
    const CovarianceAxes axes = axesOf(covariance);
    ellipse.majorAxis = axes.majorAxis;
    ellipse.majorSigma = axes.majorSigma;
    ellipse.minorSigma = axes.minorSigma;
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
