// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/footprint_net.h"

#include "core/filter/local_surface.h"
#include "core/filter/unfolding.h"
#include "core/footprint/covariance.h"
#include "core/footprint/limit.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <unordered_map>

namespace trixel {
namespace {

double cross(glm::dvec2 a, glm::dvec2 b)
{
    return a.x * b.y - a.y * b.x;
}

/// A scene of nothing on the faces about the first: what filters measure there.
QueryEllipse
ellipseAt(const LocalSurface& local, const TexelStore& texels, const PlacedFootprint& footprint)
{
    FaceMap<Level> levels(local.faces.size());
    for (std::size_t k = 0; k < local.faces.size(); ++k) {
        levels[faceId(k)] = texels.face(local.faces[k]).level();
    }
    constexpr TexelFormat kFormat{TexelType::Float, 1, std::nullopt};
    const float zero = 0;
    const TexelStore nothing(kFormat, levels, std::as_bytes(std::span(&zero, 1)));
    NoProgress progress;
    const std::shared_ptr<const FilterSurface> surface(std::shared_ptr<void>(), &local.surface);
    const auto scene = FilterScene::build(surface, nothing, Threads{1}, progress);
    return queryEllipse(
        *scene, local.hit, footprint.uv, footprint.footprint.w1, footprint.footprint.w2);
}

/// Puts the neighbours of the first face where they belong, as far as they are not there yet.
void addNeighbours(const LocalSurface& local, const TexelStore& texels, FootprintNet& net)
{
    const FootprintNet::Face hit = net.faces.front();
    for (const LocalEdge edge : kLocalEdges) {
        const auto across = local.surface.crossing(local.hit, edge);
        if (!across || net.indexOfFace(local.faces[indexOf(across->face)])) {
            continue;
        }
        // The crossing takes (u,v) of the first to (u,v) of the other; its inverse, the corners.
        FootprintNet::Face other;
        other.face = local.faces[indexOf(across->face)];
        other.level = texels.face(other.face).level();
        const double det = cross(across->perU, across->perV);
        constexpr std::array<glm::dvec2, 3> kCorners = {
            glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1)};
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec2 to = kCorners[k] - across->origin;
            other.corners[k] =
                hit.pointOf({cross(to, across->perV) / det, cross(across->perU, to) / det});
        }
        net.faces.push_back(other);
    }
}

void setAxes(const PlacedFootprint& footprint, FootprintNet& net)
{
    const QueryEllipse& ellipse = net.ellipse;
    net.widenedMajor = ellipse.majorSigma * ellipse.majorAxis;
    net.widenedMinor = ellipse.minorSigma * ellipse.minorAxis();
    if (!std::isfinite(net.w1.x + net.w1.y + net.w2.x + net.w2.y)) {
        net.w1 = net.w2 = glm::dvec2(0);
        net.major = net.widenedMajor;
        net.minor = net.widenedMinor;
        return;
    }
    const auto half = [&](glm::dvec2 w) {
        return net.shape.toPlane(limitedVector(w, kWidestFootprint)) / 2.0;
    };
    const CovarianceAxes axes =
        axesOf(covarianceOf(half(footprint.footprint.w1), half(footprint.footprint.w2), 0));
    net.major = axes.majorSigma * axes.majorAxis;
    net.minor = axes.minorSigma * glm::dvec2(-axes.majorAxis.y, axes.majorAxis.x);
}

} // namespace

glm::dvec2 FootprintNet::Face::uvOf(glm::dvec2 point) const
{
    const glm::dvec2 e1 = corners[1] - corners[0];
    const glm::dvec2 e2 = corners[2] - corners[0];
    const glm::dvec2 p = point - corners[0];
    const double det = cross(e1, e2);
    return {cross(p, e2) / det, cross(e1, p) / det};
}

