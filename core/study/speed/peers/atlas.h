// SPDX-License-Identifier: GPL-3.0-or-later
//
// The content of a subject as one picture with a place in it for every point of a face, as a
// program without Ptex would have it.
#pragma once

#include "core/study/speed/contest.h"
#include "core/study/speed/peers/peer_module.h"

#include <memory>
#include <vector>

namespace trixel {

/// Positions and derivatives in a picture, structure of arrays.
struct AtlasSamples
{
    std::vector<float> s, t, dsdx, dtdx, dsdy, dtdy;

    peers::PictureSamples samples() const
    {
        return {s.size(), s.data(), t.data(), dsdx.data(), dtdx.data(), dsdy.data(), dtdy.data()};
    }
};

class Atlas
{
public:
    virtual ~Atlas() = default;

    virtual peers::Picture picture() const = 0;
    /// What the atlas is, as notes say it: "a periodic picture of the tile, 1024 × 2048".
    virtual std::string about() const = 0;

    /// Where the footprints lie. Their ellipses have the same floor as those of the filters: the
    /// derivatives are twice the axes, so that both mean the same Gaussian.
    AtlasSamples samples(const FilterScene& scene, const FilterQueries& queries) const;

protected:
    /// \param uv   a point of the face
    virtual glm::dvec2 position(FaceId face, glm::dvec2 uv) const = 0;
    /// \param w  a vector in (u,v) of the face
    virtual glm::dvec2 vector(FaceId face, glm::dvec2 w) const = 0;
};

/// Of a patch of stored tiles, a picture of the tile, periodic: each pixel the mean of 4 × 4
/// points, two to three pixels a texel.
std::unique_ptr<const Atlas>
makePlanarAtlas(const TestData& data, TestContent content, const TestPatch& patch);

/// Of any scene, every face in a square of its own with two pixels a texel along each edge (one
/// where that would be more than 64 million in all), its values continued beyond its edges for two
/// pixels. Null where the picture would be too large even so.
std::unique_ptr<const Atlas> makeFaceAtlas(const FilterScene& scene);

} // namespace trixel
