// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/fit/fit_equations.h"

#include "core/study/fit/fit_parallel.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

namespace trixel {
namespace {

constexpr std::size_t kBlockPoints = 512;
/// The bounds are looked at in the beginning and after this part of the steps: conjugate gradients
/// gain by going on, and what presses against a bound is known only late.
constexpr double kFreely = 0.6;
using DoubleQuad = glm::dvec4;

Quad ratio(DoubleQuad a, DoubleQuad b)
{
    Quad result(0);
    for (int c = 0; c < 4; ++c) {
        result[c] = b[c] > 0 ? static_cast<float>(a[c] / b[c]) : 0.0F;
    }
    return result;
}

} // namespace

/// The state of one solution.
class FitSolver
{
public:
    FitSolver(const FitEquations& equations,
              std::span<const Quad> wanted,
              const FaceMap<char>& isFree,
              FitEquations::Bounds bounds,
              std::vector<Quad>& texels,
              Threads threads)
        : m_equations(equations)
        , m_wanted(wanted)
        , m_bounds(bounds)
        , m_texels(texels)
        , m_threads(threads)
        , m_isFree(equations.m_texels)
        , m_isHeld(equations.m_texels, glm::bvec4(false))
        , m_diagonal(equations.m_texels)
        , m_missing(equations.m_points)
        , m_seen(equations.m_points)
        , m_gradient(equations.m_texels)
        , m_direction(equations.m_texels)
        , m_parts(equations.m_blocks.size())
    {
        for (const FaceId face : equations.m_faces) {
            std::fill_n(m_isFree.begin() + static_cast<std::ptrdiff_t>(equations.m_first[face]),
                        equations.m_count[face],
                        isFree[face]);
        }
    }

    Status run(int steps, Progress& progress)
    {
        weighTexels();
        const double stages = steps + 1.0;
        const int bounded = static_cast<int>(std::lround(kFreely * steps));
        for (int step = 0; step < steps; ++step) {
            StageProgress part(progress, step / stages, (step + 1) / stages);
            if (step == 0 || step == bounded) {
                if (const Status status = begin(); !status) {
                    return status;
                }
            }
            if (!part.report(0.5)) {
                return cancelled();
            }
            if (const Status status = advance(); !status) {
                return status;
            }
            if (!part.report(1)) {
                return cancelled();
            }
        }
        bringWithinBounds();
        return measureMissing();
    }

    std::vector<Quad> takeMissing()
    {
        for (std::size_t p = 0; p < m_missing.size(); ++p) {
            for (int c = 0; c < 4; ++c) {
                if (m_leftOut.size() > p && m_leftOut[p][c]) {
                    m_missing[p][c] = std::numeric_limits<float>::quiet_NaN();
                }
            }
        }
        return std::move(m_missing);
    }

private:
    template <class Work>
    Status forBlocks(const Work& work)
    {
        // Few blocks are done sooner than a thread starts.
        constexpr std::size_t kFewBlocks = 32;
        const std::size_t blocks = m_equations.m_blocks.size();
        NoProgress progress;
        return forEachInParallel(
            blocks, blocks < kFewBlocks ? Threads{1} : m_threads, progress, work);
    }

    template <class T>
    std::span<T> pointsOf(std::vector<T>& points, std::size_t block) const
    {
        return std::span(points).subspan(m_equations.m_blockPoint[block],
                                         m_equations.m_blocks[block].pointCount());
    }

    /// seen = A · texels
    Status look(const std::vector<Quad>& texels, std::vector<Quad>& seen)
    {
        return forBlocks([&](std::size_t b) {
            const WeightBlock& block = m_equations.m_blocks[b];
            std::vector<Quad> own(block.texelCount());
            for (const TexelRange& range : block.ranges()) {
                std::copy_n(texels.begin() +
                                static_cast<std::ptrdiff_t>(m_equations.m_first[range.face]),
                            range.count,
                            own.begin() + range.first);
            }
            block.look(own, pointsOf(seen, b));
        });
    }

