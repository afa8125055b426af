// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/contributions.h"

#include <queue>

#include "core/filter/unfolding.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_set>
#include <utility>

namespace trixel {
namespace {

/// Weights are as exact as floats that sum to 1 are.
constexpr double kRounding = 2e-6;
/// Ellipses within which faces are looked for first, in standard deviations.
constexpr std::array<double, 2> kCuts = {3.0, 6.0};
/// Rings of faces beyond these: filters that know no direction read far beside a narrow ellipse.
constexpr int kMostRings = 8;
/// Texels that stay in memory from one query to the next.
constexpr std::uint64_t kMostHeld = std::uint64_t{1} << 22U;
constexpr std::size_t kQueriesBetweenReports = 32;

/// A block whose weight is known.
struct Weighed
{
    TexelBlock block;
    double weight = 0;

    bool operator<(const Weighed& other) const { return std::abs(weight) < std::abs(other.weight); }
};

/// One search.
class Search
{
public:
    Search(Impulses& impulses,
           const FilterMethod& method,
           const FilterQueries& query,
           const ContributionLimits& limits,
           Progress& progress)
        : m_impulses(impulses)
        , m_method(method)
        , m_query(query)
        , m_limits(limits)
        , m_progress(progress)
    {
    }

    Result<Contributions> run()
    {
        Status done = weighFaces();
        if (done) {
            done = refine();
        }
        if (!done) {
            return tl::unexpected(done.error());
        }
        return listed();
    }

private:
    Status weighFaces();
    Status look(std::span<const FaceId> faces);
    Status weigh(std::span<const TexelBlock> blocks);
    std::vector<FaceId> ring() const;
    Status refine();
    Contributions listed();

    Impulses& m_impulses;
    const FilterMethod& m_method;
    const FilterQueries& m_query;
    ContributionLimits m_limits;
    Progress& m_progress;

