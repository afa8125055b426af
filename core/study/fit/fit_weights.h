// SPDX-License-Identifier: GPL-3.0-or-later
//
// What points of a surface see of its texels, as weights: the sums of `exact`, kept, so that
// texels can be looked for that make them what they should be.
#pragma once

#include "core/filter/filter_queries.h"
#include "core/filter/filter_scene.h"

#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

namespace trixel {

/// Four channels of a texel or of what a point sees.
using Quad = glm::vec4;

/// The texels of some faces, joined.
struct TexelRange
{
    FaceId face{};
    std::uint32_t first = 0; ///< of the face's texels among them
    std::uint32_t count = 0;
};

/// Weights of the texels that some points see. The texels are numbered within the block.
class WeightBlock
{
public:
    /// The Gaussian is cut at 3.5 standard deviations (0.2 % of it lie beyond). A point that sees
    /// no texel there takes the nearest, like `exact`. Only the levels of the scene are read.
    WeightBlock(const FilterScene& scene, const FilterQueries& points);

    std::size_t pointCount() const { return m_begin.size() - 1; }
    std::uint32_t texelCount() const { return m_texels; }
    /// Where the numbered texels come from, in the order of their numbers.
    std::span<const TexelRange> ranges() const { return m_ranges; }

    /// seen[p] = Σ weight · texels. \param texels, seen  as many as there are (checked)
    void look(std::span<const Quad> texels, std::span<Quad> seen) const;
    /// The transposed sum: texels += Σ weight · points.
    void spread(std::span<const Quad> points, std::span<Quad> texels) const;
    /// texels += Σ weight² · points.
    void spreadSquares(std::span<const float> points, std::span<float> texels) const;

private:
    /// Texels that follow each other.
    struct Run
    {
        std::uint32_t first = 0;
        std::uint32_t count = 0;
    };
    class Builder;

    std::vector<TexelRange> m_ranges;
    std::uint32_t m_texels = 0;
    std::vector<std::uint32_t> m_begin = {0}; ///< runs of point p from begin[p] to begin[p + 1]
    std::vector<Run> m_runs;
    std::vector<float> m_weights; ///< run after run
};

} // namespace trixel