    /// texels = Aᵀ · weights · points, at what may move.
    Status spread(std::vector<Quad>& points, std::vector<Quad>& texels)
    {
        const Status status = forBlocks([&](std::size_t b) {
            const WeightBlock& block = m_equations.m_blocks[b];
            std::vector<Quad> weighted(block.pointCount());
            const auto from = pointsOf(points, b);
            for (std::size_t p = 0; p < weighted.size(); ++p) {
                weighted[p] = m_equations.m_weights[m_equations.m_blockPoint[b] + p] * from[p];
            }
            m_parts[b].assign(block.texelCount(), Quad(0));
            block.spread(weighted, m_parts[b]);
        });
        std::ranges::fill(texels, Quad(0));
        for (std::size_t b = 0; b < m_parts.size(); ++b) { // in order: sums must not depend on who
            for (const TexelRange& range : m_equations.m_blocks[b].ranges()) {
                Quad* to = texels.data() + m_equations.m_first[range.face];
                const Quad* part = m_parts[b].data() + range.first;
                for (std::uint32_t k = 0; k < range.count; ++k) {
                    to[k] += part[k];
                }
            }
        }
        for (std::size_t t = 0; t < texels.size(); ++t) {
            if (!(m_isFree[t] != 0 && m_diagonal[t] > 0)) {
                texels[t] = Quad(0);
            }
        }
        return status;
    }

    void weighTexels()
    {
        std::vector<float> own;
        for (std::size_t b = 0; b < m_equations.m_blocks.size(); ++b) {
            const WeightBlock& block = m_equations.m_blocks[b];
            own.assign(block.texelCount(), 0);
            block.spreadSquares(std::span(m_equations.m_weights)
                                    .subspan(m_equations.m_blockPoint[b], block.pointCount()),
                                own);
            for (const TexelRange& range : block.ranges()) {
                float* to = m_diagonal.data() + m_equations.m_first[range.face];
                for (std::uint32_t k = 0; k < range.count; ++k) {
                    to[k] += own[range.first + k];
                }
            }
        }
    }

    void bringWithinBounds()
    {
        for (std::size_t t = 0; t < m_texels.size(); ++t) {
            if (m_isFree[t] != 0) {
                for (int c = 0; c < 4; ++c) {
                    if (std::isfinite(m_texels[t][c])) {
                        m_texels[t][c] = std::clamp(m_texels[t][c], m_bounds.least, m_bounds.most);
                    }
                }
            }
        }
    }

    Status measureMissing()
    {
        const Status status = look(m_texels, m_missing);
        if (m_leftOut.empty()) {
            m_leftOut.assign(m_missing.size(), glm::bvec4(false));
        }
        for (std::size_t p = 0; p < m_missing.size(); ++p) {
            for (int c = 0; c < 4; ++c) {
                const float missing = m_wanted[p][c] - m_missing[p][c];
                m_leftOut[p][c] = m_leftOut[p][c] || !std::isfinite(missing);
                m_missing[p][c] = m_leftOut[p][c] ? 0 : missing;
            }
        }
        return status;
    }

    void holdAtBounds()
    {
        for (std::size_t t = 0; t < m_texels.size(); ++t) {
            for (int c = 0; c < 4; ++c) {
                const float value = m_texels[t][c];
                const float pull = m_gradient[t][c];
                m_isHeld[t][c] = !std::isfinite(value) || (value <= m_bounds.least && pull < 0) ||
                                 (value >= m_bounds.most && pull > 0);
            }
        }
    }

    /// Σ gradient² / diagonal; the gradient of what is held becomes 0.
    DoubleQuad strength()
    {
        DoubleQuad sum(0);
        for (std::size_t t = 0; t < m_texels.size(); ++t) {
            if (m_isFree[t] == 0 || !(m_diagonal[t] > 0)) {
                continue;
            }
            for (int c = 0; c < 4; ++c) {
                m_gradient[t][c] = m_isHeld[t][c] ? 0 : m_gradient[t][c];
            }
            sum += DoubleQuad(m_gradient[t]) * DoubleQuad(m_gradient[t] / m_diagonal[t]);
        }
        return sum;
    }

    Status begin()
    {
        bringWithinBounds();
        if (const Status status = measureMissing(); !status) {
            return status;
        }
        const Status status = spread(m_missing, m_gradient);
        holdAtBounds();
        m_strength = strength();
        turn(Quad(0));
        return status;
    }

