// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/ewa_plan.h"
#include "core/filter/ewa_sum.h"
#include "core/filter/exact_answer.h"
#include "core/filter/methods.h"

#include <algorithm>
#include <cmath>

namespace trixel {
namespace {

class Ewa final : public FilterMethod
{
public:
    explicit Ewa(const EwaSettings& settings)
        : m_settings(settings)
        , m_window(settings.cut)
    {
    }

    void filter(const FilterScene& scene,
                const FilterQueries& queries,
                const FilterResults& results) const override
    {
        Unfolding unfolding;
        filterEach(scene,
                   queries,
                   results,
                   [&](const QueryEllipse& ellipse, FaceId face, int group, GroupValue& value) {
                       return answer(scene, unfolding, ellipse, face, group, value);
                   });
    }

private:
    QueryCost answer(const FilterScene& scene,
                     Unfolding& unfolding,
                     const QueryEllipse& ellipse,
                     FaceId face,
                     int group,
                     GroupValue& value) const
    {
        const double cut = m_window.cut() / std::sqrt(m_window.variance());
        const GroupValue reference = referenceOf(scene, face, group);
        EwaPlan plan = planEwa(m_settings, m_window, ellipse);
        for (;;) {
            const EllipseFrame frame = plan.frame();
            const auto places =
                unfolding.unfold(scene.surface(), face, ellipse, frame, cut, m_settings.mostTaps);
            EwaSum fine(reference);
            EwaSum coarse(reference);
            if (!fine.add(scene, places, m_window, plan.fine, group, m_settings.mostTaps) ||
                (isBlended(scene, places, plan) &&
                 !coarse.add(scene, places, m_window, plan.coarse, group, m_settings.mostTaps)) ||
                fine.taps() + coarse.taps() > m_settings.mostTaps) {
                if (m_settings.atBase) {
                    return {0, kRefusedTaps};
                }
                plan.reduce();
                continue;
            }
            const bool blended = coarse.weight() > 0;
            if (!(fine.weight() > 0)) {
                // No centroid under the window, large texels amid small ones.
                return exactAnswer(scene, unfolding, ellipse, face, group, value);
            }
            for (std::size_t c = 0; c < kGroupChannels; ++c) {
                const float mean = fine.mean(c);
                value[c] = blended
                               ? mean + static_cast<float>(1 - plan.blend) * (coarse.mean(c) - mean)
                               : mean;
            }
            return {static_cast<float>(std::min(plan.fine, scene.level(face).log2())),
                    static_cast<std::uint32_t>(fine.taps() + coarse.taps())};
        }
    }

    static bool
    isBlended(const FilterScene& scene, std::span<const PlacedFace> places, const EwaPlan& plan)
    {
        return plan.blend < 1 && plan.coarse < plan.fine &&
               std::ranges::any_of(places, [&](const PlacedFace& place) {
                   return scene.level(place.face).log2() > plan.coarse;
               });
    }

    /// A value near the answer.
    static GroupValue referenceOf(const FilterScene& scene, FaceId face, int group)
    {
        GroupValue reference{};
        const float* average = scene.mips().average(face, group);
        for (std::size_t c = 0; c < kGroupChannels; ++c) {
            reference[c] = std::isfinite(average[c]) ? average[c] : 0.0F;
        }
        return reference;
    }

    EwaSettings m_settings;
    GaussianWindow m_window;
};

/// The finer the level for an ellipse, the less the window should cut off it. Below 0.5 both are
/// lowered together, so that what is cut off and what is sampled too coarsely err alike.
EwaSettings settingsOf(double sigma)
{
    EwaSettings settings;
    settings.sigma = sigma;
    settings.cut = sigma < 0.5 ? 1.5 + 3 * sigma : std::min(2.5 + sigma, 4.0);
    return settings;
}

MethodEntry baseEntry()
{
    MethodEntry entry;
    entry.claims = {
        .affineKept = Claim::Yes, .rotationFree = Claim::Yes, .edgeContinuous = Claim::Yes};
    MethodParameter sigma;
    sigma.name = "sigma";
    sigma.meaning =
        "Least standard deviation of the Gaussian, in texels of the (finer) level read.";
    sigma.least = 0.4;
    sigma.most = 2;
    sigma.standard = 1;
    sigma.curve = {0.4, 0.5, 0.7, 1, 1.4, 2};
    entry.parameter = sigma;
    return entry;
}

} // namespace

MethodEntry ewaMethod()
{
    MethodEntry entry = baseEntry();
    entry.name = "ewa";
    entry.title = "EWA on mips";
    entry.about = "A Gaussian over the texels of one level, chosen by the narrow axis.";
    entry.make = [](double sigma) -> std::unique_ptr<const FilterMethod> {
        return std::make_unique<Ewa>(settingsOf(sigma));
    };
    return entry;
}

MethodEntry ewaBlendedMethod()
{
    MethodEntry entry = baseEntry();
    entry.name = "ewa-blended";
    entry.title = "EWA on two mips";
    entry.about = "A Gaussian over the texels of two levels, blended so that nothing pops.";
    entry.parameter->curve = {0.7, 1, 1.4, 2};
    entry.claims.levelContinuous = Claim::Yes;
    entry.make = [](double sigma) -> std::unique_ptr<const FilterMethod> {
        EwaSettings settings = settingsOf(sigma);
        settings.blended = true;
        return std::make_unique<Ewa>(settings);
    };
    return entry;
}

MethodEntry ewaBaseMethod()
{
    MethodEntry entry;
    entry.name = "ewa-base";
    entry.title = "EWA at the base level";
    entry.about = "A Gaussian cut at 4 sigma over the texels of the base level: what mips save.";
    entry.claims = {.affineKept = Claim::Yes,
                    .rotationFree = Claim::Yes,
                    .edgeContinuous = Claim::Yes,
                    .levelContinuous = Claim::Yes};
    entry.make = [](double) -> std::unique_ptr<const FilterMethod> {
        EwaSettings settings;
        settings.cut = 4;
        settings.mostTaps = kMostExactTaps;
        settings.atBase = true;
        return std::make_unique<Ewa>(settings);
    };
    return entry;
}

} // namespace trixel
