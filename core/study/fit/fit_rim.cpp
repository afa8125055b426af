// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/fit/fit_rim.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace trixel {
namespace {

constexpr double kReachPixels = 2;
constexpr double kReachEdges = 4;

double longestEdge(const std::array<glm::vec3, 3>& c)
{
    return static_cast<double>(std::max(
        {glm::distance(c[0], c[1]), glm::distance(c[1], c[2]), glm::distance(c[2], c[0])}));
}

} // namespace

bool FitRim::contains(FaceId face) const
{
    return std::isfinite(spacing[face]);
}

FitRim fitRim(const Surface& surface, const VertexRings& rings, const FitSamples& samples)
{
    FitRim rim;
    rim.reached = FaceMap<std::vector<FaceId>>(samples.pixels.size());
    rim.spacing = FaceMap<double>(samples.pixels.size(), std::numeric_limits<double>::infinity());
    for (std::size_t f = 0; f < samples.pixels.size(); ++f) {
        const FaceId face = faceId(f);
        if (!samples.isJudged(face)) {
            continue;
        }
        std::vector<FaceId>& reached = rim.reached[face];
        const auto corners = surface.mesh().corners(face);
        const double radius =
            std::min(kReachPixels * samples.spacing[face], kReachEdges * longestEdge(corners));
        for (std::uint8_t corner = 0; corner < 3; ++corner) {
            const auto around = rings.corners(rings.ring({face, corner}));
            if (std::ranges::all_of(around,
                                    [&](const Corner& c) { return samples.isJudged(c.face); })) {
                continue; // the rim is elsewhere
            }
            surface.bvh().facesWithin(corners[corner], static_cast<float>(radius), reached);
            for (const Corner& near : around) {
                reached.push_back(near.face);
            }
        }
        std::ranges::sort(reached);
        reached.erase(std::unique(reached.begin(), reached.end()), reached.end());
        std::erase_if(reached, [&](FaceId near) { return samples.isJudged(near); });
        for (const FaceId near : reached) {
            rim.spacing[near] = std::min(rim.spacing[near], samples.spacing[face]);
        }
    }
    return rim;
}

} // namespace trixel
