// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/query_ellipse.h"

#include "core/footprint/svd2.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace trixel {
namespace {

bool isFinite(glm::dvec2 v)
{
    return std::isfinite(v.x) && std::isfinite(v.y);
}

/// Scaled by its larger component first, so that no square overflows or vanishes.
glm::dvec2 limited(glm::dvec2 w)
{
    const double largest = std::max(std::abs(w.x), std::abs(w.y));
    if (largest <= kWidestFootprint / 2) {
        return w;
    }
    const glm::dvec2 unit = w / largest;
    const double length = largest * glm::length(unit);
    return length > kWidestFootprint ? unit * (kWidestFootprint / glm::length(unit)) : w;
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

    // Half axes of W as columns of one matrix: their singular values are the axes of the ellipse.
    glm::dvec2 a;
    glm::dvec2 b;
    if (isFinite(w1) && isFinite(w2)) {
        a = shape.toPlane(limited(w1)) / 2.0;
        b = shape.toPlane(limited(w2)) / 2.0;
    } else {
        const double widest = kWidestFootprint * std::exp2(ellipse.log2Edge) / 2;
        a = {widest, 0};
        b = {0, widest};
    }
    const double floor = std::exp2(2 * ellipse.log2Texel) / 4;
    const double trace = glm::dot(a, a) + glm::dot(b, b);
    const double cross = differenceOfProducts(a.x, b.y, a.y, b.x);
    ellipse.xx = a.x * a.x + b.x * b.x + floor;
    ellipse.xy = a.x * a.y + b.x * b.y;
    ellipse.yy = a.y * a.y + b.y * b.y + floor;
    ellipse.determinant = cross * cross + floor * trace + floor * floor;
    const Svd2 svd = svd2(a, b, cross);
    ellipse.majorAxis = svd.majorTo;
    const double major = svd.major * svd.major + floor;
    ellipse.majorSigma = std::sqrt(major);
    ellipse.minorSigma = std::sqrt(std::min(ellipse.determinant / major, major));
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
