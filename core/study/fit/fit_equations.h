// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texels that make a picture what it should be: least squares within bounds.
#pragma once

#include "core/base/face_map.h"
#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/study/fit/fit_weights.h"

#include <optional>
#include <vector>

namespace trixel {

/// Points of one face, which follow each other.
struct PointRange
{
    FaceId face{};
    std::uint32_t count = 0;
    float weight = 1; ///< of each point
};

/// Points that should see something, and the texels that they see. About 100 bytes a point and 5 to
/// 8 more a texel under its footprint.
class FitEquations
{
public:
    /// \param scene   whose levels the texels have; must outlive it
    /// \param points  those of `ranges`, one face after the other
    static Result<FitEquations> make(const FilterScene& scene,
                                     const QueryArrays& points,
                                     std::span<const PointRange> ranges,
                                     Threads threads,
                                     Progress& progress);

    /// Faces whose texels some point sees.
    std::span<const FaceId> faces() const { return m_faces; }
    /// Where the texels of a face begin among all; nothing where no point sees them.
    std::optional<std::size_t> firstTexel(FaceId face) const
    {
        const std::size_t first = m_first[face];
        return first == kNone ? std::nullopt : std::optional(first);
    }
    std::size_t texelCount() const { return m_texels; }
    std::size_t pointCount() const { return m_points; }

    struct Bounds
    {
        float least = 0;
        float most = 1;
    };

    /// Moves the texels of the free faces so that the points see what they should: conjugate
    /// gradients on the normal equations, scaled by their diagonal; after most of the steps values
    /// are brought within bounds, and those that press against them held. What is not finite,
    /// wanted or seen, is left out. Fails only when cancelled. \param wanted  of each point \param
    /// isFree  of each face \param texels  where to begin, and the answer \return        what is
    /// missing at each point, NaN where it was left out
    Result<std::vector<Quad>> solve(std::span<const Quad> wanted,
                                    const FaceMap<char>& isFree,
                                    Bounds bounds,
                                    int steps,
                                    std::vector<Quad>& texels,
                                    Threads threads,
                                    Progress& progress) const;

private:
    friend class FitSolver;
    static constexpr std::size_t kNone = SIZE_MAX;

    std::vector<WeightBlock> m_blocks;
    std::vector<std::size_t> m_blockPoint; ///< first point of each block
    std::vector<float> m_weights;          ///< of each point
    std::vector<FaceId> m_faces;
    FaceMap<std::size_t> m_first;
    FaceMap<std::uint32_t> m_count;
    std::size_t m_texels = 0;
    std::size_t m_points = 0;
};

} // namespace trixel
