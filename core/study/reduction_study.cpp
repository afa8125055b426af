// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lattice/texel.h"
#include "core/study/error_sums.h"
#include "core/study/machine.h"
#include "core/study/processor_clock.h"
#include "core/study/small_studies.h"
#include "core/study/study_signal.h"
#include "core/texture/mips.h"

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

namespace trixel {
namespace {

constexpr Level kBase{8};
constexpr int kSteps = 4;
constexpr TexelFormat kFloat{TexelType::Float, 1, std::nullopt};
constexpr TexelFormat kBytes{TexelType::UInt8, 1, std::nullopt};

/// Mean of the base's sine over each texel of a level, from 64 points a base texel: the texel cut
/// in four again and again, by the corners alone.
double meanOver(const std::array<glm::dvec2, 3>& corners, int cuts)
{
    if (cuts == 0) {
        return studySine(kBase, (corners[0] + corners[1] + corners[2]) / 3.0);
    }
    const glm::dvec2 ab = (corners[0] + corners[1]) / 2.0;
    const glm::dvec2 bc = (corners[1] + corners[2]) / 2.0;
    const glm::dvec2 ca = (corners[2] + corners[0]) / 2.0;
    return (meanOver({corners[0], ab, ca}, cuts - 1) + meanOver({ab, corners[1], bc}, cuts - 1) +
            meanOver({ca, bc, corners[2]}, cuts - 1) + meanOver({bc, ca, ab}, cuts - 1)) /
           4;
}

std::vector<float> means(Level level)
{
    const int cuts = kBase.log2() - level.log2() + 3;
    std::vector<float> values(level.texelCount());
    for (std::uint32_t t = 0; t < level.texelCount(); ++t) {
        const TexelCoord texel = texelAt(level, static_cast<TexelIndex>(t));
        values[t] = static_cast<float>(meanOver(corners(level, texel), cuts));
    }
    return values;
}

struct Rule
{
    std::string name;
    TexelFormat format;
    std::function<void(Level, std::span<const std::byte>, std::span<std::byte>)> reduce;
};

std::vector<Rule> rules()
{
    const auto by = [](const TexelFormat& format, ReductionRule rule) {
        return
            [format, rule](Level fine, std::span<const std::byte> from, std::span<std::byte> to) {
                reduceTexels(format, fine, from, to, rule);
            };
    };
    return {{"triangles, float", kFloat, by(kFloat, ReductionRule::Triangles)},
            {"triangles, uint8", kBytes, by(kBytes, ReductionRule::Triangles)},
            {"2 × 2 box, float", kFloat, by(kFloat, ReductionRule::Box)}};
}

double timed(const Rule& rule, Level fine, std::span<const std::byte> from, std::span<std::byte> to)
{
    double best = 0;
    for (int round = 0; round < 3; ++round) {
        const double begin = processorSeconds();
        rule.reduce(fine, from, to);
        const double seconds = processorSeconds() - begin;
        best = round == 0 ? seconds : std::min(best, seconds);
    }
    return 1e9 * best / fine.texelCount();
}

} // namespace

Result<Study> studyReduction(StudyWatcher& watcher)
{
    Study study;
    study.name = "reduction";
    study.title = "Halving the resolution: the rule for triangles against the 2 × 2 box";
    study.costTitle = "Time per texel read";
    study.costUnit = "ns";
    study.subject = "sine of 20 texels at level 8";
    study.conditions = toText(thisMachine()) + "; one thread's processor time, least of three";
    const std::vector<float> base = means(kBase);
    std::vector<std::vector<float>> truths;
    for (int step = 1; step <= kSteps; ++step) {
        if (!watcher.report(0.5 * step / (kSteps + 1))) {
            return cancelled();
        }
        truths.push_back(means(kBase.coarser(step)));
    }
    const std::vector<Rule> all = rules();
    for (std::size_t r = 0; r < all.size(); ++r) {
        if (!watcher.report(0.5 + 0.5 * static_cast<double>(r) / static_cast<double>(all.size()))) {
            return cancelled();
        }
        const Rule& rule = all[r];
        std::vector<std::byte> texels(kBase.texelCount() * rule.format.texelBytes());
        encode(rule.format.type, base, texels);
        for (int step = 1; step <= kSteps; ++step) {
            const Level fine = kBase.coarser(step - 1);
            std::vector<std::byte> next(fine.coarser().texelCount() * rule.format.texelBytes());
            StudyPoint point;
            point.series = rule.name;
            point.variant = std::to_string(step) + (step == 1 ? " level down" : " levels down");
            point.cost = timed(rule, fine, texels, next);
            std::vector<float> found(fine.coarser().texelCount());
            decode(rule.format.type, next, found);
            const std::vector<float>& truth = truths[static_cast<std::size_t>(step - 1)];
            ErrorSums errors;
            for (std::size_t t = 0; t < found.size(); ++t) {
                errors.add(static_cast<double>(found[t]), static_cast<double>(truth[t]), 1);
            }
            errors.tell(point);
            point.samples = errors.count();
            watcher.measured(point);
            study.points.push_back(std::move(point));
            texels = std::move(next);
        }
    }
    return study;
}

} // namespace trixel
