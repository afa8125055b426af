// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which texels a filter reads for a query, and how much each counts. Every method is asked alike,
// by what it answers: a texture that is 1 in one texel and 0 everywhere else gives that texel's
// weight. So nothing here knows how a method works, and a method that comes tomorrow is shown
// truly, too. Filters are linear in the texels; weights sum to 1.
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/filter/filter_method.h"
#include "core/filter/impulses.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace trixel {

/// A texel and its share of an answer. At a level below its face's own it stands for all the texels
/// under it, and the weight is theirs together.
struct Contribution
{
    FaceId face{};
    Level level;
    TexelCoord texel;
    double weight = 0;

    bool operator==(const Contribution&) const = default;
};

struct Contributions
{
    /// Those with a weight, heaviest first; no texel lies under two of them.
    std::vector<Contribution> texels;
    double sum = 0;    ///< of all weights: 1 to rounding where everything that is read was found
    double joined = 0; ///< of the weights that stand for several texels together

    bool operator==(const Contributions&) const = default;
};

/// How far weights are looked for. What is beyond is joined into coarser texels, or refused.
struct ContributionLimits
{
    std::size_t mostTexels = 4096;                         ///< listed one by one
    std::size_t mostFaces = 2048;                          ///< looked at
    std::uint64_t mostAddressed = std::uint64_t{1} << 22U; ///< texels of those faces
};

/// Finds weights. Holds a scene of zeros beside that of the document: where nothing was asked yet
/// it costs next to nothing, and as much as the faces under the footprints where something was. One
/// per thread.
class ContributionMeter
{
public:
    /// For queries to that scene and to all of the same surface and levels: values do not matter.
    /// The scene lives on as long. Fails only when cancelled.
    static Result<ContributionMeter>
    build(const std::shared_ptr<const FilterScene>& scene, Threads threads, Progress& progress);

    /// Whether weights found here are those of that scene.
    bool fits(const FilterScene& scene) const { return m_impulses.fits(scene); }

    /// Weights of a query, each to the precision of the method's own answer.
    /// \param query  a single one (checked); its face exists
    /// \return  errors say in one sentence what is too large, or that the method refuses the query
    Result<Contributions> measure(const FilterMethod& method,
                                  const FilterQueries& query,
                                  const ContributionLimits& limits,
                                  Progress& progress);

private:
    explicit ContributionMeter(Impulses impulses)
        : m_impulses(std::move(impulses))
    {
    }

    Impulses m_impulses;
};

} // namespace trixel