std::optional<FootprintNet::Place> FootprintNet::placeAt(glm::dvec2 point) const
{
    constexpr double kSlack = 1e-9;
    for (std::size_t k = 0; k < faces.size(); ++k) {
        const glm::dvec2 uv = faces[k].uvOf(point);
        if (uv.x >= -kSlack && uv.y >= -kSlack && uv.x + uv.y <= 1 + kSlack) {
            return Place{k, broughtInside(uv)};
        }
    }
    return std::nullopt;
}

std::optional<std::size_t> FootprintNet::indexOfFace(FaceId face) const
{
    const auto found = std::ranges::find(faces, face, &Face::face);
    return found == faces.end() ? std::nullopt
                                : std::optional(static_cast<std::size_t>(found - faces.begin()));
}

FootprintNet footprintNet(const TriangleMesh& mesh,
                          const Adjacency& adjacency,
                          const TexelStore& texels,
                          const PlacedFootprint& footprint,
                          const NetLimits& limits)
{
    check(texels.faceCount() == mesh.faceCount(), "texels of this mesh");
    FootprintNet net;
    const LocalSurface about =
        localSurface(mesh, adjacency, footprint.face, footprint.uv, 0, limits.mostFaces);
    net.ellipse = ellipseAt(about, texels, footprint);
    net.shape = about.surface.shape(about.hit);
    net.w1 = net.shape.toPlane(footprint.footprint.w1);
    net.w2 = net.shape.toPlane(footprint.footprint.w2);
    setAxes(footprint, net);

    const LocalSurface local = localSurface(mesh,
                                            adjacency,
                                            footprint.face,
                                            net.ellipse.uv,
                                            limits.cut * net.ellipse.majorSigma,
                                            limits.mostFaces);
    net.isCut = local.isCut;
    const EllipseFrame frame(net.ellipse);
    Unfolding unfolding;
    for (const PlacedFace& place :
         unfolding.unfold(local.surface, local.hit, net.ellipse, frame, limits.cut)) {
        FootprintNet::Face face;
        face.face = local.faces[indexOf(place.face)];
        face.level = texels.face(face.face).level();
        for (std::size_t k = 0; k < 3; ++k) {
            face.corners[k] = frame.toPlane(place.corners[k]);
        }
        net.faces.push_back(face);
    }
    addNeighbours(local, texels, net);
    return net;
}

std::optional<WeightEllipse> weightEllipse(const FootprintNet& net, const Contributions& weights)
{
    std::unordered_map<std::uint32_t, std::size_t> places;
    for (std::size_t k = 0; k < net.faces.size(); ++k) {
        places.emplace(static_cast<std::uint32_t>(net.faces[k].face), k);
    }
    struct Point
    {
        glm::dvec2 at;
        double weight;
    };
    std::vector<Point> points;
    WeightEllipse result;
    glm::dvec2 sum(0);
    for (const Contribution& one : weights.texels) {
        const auto place = places.find(static_cast<std::uint32_t>(one.face));
        if (place != places.end()) {
            const glm::dvec2 at = net.faces[place->second].pointOf(centroid(one.level, one.texel));
            points.push_back({at, one.weight});
            sum += one.weight * at;
            result.placed += one.weight;
        }
    }
    if (!(result.placed > 0)) {
        return std::nullopt;
    }
    result.mean = sum / result.placed;
    double xx = 0;
    double xy = 0;
    double yy = 0;
    for (const Point& point : points) {
        const glm::dvec2 d = point.at - result.mean;
        const double w = point.weight / result.placed;
        xx += w * d.x * d.x;
        xy += w * d.x * d.y;
        yy += w * d.y * d.y;
    }
    const CovarianceAxes axes = axesOf({xx, xy, yy, std::max(xx * yy - xy * xy, 0.0)});
    result.majorSigma = axes.majorSigma;
    result.minorSigma = axes.minorSigma;
    result.majorAxis = axes.majorAxis;
    return result;
}

} // namespace trixel