    void turn(Quad share)
    {
        for (std::size_t t = 0; t < m_texels.size(); ++t) {
            if (m_isFree[t] != 0 && m_diagonal[t] > 0) {
                m_direction[t] = m_gradient[t] / m_diagonal[t] + share * m_direction[t];
            }
        }
    }

    Status advance()
    {
        if (const Status status = look(m_direction, m_seen); !status) {
            return status;
        }
        DoubleQuad sum(0);
        for (std::size_t p = 0; p < m_seen.size(); ++p) {
            for (int c = 0; c < 4; ++c) {
                m_seen[p][c] = m_leftOut[p][c] ? 0 : m_seen[p][c];
            }
            sum += static_cast<double>(m_equations.m_weights[p]) * DoubleQuad(m_seen[p]) *
                   DoubleQuad(m_seen[p]);
        }
        const Quad step = ratio(m_strength, sum);
        for (std::size_t t = 0; t < m_texels.size(); ++t) {
            if (m_isFree[t] != 0 && m_diagonal[t] > 0) {
                m_texels[t] += step * m_direction[t];
            }
        }
        for (std::size_t p = 0; p < m_seen.size(); ++p) {
            m_missing[p] -= step * m_seen[p];
        }
        const Status status = spread(m_missing, m_gradient);
        const DoubleQuad next = strength();
        turn(ratio(next, m_strength));
        m_strength = next;
        return status;
    }

    const FitEquations& m_equations;
    std::span<const Quad> m_wanted;
    FitEquations::Bounds m_bounds;
    std::vector<Quad>& m_texels;
    Threads m_threads;
    std::vector<char> m_isFree;
    std::vector<glm::bvec4> m_isHeld;
    std::vector<glm::bvec4> m_leftOut; ///< of each point
    std::vector<float> m_diagonal;
    std::vector<Quad> m_missing, m_seen;
    std::vector<Quad> m_gradient, m_direction;
    std::vector<std::vector<Quad>> m_parts; ///< of each block
    DoubleQuad m_strength{0};
};

Result<FitEquations> FitEquations::make(const FilterScene& scene,
                                        const QueryArrays& points,
                                        std::span<const PointRange> ranges,
                                        Threads threads,
                                        Progress& progress)
{
    FitEquations made;
    made.m_points = points.size();
    made.m_first = FaceMap<std::size_t>(scene.faceCount(), kNone);
    made.m_count = FaceMap<std::uint32_t>(scene.faceCount());
    for (const PointRange& range : ranges) {
        made.m_weights.insert(made.m_weights.end(), range.count, range.weight);
    }
    check(made.m_weights.size() == points.size(), "the points of the ranges");
    const std::size_t blocks = (points.size() + kBlockPoints - 1) / kBlockPoints;
    std::vector<std::optional<WeightBlock>> found(blocks);
    const Status status = forEachInParallel(blocks, threads, progress, [&](std::size_t b) {
        const std::size_t first = b * kBlockPoints;
        found[b].emplace(
            scene, points.queries().subspan(first, std::min(kBlockPoints, points.size() - first)));
    });
    if (!status) {
        return tl::unexpected(status.error());
    }
    for (std::size_t b = 0; b < blocks; ++b) {
        made.m_blockPoint.push_back(b * kBlockPoints);
        for (const TexelRange& range : found[b]->ranges()) {
            if (made.m_first[range.face] == kNone) {
                made.m_first[range.face] = made.m_texels;
                made.m_count[range.face] = range.count;
                made.m_texels += range.count;
                made.m_faces.push_back(range.face);
            }
        }
        made.m_blocks.push_back(std::move(*found[b]));
    }
    return made;
}

Result<std::vector<Quad>> FitEquations::solve(std::span<const Quad> wanted,
                                              const FaceMap<char>& isFree,
                                              Bounds bounds,
                                              int steps,
                                              std::vector<Quad>& texels,
                                              Threads threads,
                                              Progress& progress) const
{
    check(wanted.size() == m_points && texels.size() == m_texels, "every point and texel");
    FitSolver solver(*this, wanted, isFree, bounds, texels, threads);
    if (const Status status = solver.run(steps, progress); !status) {
        return tl::unexpected(status.error());
    }
    return solver.takeMissing();
}

} // namespace trixel
