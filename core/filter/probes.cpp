// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/methods.h"
#include "core/filter/probe_simd.h"

namespace trixel {
namespace {

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
        filterByProbes(scene, queries, m_settings, results);
    }

private:
    ProbeSettings m_settings;
};

int evenCount(double most)
{
    return 2 * static_cast<int>(most / 2);
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
    probes.meaning = "Most probes on a line along the footprint; what they cannot span is blurred.";
    probes.least = 2;
    probes.most = kMostProbes;
    probes.standard = 32;
    probes.curve = {2, 4, 8, 16, 24, 32, 64, 128};
    entry.parameter = probes;
    return entry;
}

} // namespace

MethodEntry probesOneLevelMethod()
{
    MethodEntry entry = probeEntry();
    entry.name = "probes-1";
    entry.title = "Probes, one level";
    entry.about = "Gaussian probes on one or two lines in the conforming pyramid, at one level; "
                  "two are blended only about the switch.";
    entry.parameter->standard = 24;
    entry.make = [](double probes) -> std::unique_ptr<const FilterMethod> {
        return std::make_unique<Probes>(probeSettings(evenCount(probes), 0.4));
    };
    return entry;
}

MethodEntry probesTwoLevelsMethod()
{
    MethodEntry entry = probeEntry();
    entry.name = "probes-2";
    entry.title = "Probes, two levels";
    entry.about = "Gaussian probes on one or two lines in the conforming pyramid, two levels "
                  "blended so that the width is met.";
    entry.make = [](double probes) -> std::unique_ptr<const FilterMethod> {
        return std::make_unique<Probes>(probeSettings(evenCount(probes), 1));
    };
    return entry;
}

} // namespace trixel
