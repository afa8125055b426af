// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/line_walk.h"
#include "core/filter/methods.h"
#include "core/filter/probe_plan.h"
#include "core/filter/vertex_lookup.h"

#include <cmath>

namespace trixel {
namespace {

/// Answers one group of one query.
class ProbeLine
{
public:
    ProbeLine(const FilterScene& scene, const ProbePlan& plan, int group)
        : m_scene(scene)
        , m_plan(plan)
        , m_group(group)
    {
    }

    void addSide(FaceId face, glm::dvec2 centre, double sign)
    {
        // A probe stands for the step around it, which a border may cut: up to its end.
        const double reach = m_plan.perSide;
        walkLine(m_scene.surface(), face, centre, sign * m_plan.step, reach, m_walk);
        std::size_t segment = 0;
        for (int k = 0; k < m_plan.perSide; ++k) {
            const double inside = std::min(m_walk.end - k, 1.0);
            if (!(inside > 0)) {
                break;
            }
            const double t = k + inside / 2;
            while (segment + 1 < m_walk.count && m_walk.segments[segment].end < t) {
                ++segment;
            }
            const LineSegment& within = m_walk.segments[segment];
            add(within.face,
                within.start + (t - within.begin) * within.step,
                static_cast<float>(inside) *
                    probeWeight(static_cast<float>(k) + 0.5F, m_plan.support));
        }
    }

    /// Where no probe lies on the surface.
    void addCentre(FaceId face, glm::dvec2 uv)
    {
        if (!(m_weight > 0)) {
            add(face, uv, 1);
        }
    }

    std::uint32_t result(GroupValue& value) const
    {
        for (std::size_t c = 0; c < value.size(); ++c) {
            value[c] = m_sum[c] / m_weight;
        }
        return m_taps;
    }

private:
    void add(FaceId face, glm::dvec2 uv, float weight)
    {
        m_weight += weight;
        const LevelBlend& levels = m_plan.levels;
        const bool blended = levels.coarseWeight > 0 && m_scene.level(face).log2() >= levels.fine;
        const float coarse = blended ? levels.coarseWeight : 0;
        if (coarse < 1) {
            look(face, levels.fine, uv, weight * (1 - coarse));
        }
        if (coarse > 0) {
            look(face, levels.fine - 1, uv, weight * coarse);
        }
    }

    void look(FaceId face, int level, glm::dvec2 uv, float weight)
    {
        addInterpolated(m_scene.pyramid(), face, level, m_group, uv, weight, m_sum);
        m_taps += 3;
    }

    const FilterScene& m_scene;
    const ProbePlan& m_plan;
    int m_group;
    LineWalk m_walk;
    GroupValue m_sum{};
    float m_weight = 0;
    std::uint32_t m_taps = 0;
};

class Probes final : public FilterMethod
{
public:
    explicit Probes(const ProbeSettings& settings)
        : m_settings(settings)
    {
    }

    void filter(const FilterScene& scene,
                const FilterQueries& queries,
                const FilterResults& results) const override
    {
        filterEach(scene,
                   queries,
                   results,
                   [&](const QueryEllipse& ellipse, FaceId face, int group, GroupValue& value) {
                       const ProbePlan plan =
                           probePlan(ellipse, scene.surface().shape(face), m_settings);
                       const glm::dvec2 centre(ellipse.uv);
                       ProbeLine line(scene, plan, group);
                       line.addSide(face, centre, 1);
                       line.addSide(face, centre, -1);
                       line.addCentre(face, centre);
                       const std::uint32_t taps = line.result(value);
                       const int level = std::min(plan.levels.fine, scene.level(face).log2());
                       return QueryCost{static_cast<float>(level), taps};
                   });
    }

private:
    ProbeSettings m_settings;
};

double evenCount(double most)
{
    return 2 * std::floor(most / 2);
}

MethodEntry probeEntry()
{
    MethodEntry entry;
    entry.claims = {.affineKept = Claim::Yes,
                    .rotationFree = Claim::Yes,
                    .edgeContinuous = Claim::Yes,
                    .levelContinuous = Claim::Yes};
    MethodParameter probes;
    probes.name = "probes";
    probes.meaning = "Most probes along the major axis; what they cannot span is blurred.";
    probes.least = 2;
    probes.most = 128;
    probes.standard = 32;
    probes.curve = {2, 4, 8, 16, 32, 64, 128};
    entry.parameter = probes;
    return entry;
}

} // namespace

MethodEntry probesOneLevelMethod()
{
    MethodEntry entry = probeEntry();
    entry.name = "probes-1";
    entry.title = "Probes, one level";
    entry.about = "Gaussian probes along the major axis in the conforming pyramid, at one level; "
                  "two are blended only about the switch.";
    entry.parameter->standard = 16;
    entry.make = [](double probes) -> std::unique_ptr<const FilterMethod> {
        return std::make_unique<Probes>(
            ProbeSettings{.spacing = 2.4, .band = 0.25, .most = evenCount(probes)});
    };
    return entry;
}

MethodEntry probesTwoLevelsMethod()
{
    MethodEntry entry = probeEntry();
    entry.name = "probes-2";
    entry.title = "Probes, two levels";
    entry.about = "Gaussian probes along the major axis in the conforming pyramid, two levels "
                  "blended so that the width is met.";
    entry.make = [](double probes) -> std::unique_ptr<const FilterMethod> {
        return std::make_unique<Probes>(
            ProbeSettings{.spacing = 1.4, .band = 1, .most = evenCount(probes)});
    };
    return entry;
}

} // namespace trixel
