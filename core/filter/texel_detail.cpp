// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/texel_detail.h"

#include <algorithm>
#include <array>

namespace trixel {
namespace {

/// The texel that a point lies in, and its neighbours.
struct TexelCell
{
    std::uint32_t own = 0;                ///< packed index
    std::array<std::int64_t, 3> across{}; ///< opposite to each vertex; negative: another face
};

TexelCell cellAt(glm::dvec2 uv, std::int32_t resolution)
{
    const std::int32_t last = resolution - 1;
    const double x = uv.x * resolution;
    const double y = uv.y * resolution;
    const std::int32_t i = std::clamp(static_cast<std::int32_t>(x), 0, last);
    const std::int32_t j = std::clamp(static_cast<std::int32_t>(y), 0, last - i);
    const auto lower = [&](std::int32_t a, std::int32_t b) {
        return a + std::int64_t{b} * resolution;
    };
    const auto upper = [&](std::int32_t a, std::int32_t b) {
        const std::int64_t size = resolution;
        return a >= 0 && b >= 0 && a + b < last ? size * size - 1 - (b + a * size) : -1;
    };
    if (i + j<last&& static_cast<float>(x - i) + static_cast<float>(y - j)> 1.0F) {
        return {static_cast<std::uint32_t>(upper(i, j)),
                {lower(i + 1, j), lower(i, j), lower(i, j + 1)}};
    }
    return {static_cast<std::uint32_t>(lower(i, j)),
            {upper(i, j), upper(i - 1, j), upper(i, j - 1)}};
}

/// Takes the share of the texels from one probe's vertices.
/// \param share  of the probe's weight
/// \return       texels that are read
std::size_t shareOut(const TexelCell& cell,
                     float share,
                     const std::array<float*, 3>& vertices,
                     TexelReads& reads,
                     std::size_t k)
{
    std::array<std::size_t, 3> order = {0, 1, 2};
    const auto put = [&](std::size_t a, std::size_t b) {
        if (*vertices[order[a]] < *vertices[order[b]]) {
            std::swap(order[a], order[b]);
        }
    };
    put(0, 1);
    put(1, 2);
    put(0, 1);
    float& p = *vertices[order[0]];
    float& q = *vertices[order[1]];
    float& r = *vertices[order[2]];
    const float middle = share * q; // their weights times the probe's
    const float least = share * r;
    const std::int64_t across = cell.across[order[2]];
    const bool inside = across >= 0;
    reads.own[k] = cell.own;
    reads.other[k] = inside ? static_cast<std::uint32_t>(across) : cell.own;
    reads.ownWeight[k] = inside ? middle + 2 * least : 3 * least;
    reads.otherWeight[k] = inside ? middle - least : 0.0F;
    const float ofMiddle = inside ? middle : least;
    p -= ofMiddle;
    q -= ofMiddle;
    r -= least;
    return inside ? 2 : 1;
}

} // namespace

std::size_t findTexels(const ProbeArrays& probes,
                       const ProbeRange& range,
                       VertexWeights weights,
                       std::size_t at,
                       TexelReads& reads)
{
    const double* scales = probes.scale + range.first;
    const double* u = probes.u + range.first;
    const double* v = probes.v + range.first;
    const double fine = Level(range.fine).resolution();
    std::size_t count = 0;
    for (std::size_t k = 0; k < range.count; ++k) {
        if (scales[k] < fine) {
            const auto resolution = static_cast<std::int32_t>(scales[k]);
            const float share = 2 * scales[k] < fine ? 1.0F : 1.0F - range.coarse;
            count += shareOut(cellAt({u[k], v[k]}, resolution),
                              share,
                              {weights.first + k, weights.second + k, weights.third + k},
                              reads,
                              at + k);
        } else {
            reads.own[at + k] = reads.other[at + k] = 0;
            reads.ownWeight[at + k] = reads.otherWeight[at + k] = 0;
        }
    }
    return count;
}

} // namespace trixel