    std::unordered_set<std::uint32_t> m_seen;
    std::vector<FaceId> m_faces; // the same, in the order they were looked at
    std::uint64_t m_addressed = 0;
    double m_sum = 0; // of what the faces weigh
    std::size_t m_queries = 0;
    std::priority_queue<Weighed> m_joined; // that stand for several texels
    std::vector<Weighed> m_single;
};

/// Adds what each weighs to the texels that have a weight.
Status Search::weigh(std::span<const TexelBlock> blocks)
{
    if (m_queries++ % kQueriesBetweenReports == 0) {
        const double done =
            static_cast<double>(m_single.size()) / static_cast<double>(m_limits.mostTexels);
        if (!m_progress.report(std::min(done, 1.0))) {
            return cancelled();
        }
    }
    const auto answers = m_impulses.answers(m_method, m_query, blocks);
    if (!answers) {
        return contentsError("The method refuses a footprint that is so wide.");
    }
    for (std::size_t k = 0; k < blocks.size(); ++k) {
        const double weight = (*answers)[k];
        if (weight == 0) {
            continue;
        }
        m_sum += blocks[k].level == Level(0) ? weight : 0;
        if (blocks[k].level < m_impulses.scene().level(blocks[k].face)) {
            m_joined.push({blocks[k], weight});
        } else {
            m_single.push_back({blocks[k], weight});
        }
    }
    return {};
}

Status Search::look(std::span<const FaceId> faces)
{
    std::vector<TexelBlock> blocks;
    for (std::size_t k = 0; k < faces.size(); ++k) {
        if (m_seen.insert(static_cast<std::uint32_t>(faces[k])).second) {
            m_addressed += m_impulses.scene().level(faces[k]).texelCount();
            m_faces.push_back(faces[k]);
            blocks.push_back({faces[k], Level(0), {}});
        }
        if (m_faces.size() > m_limits.mostFaces || m_addressed > m_limits.mostAddressed) {
            return contentsError(m_faces.size() > m_limits.mostFaces
                                     ? "The footprint reaches more than " +
                                           std::to_string(m_limits.mostFaces) +
                                           " faces: too many to weigh their texels."
                                     : "The faces under the footprint hold more than " +
                                           std::to_string(m_limits.mostAddressed) +
                                           " texels: too many to weigh them.");
        }
        if (blocks.size() == kGroupChannels || (k + 1 == faces.size() && !blocks.empty())) {
            if (const Status weighed = weigh(blocks); !weighed) {
                return weighed;
            }
            blocks.clear();
        }
    }
    return {};
}

/// The faces that share a vertex with those seen so far.
std::vector<FaceId> Search::ring() const
{
    const VertexRings& rings = m_impulses.scene().surface().rings();
    std::vector<FaceId> faces;
    for (const FaceId face : m_faces) {
        for (std::uint8_t corner = 0; corner < 3; ++corner) {
            for (const Corner& other : rings.corners(rings.ring({face, corner}))) {
                faces.push_back(other.face);
            }
        }
    }
    return faces;
}

/// Faces under the ellipse first; others until the weights found sum to 1.
Status Search::weighFaces()
{
    const auto isComplete = [this] { return std::abs(m_sum - 1) <= kRounding; };
    const FilterScene& scene = m_impulses.scene();
    const QueryEllipse ellipse = queryEllipse(scene, m_query, 0);
    const EllipseFrame frame(ellipse);
    Unfolding unfolding;
    for (const double cut : kCuts) {
        std::vector<FaceId> faces;
        for (const PlacedFace& place : unfolding.unfold(scene.surface(),
                                                        m_query.face.front(),
                                                        ellipse,
                                                        frame,
                                                        cut,
                                                        m_limits.mostFaces + 1)) {
            faces.push_back(place.face);
        }
        if (const Status looked = look(faces); !looked || isComplete()) {
            return looked;
        }
    }
    for (int k = 0; k < kMostRings; ++k) {
        const std::size_t before = m_faces.size();
        if (const Status looked = look(ring()); !looked || isComplete()) {
            return looked;
        }
        if (m_faces.size() == before) {
            break;
        }
    }
    return {};
}

/// The heaviest first, as long as there is room for four in the place of one.
Status Search::refine()
{
    while (!m_joined.empty() && m_joined.size() + m_single.size() + 3 <= m_limits.mostTexels) {
        const TexelBlock block = m_joined.top().block;
        m_joined.pop();
        if (const Status weighed = weigh(finerBlocks(block)); !weighed) {
            return weighed;
        }
    }
    return {};
}

Contributions Search::listed()
{
    Contributions result;
    const auto add = [&](const Weighed& one) {
        const TexelBlock& block = one.block;
        result.texels.push_back(
            {block.face, block.level, texelAt(block.level, block.pixel), one.weight});
        result.sum += one.weight;
    };
    for (; !m_joined.empty(); m_joined.pop()) {
        add(m_joined.top());
    }
    result.joined = result.sum;
    for (const Weighed& one : m_single) {
        add(one);
    }
    std::ranges::stable_sort(result.texels, [](const Contribution& a, const Contribution& b) {
        return std::abs(a.weight) > std::abs(b.weight);
    });
    return result;
}

} // namespace

Result<ContributionMeter> ContributionMeter::build(const std::shared_ptr<const FilterScene>& scene,
                                                   Threads threads,
                                                   Progress& progress)
{
    auto impulses = Impulses::build(scene, threads, progress);
    if (!impulses) {
        return tl::unexpected(impulses.error());
    }
    return ContributionMeter(std::move(*impulses));
}

Result<Contributions> ContributionMeter::measure(const FilterMethod& method,
                                                 const FilterQueries& query,
                                                 const ContributionLimits& limits,
                                                 Progress& progress)
{
    check(query.size() == 1, "a single query");
    if (m_impulses.heldTexels() > kMostHeld) {
        m_impulses.forget();
    }
    return Search(m_impulses, method, query, limits, progress).run();
}

} // namespace trixel
